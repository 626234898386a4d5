// SPDX-License-Identifier: Apache-2.0
#include "parallel/threads.hpp"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <memory>
#if defined(KERF_TSAN_THREADS)
#include <thread>
#include <vector>
#endif

namespace kerf {

namespace {
int wanted_threads = 0;
}

void set_threads(int threads) {
  static std::unique_ptr<tbb::global_control> control;
  wanted_threads = threads > 0 ? threads : tbb::info::default_concurrency();
  control = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                  static_cast<std::size_t>(wanted_threads));
}

int thread_count() {
  return wanted_threads > 0 ? wanted_threads : tbb::info::default_concurrency();
}

#if defined(KERF_TSAN_THREADS)

// ThreadSanitizer cannot analyse a TBB that was built without it: plain threads, each with every
// n-th block, so that data races of bodies are found. The algorithms of Thrust itself run on one
// thread in this build.
void for_each_block(Index count, IndexBlock block, const void* body) {
  constexpr Index length = 16;
  const auto threads = static_cast<Index>(wanted_threads > 0 ? wanted_threads : 2);
  const auto work = [&](Index thread) {
    for (std::uint64_t begin = std::uint64_t{length} * thread; begin < count;
         begin += std::uint64_t{length} * threads)
      block(body, static_cast<Index>(begin),
            count - begin < length ? count : static_cast<Index>(begin) + length);
  };
  std::vector<std::thread> others;
  for (Index thread = 1; thread < threads && length * thread < count; ++thread)
    others.emplace_back(work, thread);
  work(0);
  for (std::thread& other : others) other.join();
}

#else

void for_each_block(Index count, IndexBlock block, const void* body) {
  tbb::parallel_for(
      tbb::blocked_range<Index>(0, count),
      [=](const tbb::blocked_range<Index>& range) { block(body, range.begin(), range.end()); });
}

#endif

}  // namespace kerf
