// SPDX-License-Identifier: Apache-2.0
// This header declares the designs of a study: every combination, or points spread over the ranges.
#pragma once

#include <cstdint>
#include <vector>

#include "study/axis.hpp"

namespace kerf {

enum class DesignKind { grid, latin_hypercube, sobol };
inline constexpr std::array<std::string_view, 3> design_words{"grid", "latin_hypercube", "sobol"};

struct Design {
  DesignKind kind = DesignKind::grid;
  std::size_t runs = 0;    // of a design that is not a grid
  std::uint64_t seed = 1;  // of the Latin hypercube
};

// Returns each combination of levels once; the last axis varies fastest.
std::vector<Setting> grid(const std::vector<Axis>& axes);

// Returns points in the unit cube. Along each axis a Latin hypercube has one point at random in
// each of `count` equal parts (McKay, Beckman & Conover, Technometrics 21 (1979) 239).
std::vector<std::vector<double>> latin_hypercube(std::size_t dimensions, std::size_t count,
                                                 std::uint64_t seed);
// Returns the first points of Sobol's sequence (USSR Comput. Math. Math. Phys. 7 (1967) 86), which
// begins at the centre of the cube; a longer sequence contains every shorter one.
std::vector<std::vector<double>> sobol(std::size_t dimensions, std::size_t count);

// Returns the settings of the design over the axes.
std::vector<Setting> settings_of(const Design& design, const std::vector<Axis>& axes);

}  // namespace kerf
