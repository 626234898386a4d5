// SPDX-License-Identifier: Apache-2.0
// The neighbours of one particle, as many at a time as a register holds.
#pragma once

#include <cstdint>

#include "lanes/lane_numbers.hpp"

// One namespace for each instruction set: the linker must never take the code of one for another.
namespace kerf::lanes::KERF_LANES {

struct Neighbours {
  const std::uint32_t* list;
  std::uint32_t begin, end;  // in the list
};

// body(indices, k, count) for each block, whose first `count` entries stand at k in the list. The
// last block is filled up with the particle itself.
template <int width, class Body>
[[gnu::always_inline]] inline void for_each_block(const Neighbours& of, std::uint32_t self,
                                                  const Body& body) {
  std::uint32_t k = of.begin;
  for (; k + width <= of.end; k += width) body(of.list + k, k, width);
  if (k >= of.end) return;
  alignas(64) std::uint32_t last[width];
  const int left = static_cast<int>(of.end - k);
  for (int lane = 0; lane < width; ++lane)
    last[lane] = lane < left ? of.list[k + std::uint32_t(lane)] : self;
  body(last, k, left);
}

}  // namespace kerf::lanes::KERF_LANES
