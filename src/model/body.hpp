// SPDX-License-Identifier: Apache-2.0
// This header declares a body of a case as plain data in SI units.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/shape.hpp"

namespace kerf {

enum class Role { elastic, water, rigid };
inline constexpr std::array<std::string_view, 3> role_words{"elastic", "water", "rigid"};
enum class Lattice { square, hexagonal };  // square is cubic in 3D
inline constexpr std::array<std::string_view, 2> lattice_words{"square", "hexagonal"};

// Which layer of a rigid body repels, eq. (43): the outermost one towards a side, or every side.
enum class RepellingLayer { top, bottom, left, right, front, back, all };
inline constexpr std::array<std::string_view, 7> repelling_layer_words{
    "top", "bottom", "left", "right", "front", "back", "all"};

// The grading of a body: its spacing doubles at the distances width, 2 width, ... from `around`, or
// from the water of the jets.
struct Grading {
  int levels = 0;               // the most doublings; 0 = the spacing is uniform
  double width = 0.0;           // m
  std::optional<Shape> around;  // distances are from its bounding box; none = from the jets
  // The axis of a jet of the case, used where `around` is none.
  struct Line {
    Point origin{}, direction{};  // m, unit vector
    double radius = 0.0;          // m
    Point sweep{};  // unit vector along which the axis sweeps a plane; 0 = the axis is at rest
    bool operator==(const Line&) const = default;
  };
  std::vector<Line> lines;
  bool operator==(const Grading&) const = default;
};

struct Body {
  std::string name;
  Role role = Role::elastic;
  int material = -1;  // index into Case::materials; -1 for rigid
  Shape shape;
  double spacing = 0.0;  // m
  Lattice lattice = Lattice::square;
  double lattice_angle = 0.0;          // rad, about z, counterclockwise, of the lattice
  bool lattice_follows_faces = false;  // whether the angle follows from the shape
  std::string
      lattice_of;   // name of the body whose angle the lattice has; empty = joined_to, or own
  Point offset{};   // m, shift of the lattice origin, along the axes of the lattice
  Grading grading;  // `spacing` is the finest
  bool body_fitted = false;  // the outermost particles lie along slanted and round faces
  double jitter = 0.0;       // the largest displacement from the lattice over the spacing
  std::uint64_t seed = 1;    // of the random numbers of this body
  std::array<std::string, 3> velocity{"0", "0", "0"};  // m/s, expressions in x, y, z (m)
  double pressure = 0.0;                               // Pa, initial, of water
  bool fixed = false;
  // Prescribed displacement from the initial position, m, expressions in t (s); empty = free.
  std::array<std::string, 3> displacement;
  Faces absorbing;        // sides that absorb outgoing waves (elastic only)
  std::string joined_to;  // name of a body this one is bonded to; empty = its own piece
  // Rigid bodies only, eq. (43).
  RepellingLayer repelling_layer = RepellingLayer::top;
  double repulsion = 0.0;                                     // D, m^2/s^2
  double friction = std::numeric_limits<double>::infinity();  // 1; infinity: the other decides
  bool operator==(const Body&) const = default;
};

}  // namespace kerf
