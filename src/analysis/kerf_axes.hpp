// SPDX-License-Identifier: Apache-2.0
// The axes of a kerf give positions across it, along it and down it. They follow a moving nozzle.
#pragma once

#include <array>
#include <cmath>

#include "analysis/jet_axis.hpp"

namespace kerf {

// The plane of the cut contains the jet and the direction in which the nozzle travels. Local
// positions are measured from the initial aim point. In 2D there is no lengthwise direction: a
// moving nozzle moves crosswise.
struct KerfAxes {
  using Vector3 = std::array<double, 3>;
  enum Local : std::size_t { crosswise, lengthwise, depthwise };

  JetAxis jet;
  Vector3 unit_crosswise{};   // at right angles to the plane of the cut; JetAxis::across if still
  Vector3 unit_lengthwise{};  // direction of the nozzle; JetAxis::sideways if it is at rest
  Vector3 travel{};           // m/s, local; component of the traverse at right angles to the jet

  KerfAxes(const JetAxis& axis, const Vector3& traverse, int dimension)
      : jet(axis), unit_crosswise(axis.across), unit_lengthwise(axis.sideways) {
    const double across = dot(traverse, axis.across), aside = dot(traverse, axis.sideways);
    const double speed = dimension == 3 ? std::hypot(across, aside) : 0.0;
    if (dimension == 2) travel = {across, 0.0, 0.0};
    if (speed <= 0.0) return;
    travel = {0.0, speed, 0.0};
    for (std::size_t a = 0; a < 3; ++a) {
      unit_lengthwise[a] = (across * axis.across[a] + aside * axis.sideways[a]) / speed;
      unit_crosswise[a] = (aside * axis.across[a] - across * axis.sideways[a]) / speed;
    }
  }

  // Returns the position of the axis at depth 0 at a time, s, m local.
  Vector3 way(double time) const {
    const double since = time > jet.moves_from ? time - jet.moves_from : 0.0;
    return {travel[0] * since, travel[1] * since, travel[2] * since};
  }
  bool moves() const { return travel[crosswise] != 0.0 || travel[lengthwise] != 0.0; }

  Vector3 local(const Vector3& x) const {
    Vector3 from_aim{};
    for (std::size_t a = 0; a < 3; ++a) from_aim[a] = x[a] - jet.aim[a];
    return turned(from_aim);
  }
  // Returns the local components of a vector such as a velocity.
  Vector3 turned(const Vector3& v) const {
    return {dot(v, unit_crosswise), dot(v, unit_lengthwise), dot(v, jet.along)};
  }

  static double dot(const Vector3& a, const Vector3& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }
};

}  // namespace kerf
