// SPDX-License-Identifier: Apache-2.0
// Which settings a study runs: every combination, or points spread over the ranges.
#pragma once

#include <cstdint>
#include <vector>

#include "study/axis.hpp"

namespace kerf {

enum class DesignKind { grid, latin_hypercube, sobol };
inline constexpr std::array<std::string_view, 3> design_words{"grid", "latin_hypercube", "sobol"};

struct Design {
  DesignKind kind = DesignKind::grid;
  std::size_t runs = 0;    // of the designs that are no grid
  std::uint64_t seed = 1;  // of the Latin hypercube
};

// Each combination of levels once, the last axis fastest.
std::vector<Setting> grid(const std::vector<Axis>& axes);

// Points in the unit cube. Along each axis a Latin hypercube has one point in each of `count` equal
// parts (McKay, Beckman & Conover, Technometrics 21 (1979) 239), at random in it.
std::vector<std::vector<double>> latin_hypercube(std::size_t dimensions, std::size_t count,
                                                 std::uint64_t seed);
// The first points of Sobol's sequence (USSR Comput. Math. Math. Phys. 7 (1967) 86), from the
// centre of the cube on; more points keep those that fewer have.
std::vector<std::vector<double>> sobol(std::size_t dimensions, std::size_t count);

std::vector<Setting> settings_of(const Design& design, const std::vector<Axis>& axes);

}  // namespace kerf
