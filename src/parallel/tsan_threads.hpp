// SPDX-License-Identifier: Apache-2.0
// Particle loops for ThreadSanitizer, which cannot analyse a TBB that was built without it: plain
// threads, each with every n-th block of indices, so that data races of bodies are found. The
// algorithms of Thrust itself run on one thread in this build.
#pragma once

#include <cstdint>
#include <thread>
#include <vector>

namespace kerf {

int tsan_threads();  // the number set by set_threads(), at least 2 unless that is 1

template <class Body>
void for_each_index_under_tsan(std::uint32_t count, const Body& body) {
  constexpr std::uint32_t block = 16;
  const auto threads = static_cast<std::uint32_t>(tsan_threads());
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
