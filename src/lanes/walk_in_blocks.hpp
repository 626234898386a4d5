// SPDX-License-Identifier: Apache-2.0
// Runs a walk of lanes/ over all particles, a block of them at a time by whichever thread is free.
#pragma once

#include "exec/exec.hpp"

namespace kerf {

// `Task` as in lanes/packed_fluid.hpp and packed_bonds.hpp.
template <class Task>
struct WalkInBlocks {
  static constexpr Index block = 64;  // particles that one thread takes at a time

  Task task;
  void (*walk)(const Task& task, Index first, Index last);
  Index count;

  KERF_FUNCTION void operator()(Index number) const {
    const Index first = number * block;
    walk(task, first, first + block < count ? first + block : count);
  }
};

template <class Task>
void walk_in_blocks(const Task& task, void (*walk)(const Task&, Index, Index), Index count) {
  constexpr Index block = WalkInBlocks<Task>::block;
  for_each_index((count + block - 1) / block, WalkInBlocks<Task>{task, walk, count});
}

}  // namespace kerf
