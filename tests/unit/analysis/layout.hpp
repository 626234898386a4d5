// SPDX-License-Identifier: Apache-2.0
// Artificial cases and frames with known results: a block below y = 0 and a jet from above.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "analysis/jet_axis.hpp"
#include "model/case.hpp"
#include "simulation/frame.hpp"

namespace kerf::layout {

inline constexpr double mm = 1e-3;
inline constexpr double solid_spacing = 2.0 * mm;
inline constexpr double water_spacing = 1.0 * mm;
inline constexpr double jet_width = 10.0 * mm;
inline constexpr double thickness = 50.0 * mm;

using Position = std::array<double, 3>;

// A jet of 10 mm that aims at the origin and one elastic body without a shape: the frames below
// define its particles.
inline Case make_case(int dimension, double angle = 0.0) {
  Case description;
  description.dimension = dimension;
  Material water, tofu;
  water.density = 1000.0;
  tofu.kind = MaterialKind::elastic;
  tofu.density = 940.0;
  tofu.failure_strain = 0.1;
  description.materials = {water, tofu};
  Body block;
  block.name = "block";
  block.material = 1;
  block.spacing = solid_spacing;
  description.bodies = {block};
  Jet jet;
  jet.material = 0;
  jet.speed = 5.0;
  jet.width = jet_width;
  jet.standoff = 20.0 * mm;
  jet.angle = angle;
  jet.spacing = water_spacing;
  description.jets = {jet};
  return description;
}

struct Kind {
  Category category;
  std::uint16_t source;
  double spacing;
  double density;
};

inline void add(Frame& frame, const Kind& kind, const Position& x) {
  frame.position.push_back(x);
  frame.velocity.push_back({});
  frame.category.push_back(kind.category);
  frame.id.push_back(static_cast<std::uint32_t>(frame.id.size()));
  frame.source.push_back(kind.source);
  frame.spacing.push_back(static_cast<float>(kind.spacing));
  frame.mass.push_back(static_cast<float>(kind.density * std::pow(kind.spacing, frame.dimension)));
  frame.density.push_back(static_cast<float>(kind.density));
  frame.pressure.push_back(0.0f);
  frame.upstream.push_back(0);
}

// Square lattice from `low` to `high`, nodes half a spacing inside; z only in 3D.
inline void add_box(Frame& frame, const Kind& kind, const Position& low, const Position& high) {
  const double d = kind.spacing;
  const auto count = [&](std::size_t a) { return std::lround((high[a] - low[a]) / d); };
  const long layers = frame.dimension == 3 ? count(2) : 1;
  for (long k = 0; k < layers; ++k)
    for (long j = 0; j < count(1); ++j)
      for (long i = 0; i < count(0); ++i) {
        const auto at = [&](long n, std::size_t a) {
          return low[a] + (static_cast<double>(n) + 0.5) * d;
        };
        add(frame, kind, {at(i, 0), at(j, 1), frame.dimension == 3 ? at(k, 2) : 0.0});
      }
}

inline Kind solid(std::uint16_t body = 0) {
  return {Category::solid, body, solid_spacing, 940.0};
}
inline Kind water(const Case& description) {
  return {Category::water, static_cast<std::uint16_t>(description.bodies.size()), water_spacing,
          1000.0};
}

// A block 100 mm (3D: 40 x 40 mm) wide whose top is at y = 0.
inline Frame make_block(int dimension) {
  Frame frame;
  frame.dimension = dimension;
  const double half = dimension == 3 ? 20.0 * mm : 50.0 * mm;
  add_box(frame, solid(), {-half, -thickness, -half}, {half, 0.0, half});
  return frame;
}

// Water from the nozzle down to `depth`, `breadth` wide (round in 3D).
inline void add_water(Frame& frame, const Case& description, double depth, double breadth) {
  const double half = breadth / 2.0, d = water_spacing;
  Frame lattice;
  lattice.dimension = frame.dimension;
  const Position low{-std::ceil(half / d) * d, -depth, -std::ceil(half / d) * d};
  const Position high{-low[0], -depth + std::ceil((20.0 * mm + depth) / d) * d, -low[2]};
  add_box(lattice, water(description), low, high);
  for (const Position& x : lattice.position)
    if (std::hypot(x[0], x[2]) <= half) add(frame, water(description), x);
}

inline void change(Frame& frame, Category category,
                   const std::function<bool(const Position&)>& in) {
  for (std::size_t row = 0; row < frame.position.size(); ++row)
    if (frame.category[row] == Category::solid && in(frame.position[row]))
      frame.category[row] = category;
}

// A slot of width `breadth` and depth `depth`: the solid in it is fractured and water fills it.
inline Frame make_cut(const Case& description, double depth, double breadth, double time) {
  Frame frame = make_block(description.dimension);
  frame.time = time;
  change(frame, Category::fractured, [&](const Position& x) {
    return std::hypot(x[0], x[2]) < breadth / 2.0 && x[1] > -depth;
  });
  add_water(frame, description, depth, std::min(breadth, jet_width));
  return frame;
}

inline void move(Frame& frame, const std::function<Position(const Position&)>& to) {
  for (Position& x : frame.position) x = to(x);
}

// Rotates a layout for a vertical jet to that of a jet at `angle`.
inline void tilt(Frame& frame, double angle) {
  move(frame, [&](const Position& x) -> Position {
    return {x[0] * std::cos(angle) - x[1] * std::sin(angle),
            x[0] * std::sin(angle) + x[1] * std::cos(angle), x[2]};
  });
}

// Displaces every particle by up to `part` of its spacing along each axis.
inline void jitter(Frame& frame, double part, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> shift(-part, part);
  for (std::size_t row = 0; row < frame.position.size(); ++row)
    for (int a = 0; a < frame.dimension; ++a)
      frame.position[row][static_cast<std::size_t>(a)] += shift(random) * frame.spacing[row];
}

template <class Keep>
Frame select(const Frame& frame, const std::vector<std::size_t>& rows, Keep keep) {
  Frame out;
  out.dimension = frame.dimension;
  out.time = frame.time;
  for (const std::size_t row : rows) {
    if (!keep(row)) continue;
    add(out, {frame.category[row], frame.source[row], frame.spacing[row], 0.0},
        frame.position[row]);
    out.velocity.back() = frame.velocity[row];
    out.id.back() = frame.id[row];
    out.mass.back() = frame.mass[row];
  }
  return out;
}

inline std::vector<std::size_t> rows_of(const Frame& frame) {
  std::vector<std::size_t> rows(frame.position.size());
  for (std::size_t row = 0; row < rows.size(); ++row) rows[row] = row;
  return rows;
}

inline Frame without(const Frame& frame, const std::function<bool(const Position&)>& gone) {
  return select(frame, rows_of(frame), [&](std::size_t row) { return !gone(frame.position[row]); });
}

inline Frame shuffled(const Frame& frame, unsigned seed) {
  auto rows = rows_of(frame);
  std::shuffle(rows.begin(), rows.end(), std::mt19937(seed));
  return select(frame, rows, [](std::size_t) { return true; });
}

}  // namespace kerf::layout
