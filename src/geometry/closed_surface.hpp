// SPDX-License-Identifier: Apache-2.0
// ClosedSurface is the region that a closed surface of triangles encloses.
//
// A point is inside if the winding number of the surface about it is not 0: along a ray from the
// point, triangles that are crossed from inside count +1 and those crossed from outside -1.
// Overlapping shells are thus one region, shells that face inwards are voids, and the orientation
// of the complete surface does not matter.
//
// Rays that hit an edge or a corner need no special treatment. The side of the ray on which an edge
// lies depends on the edge alone, so the two triangles that share it agree. For a closed surface
// the sum is then exact except for rounding in whether a triangle is ahead of the point or behind
// it. That is uncertain only next to the surface, where a test of the distance precedes the rays.
#pragma once

#include <cstddef>
#include <memory>

#include "geometry/triangle_mesh.hpp"
#include "model/shape.hpp"

namespace kerf {

class ClosedSurface {
 public:
  // The point of a triangle that is nearest to some point, and the normal of the triangle.
  struct Foot {
    Point point{};   // m
    Point normal{};  // unit vector
  };
  // `mesh` must be closed: find_opening(mesh) is empty.
  explicit ClosedSurface(TriangleMesh mesh);
  ~ClosedSurface();
  ClosedSurface(const ClosedSurface&) = delete;
  ClosedSurface& operator=(const ClosedSurface&) = delete;

  // Returns whether the point is inside or on the surface, to within 1e-6 of the longest edge of
  // the box, because files hold seven digits.
  bool contains(const Point& point) const;
  // Returns the feet of the point on the triangles that come within `reach` (m) along each axis.
  std::vector<Foot> feet(const Point& point, double reach) const;
  const Box& box() const { return box_; }
  std::size_t triangles() const { return mesh_.triangles.size(); }
  const TriangleMesh& mesh() const { return mesh_; }
  // Returns the volume by the divergence theorem, m^3; overlapping shells count separately.
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

// Scales the mesh, rotates it about x, y and z in this order, and translates it. Quarter turns are
// exact.
void place_mesh(TriangleMesh& mesh, const MeshShape& shape);

}  // namespace kerf
