// SPDX-License-Identifier: Apache-2.0
// The search for neighbours, several candidates at a time: particles in the order of their cells,
// number by number, and the rows of cells that a particle looks into.
#pragma once

#include "lanes/packed_place.hpp"

namespace kerf {

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
  const std::int32_t* place[D];  // of all particles; some entries more can be read
  const std::uint32_t* kind;     // two of one kind see one another at one distance; 0: of no kind
  std::int32_t own_place[D];
  std::uint32_t own, own_kind;
  float limit_squared, same_squared;  // how far others may be seen, and those of its own kind
  const SearchRows* rows;
  // Out, with room for all candidates and 16 more: those of its own kind, and whom to ask one by
  // one.
  std::uint32_t *same, *others;
};

struct Seen {
  std::uint32_t same, others;  // how many
};

template <int D>
using Search = Seen (*)(const SearchTask<D>&);

}  // namespace kerf
