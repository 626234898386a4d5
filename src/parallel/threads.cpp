// SPDX-License-Identifier: Apache-2.0
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <memory>

#include "parallel/loops.hpp"
#include "parallel/threads.hpp"

namespace kerf {

#if defined(KERF_TSAN_THREADS)
namespace {
int wanted_threads = 0;
}
int tsan_threads() {
  return wanted_threads > 0 ? wanted_threads : 2;
}
#endif

void set_threads(int threads) {
#if defined(KERF_TSAN_THREADS)
  wanted_threads = threads;
#endif
  static std::unique_ptr<tbb::global_control> control;
  const int wanted = threads > 0 ? threads : tbb::info::default_concurrency();
  control = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                  static_cast<std::size_t>(wanted));
}

}  // namespace kerf
