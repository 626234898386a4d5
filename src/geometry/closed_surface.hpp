// SPDX-License-Identifier: Apache-2.0
// What is inside a closed surface of triangles.
//
// A point is inside where the surface winds around it: along a ray from the point, triangles that
// are crossed from inside count +1 and those crossed from outside -1, and the sum is not 0. Shells
// that overlap are thus one region, shells that face inwards are voids, and it does not matter
// which way the whole faces.
//
// Rays that hit an edge or a corner need no care. An edge is to one side of the ray by a formula
// that depends on the edge alone, so the two triangles that share it agree; of a closed surface the
// sum is then right but for rounding in whether a triangle is ahead of the point or behind it. That
// is in doubt only next to the surface, where the distance decides before any ray is sent.
#pragma once

#include <cstddef>
#include <memory>

#include "geometry/triangle_mesh.hpp"
#include "model/case.hpp"

namespace kerf {

class ClosedSurface {
 public:
  // The mesh must be closed: find_opening() of it is empty.
  explicit ClosedSurface(TriangleMesh mesh);
  ~ClosedSurface();
  ClosedSurface(const ClosedSurface&) = delete;
  ClosedSurface& operator=(const ClosedSurface&) = delete;

  // True inside and on the surface, to within 1e-6 of the longest edge of the box: files hold seven
  // digits.
  bool contains(const Point& point) const;
  const Box& box() const { return box_; }
  std::size_t triangles() const { return mesh_.triangles.size(); }
  // m^3, by the divergence theorem; what shells share counts for each.
  double volume() const;

 private:
  struct Tree;
  bool is_on_surface(const Point& point) const;
  int winding(const Point& point) const;

  TriangleMesh mesh_;
  Box box_;
  double slack_ = 0.0;  // m
  std::unique_ptr<const Tree> tree_;
};

// Scaled, turned about x, y and z in this order, then moved. Exact for quarter turns.
void place_mesh(TriangleMesh& mesh, const MeshShape& shape);

}  // namespace kerf
