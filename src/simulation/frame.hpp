// SPDX-License-Identifier: Apache-2.0
// A frame: the particles of a run at one instant, on the host, in SI units. Every frame has the
// named columns of `Frame`, which analyses read; those of pieces are empty in formulations without
// bonds. `columns` holds the further fields that the tables of fields show (particles/fields.hpp,
// standard/solid_show.hpp).
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace kerf {

enum class Category : std::uint8_t { water = 0, solid = 1, fractured = 2, rigid = 3 };

// One named column over particles; `values` holds `components` numbers per particle, row by row.
struct Column {
  std::string name;
  std::string unit;
  int components = 1;
  std::vector<float> values;
  std::string label{};  // label of the column; empty = its name
};

// What a frame holds: everything that is shown, or what the verdict on a cut needs
// (analysis/cut.hpp).
enum class FrameContent : std::uint8_t { everything, cut };

struct Frame {
  int dimension = 2;
  double time = 0.0;  // s
  std::uint64_t step = 0;
  std::vector<std::array<double, 3>> position;  // m
  std::vector<std::array<double, 3>> velocity;  // m/s
  std::vector<Category> category;
  std::vector<std::uint32_t> id;
  std::vector<std::uint16_t> source;   // index of the body, or bodies.size() + index of the jet
  std::vector<float> spacing;          // m
  std::vector<float> mass;             // kg (2D: kg/m)
  std::vector<float> density;          // kg/m^3
  std::vector<float> pressure;         // Pa
  std::vector<std::uint8_t> upstream;  // 1 = jet water still inside the nozzle
  // Particles of solids that unbroken bonds join, directly or through others, have the same number
  // in `piece`: the smallest id among them. Bonds to other bodies do not count in `body_piece`.
  std::vector<std::uint32_t> piece, body_piece;
  // The symmetry planes across which bonds join the piece within the body to its mirror image, as
  // bits in the order x-, x+, y-, y+, z-, z+; empty without such planes.
  std::vector<std::uint8_t> joined_planes;
  std::vector<Column> columns;  // tensors as xx yy zz xy yz xz
};

// Calls visit(name, unit, values) for the columns that every frame has besides the position.
template <class AnyFrame, class Visit>
void for_each_column(AnyFrame& frame, const Visit& visit) {
  visit("velocity", "m/s", frame.velocity);
  visit("category", "1", frame.category);
  visit("id", "1", frame.id);
  visit("source", "1", frame.source);
  visit("spacing", "m", frame.spacing);
  visit("mass", frame.dimension == 2 ? "kg/m" : "kg", frame.mass);
  visit("density", "kg/m3", frame.density);
  visit("pressure", "Pa", frame.pressure);
  visit("upstream", "1", frame.upstream);
}

// Calls visit(name, unit, values) for the columns of the pieces of solids with bonds.
template <class AnyFrame, class Visit>
void for_each_piece_column(AnyFrame& frame, const Visit& visit) {
  visit("piece", "1", frame.piece);
  visit("body_piece", "1", frame.body_piece);
  visit("joined_planes", "1", frame.joined_planes);
}

// Returns the further column of that name, or null.
inline const Column* find_column(const Frame& frame, const std::string& name) {
  for (const Column& column : frame.columns)
    if (column.name == name) return &column;
  return nullptr;
}

}  // namespace kerf
