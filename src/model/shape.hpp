// SPDX-License-Identifier: Apache-2.0
// This header declares a region of space as a case describes it, as plain data in SI units.
// geometry/shapes.hpp determines which points lie in it.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "model/mesh_shape.hpp"
#include "model/point.hpp"

namespace kerf {

struct Box {
  Point minimum{};  // m
  Point maximum{};  // m
  bool operator==(const Box&) const = default;
};

// Sides of a box, such as those of the domain that are symmetry planes.
struct Faces {
  std::array<bool, 3> minimum{};  // x-, y-, z-
  std::array<bool, 3> maximum{};  // x+, y+, z+
  bool any() const { return *this != Faces{}; }
  bool operator==(const Faces&) const = default;
};
inline constexpr std::array<std::string_view, 6> face_words{"x-", "x+", "y-", "y+", "z-", "z+"};

// A region of space. `kind` selects which members hold.
//   box       minimum, maximum
//   disc      centre, radius; in 3D a cylinder along `axis` from `centre` with `length`
//   ring      centre, radius (outer), inner_radius; in 3D a tube along `axis` with `length`
//   polygon   vertices in (x, y); in 3D an extrusion from z = depth_minimum to depth_maximum
//   sphere    centre, radius (3D only)
//   join      the points in any of `parts`           (case files spell it "union")
//   difference  the points in parts[0] and in no other part
//   mesh      what the surface of `mesh` encloses (3D only)
struct Shape {
  enum class Kind { box, disc, ring, polygon, sphere, join, difference, mesh };
  Kind kind = Kind::box;
  Box box;
  Point centre{};
  Point axis{0.0, 0.0, 1.0};                    // unit vector
  double radius = 0.0;                          // m
  double inner_radius = 0.0;                    // m
  double length = 0.0;                          // m
  std::vector<std::array<double, 2>> vertices;  // m
  double depth_minimum = 0.0;                   // m
  double depth_maximum = 0.0;                   // m
  std::vector<Shape> parts;
  MeshShape mesh;
  bool operator==(const Shape&) const = default;
};
inline constexpr std::array<std::string_view, 8> shape_words{
    "box", "disc", "ring", "polygon", "sphere", "union", "difference", "mesh"};

}  // namespace kerf
