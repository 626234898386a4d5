// SPDX-License-Identifier: Apache-2.0
// The axis of a jet gives positions as depth along the jet and distance across it.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/jet_direction.hpp"
#include "geometry/nozzle.hpp"
#include "model/jet.hpp"

namespace kerf {

struct JetAxis {
  using Vector3 = std::array<double, 3>;

  Vector3 aim{};       // m, the point of the axis from which depths count, where cuts begin
  Vector3 along{};     // unit, direction of the water
  Vector3 across{};    // unit, in the plane of the jet and the vertical; x for a jet straight down
  Vector3 sideways{};  // unit, along x across; 3D only
  double width = 0.0;  // m, slot width in 2D, diameter in 3D
  double standoff = 0.0;    // m
  double section = 0.0;     // m^2 (2D: m), area of the nozzle
  Vector3 travel{};         // m/s, of the nozzle, at right angles to the jet
  double moves_from = 0.0;  // s, when it begins to travel, or comes over the workpiece

  JetAxis(const Jet& jet, int dimension)
      : aim(jet.position), width(jet.width), standoff(jet.standoff) {
    const JetAxes axes = axes_of(jet);
    along = axes.along;
    across = axes.across;
    if (dimension == 3) sideways = axes.sideways;
    section = nozzle_area(jet, dimension);
    double along_jet = 0.0;
    for (std::size_t a = 0; a < 3; ++a) along_jet += jet.traverse[a] * along[a];
    for (std::size_t a = 0; a < 3; ++a) travel[a] = jet.traverse[a] - along_jet * along[a];
    for (std::size_t a = 0; a < 3; ++a) aim[a] += jet.time_beside * travel[a];
    moves_from = jet.start + jet.dwell + jet.time_beside;
  }

  // Returns a position relative to the point where the axis was nearest to it until `time`, s,
  // moved back to the initial axis. For a nozzle at rest it is the position itself.
  Vector3 swept(const Vector3& x, double time) const {
    double way = 0.0, square = 0.0;
    for (std::size_t a = 0; a < 3; ++a) {
      way += (x[a] - aim[a]) * travel[a];
      square += travel[a] * travel[a];
    }
    if (square == 0.0) return x;
    const double nearest = std::clamp(way / square, 0.0, std::max(0.0, time - moves_from));
    Vector3 moved = x;
    for (std::size_t a = 0; a < 3; ++a) moved[a] -= nearest * travel[a];
    return moved;
  }

  // Returns the point of the axis at a depth, m, and a time, s.
  Vector3 point_at(double depth, double time) const {
    Vector3 x = aim;
    for (std::size_t a = 0; a < 3; ++a)
      x[a] += depth * along[a] + std::max(0.0, time - moves_from) * travel[a];
    return x;
  }

  // m, positive below the aimed point.
  double depth(const Vector3& x) const { return project(x, along); }
  // m, signed.
  double offset(const Vector3& x) const { return project(x, across); }
  // m, signed; 0 in 2D.
  double side(const Vector3& x) const { return project(x, sideways); }
  // m, from the axis.
  double distance(const Vector3& x) const { return std::hypot(offset(x), side(x)); }

 private:
  double project(const Vector3& x, const Vector3& direction) const {
    double sum = 0.0;
    for (std::size_t a = 0; a < 3; ++a) sum += (x[a] - aim[a]) * direction[a];
    return sum;
  }
};

}  // namespace kerf
