// SPDX-License-Identifier: Apache-2.0
// What a simulation shows of itself: particles at one instant, on the host, in SI units.
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
};

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
  std::vector<Column> columns;  // further fields: "deviatoric_stress" (xx yy zz xy yz xz), ...
};

}  // namespace kerf
