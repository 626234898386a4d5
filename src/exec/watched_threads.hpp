// SPDX-License-Identifier: Apache-2.0
// Particle loops for ThreadSanitizer, which cannot look into a TBB that was built without it: plain
// threads, each with every n-th block of indices, so that bodies that touch what is not theirs are
// seen. Thrust's own algorithms run on one thread in this build.
#pragma once

#include <cstdint>
#include <thread>
#include <vector>

namespace kerf {

int watched_threads();  // as many as set_threads() asked for, 2 or more unless it asked for 1

template <class Body>
void for_each_index_watched(std::uint32_t count, const Body& body) {
  constexpr std::uint32_t block = 16;
  const auto threads = static_cast<std::uint32_t>(watched_threads());
  const auto work = [&](std::uint32_t thread) {
    for (std::uint64_t begin = std::uint64_t{block} * thread; begin < count;
         begin += std::uint64_t{block} * threads)
      for (std::uint64_t i = begin; i < begin + block && i < count; ++i)
        body(static_cast<std::uint32_t>(i));
  };
  std::vector<std::thread> others;
  for (std::uint32_t thread = 1; thread < threads && block * thread < count; ++thread)
    others.emplace_back(work, thread);
  work(0);
  for (std::thread& other : others) other.join();
}

}  // namespace kerf
