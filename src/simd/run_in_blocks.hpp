// SPDX-License-Identifier: Apache-2.0
// run_in_blocks() runs a SIMD kernel over all particles, a block of them at a time on whichever
// thread is free, and after each block the loop that uses its results, while they are in the cache.
#pragma once

#include "parallel/index_share.hpp"

namespace kerf {

// The results of a SIMD kernel for a block of particles.
template <class Result>
struct BlockResults {
  const Result* of_first = nullptr;
  Index first = 0;

  KERF_FUNCTION bool are_known() const { return of_first != nullptr; }
  KERF_FUNCTION const Result& operator[](Index i) const { return of_first[i - first]; }
};

// `Task` as in fluid/simd/packed_fluid.hpp and packed_bonds.hpp; `Loop` has take(BlockResults).
template <class Task, class Result, class Loop>
struct RunInBlocks {
  static constexpr Index length = 64;  // particles that one thread takes at a time

  Task task;
  void (*kernel)(const Task& task, Index first, Index last);
  Loop loop;
  Index count;

  KERF_FUNCTION void operator()(Index number) const {
    const Index first = number * length;
    const Index last = first + length < count ? first + length : count;
    Result results[length];
    auto of_block = task;
    of_block.results = results;
    kernel(of_block, first, last);
    Loop loop_of_block = loop;
    loop_of_block.take(BlockResults<Result>{results, first});
    for (Index i = first; i < last; ++i) loop_of_block(i);
  }
};

// Calls loop(i) for all particles of a share, each after the kernel computed its block.
template <class Result, class Task, class Loop>
void run_in_blocks(const Task& task, void (*kernel)(const Task&, Index, Index),
                   const IndexShare& share, const Loop& loop) {
  using Block = RunInBlocks<Task, Result, Loop>;
  static_assert(IndexShare::block % Block::length == 0);
  for_each_index(
      IndexShare{share.first / Block::length, (share.last + Block::length - 1) / Block::length},
      Block{task, kernel, loop, share.last});
}
template <class Result, class Task, class Loop>
void run_in_blocks(const Task& task, void (*kernel)(const Task&, Index, Index), Index count,
                   const Loop& loop) {
  run_in_blocks<Result>(task, kernel, IndexShare::whole(count), loop);
}

}  // namespace kerf
