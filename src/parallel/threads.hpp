// SPDX-License-Identifier: Apache-2.0
// The threads of particle loops.
#pragma once

#include <cstdint>

namespace kerf {

using Index = std::uint32_t;

// Sets how many threads all runs of this process use; 0 = every core.
void set_threads(int threads);
// Returns how many they are.
int thread_count();

// Calls block(body, begin, end) for blocks that together are 0 .. count - 1, in any order.
using IndexBlock = void (*)(const void* body, Index begin, Index end);
void for_each_block(Index count, IndexBlock block, const void* body);

}  // namespace kerf
