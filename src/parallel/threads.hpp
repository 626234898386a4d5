// SPDX-License-Identifier: Apache-2.0
// The threads of particle loops.
#pragma once

#include <cstdint>

namespace kerf {

using Index = std::uint32_t;
inline constexpr Index no_index = ~Index(0);

// Sets how many threads all runs of this process use; 0 = every core.
void set_threads(int threads);
// Returns how many they are.
int thread_count();

// Calls block(body, begin, end) for blocks that together are 0 .. count - 1, in any order.
using IndexBlock = void (*)(const void* body, Index begin, Index end);
void for_each_block(Index count, IndexBlock block, const void* body);

// Calls body(i) for i = 0 .. count - 1 on the threads, in any order. The algorithms of Thrust are
// templates that instantiate the scheduler of TBB for each body, which took half of all compile
// time; here a body is a pointer for all but one small function.
template <class Body>
void for_each_on_threads(Index count, const Body& body) {
  for_each_block(
      count,
      [](const void* any, Index begin, Index end) {
        const Body& of_block = *static_cast<const Body*>(any);
        for (Index i = begin; i < end; ++i) of_block(i);
      },
      &body);
}

}  // namespace kerf
