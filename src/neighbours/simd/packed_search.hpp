// SPDX-License-Identifier: Apache-2.0
// SearchTask is the input of the SIMD neighbour search: particles in the order of their cells, one
// array for each coordinate, and the rows of cells around a particle.
#pragma once

#include "simd/packed_position.hpp"

namespace kerf {

// Returns |x_i - x_j|^2, given difference(a) = component a of x_i - x_j: for one candidate in any
// precision, or for a register of candidates.
template <int D, class T, class Difference>
KERF_FORMULA T squared_distance(const Difference& difference) {
  T square(0);
  for (int a = 0; a < D; ++a) {
    const T d = difference(a);
    square += d * d;
  }
  return square;
}

// Rows of candidates of one particle.
struct SearchRows {
  static constexpr int most = 96;
  static constexpr std::uint32_t most_candidates = 1024;
  std::uint32_t begin[most], end[most];
  int count = 0;
  std::uint32_t candidates = 0;

  bool is_full() const { return count == most || candidates == most_candidates; }
  // Takes of the row `first` .. `last` - 1 what there is room for; returns how many.
  std::uint32_t take(std::uint32_t first, std::uint32_t last) {
    const std::uint32_t room = most_candidates - candidates;
    const std::uint32_t taken = last - first < room ? last - first : room;
    begin[count] = first;
    end[count++] = first + taken;
    candidates += taken;
    return taken;
  }
};

template <int D>
struct SearchTask {
  const std::int32_t* position[D];  // of all particles; some entries beyond the last can be read
  const std::uint32_t* kind;        // two of one kind have one cutoff; 0: of no kind
  std::int32_t own_position[D];
  std::uint32_t own, own_kind;        // index and kind of the particle
  float limit_squared, same_squared;  // cutoffs of any candidate, and of those of its own kind
  const SearchRows* rows;
  // Out, with room for all candidates and 16 more: the neighbours of its own kind, and the
  // candidates of other kinds, which are tested one by one.
  std::uint32_t *same, *others;
};

struct SearchCounts {
  std::uint32_t same, others;
};

template <int D>
using Search = SearchCounts (*)(const SearchTask<D>&);

}  // namespace kerf
