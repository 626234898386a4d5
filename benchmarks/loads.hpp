// SPDX-License-Identifier: Apache-2.0
// What stages are timed on: cases of about a given number of particles, in 2D and 3D.
#pragma once

#include <cstddef>

namespace kerf {

struct Case;

enum class Load {
  water,   // a block of water
  solid,   // a block of gel
  slabs,   // slabs of gel, four particles thick, pressed on one another
  soaked,  // the same with water in every other slab
};

inline constexpr std::size_t numbers_of_particles[] = {1'000, 10'000, 100'000, 1'000'000};

const char* load_name(Load load);

// A square or cube of about so many particles, 1 mm apart.
Case load_case(Load load, int dimension, std::size_t particles);

}  // namespace kerf
