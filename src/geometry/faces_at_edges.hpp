// SPDX-License-Identifier: Apache-2.0
// FacesAtEdges finds the face of a wall particle, also of one at an edge, which is as far from one
// face as from another, or at a corner of three faces (docs/theory/riemann_sph.md). Neither the
// order of the faces nor rounding decides there, so that a wall that is moved, turned or mirrored
// has the faces that go with it.
#pragma once

#include <optional>
#include <vector>

#include "geometry/level_curve.hpp"
#include "geometry/nearest_face.hpp"

namespace kerf {

class FacesAtEdges {
 public:
  // `spacing`, m: of the particles.
  FacesAtEdges(const CoveredShape& region, double spacing, int dimension)
      : region_(region), spacing_(spacing), dimension_(dimension) {}

  // Returns the nearest face of a particle. Of faces that are equally far it is the one that goes
  // on much farther, along which water is led; otherwise two of them, or none of three.
  std::optional<NearestFace> face_of(const Point& point) const;

 private:
  std::vector<NearestFace> equally_far(const Point& point) const;
  void add_tied(const Point& point, const Point& probe, std::vector<NearestFace>& faces) const;
  double length_from_edge(const Point& edge, const std::vector<NearestFace>& faces,
                          std::size_t which) const;

  const CoveredShape& region_;
  double spacing_;
  int dimension_;
};

}  // namespace kerf
