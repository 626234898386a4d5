// SPDX-License-Identifier: Apache-2.0
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "lanes/walks.hpp"

namespace kerf {

namespace lanes {
#if defined(KERF_HAS_X86_LANES)
extern const Walks avx2_walks;
#endif
#if defined(KERF_HAS_AVX512_LANES)
extern const Walks avx512_walks;
#endif
extern const Walks baseline_walks;
}  // namespace lanes

namespace {

// The fastest first.
std::vector<const Walks*> runnable() {
  std::vector<const Walks*> all;
#if defined(KERF_HAS_AVX512_LANES)
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
      __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512cd"))
    all.push_back(&lanes::avx512_walks);
#endif
#if defined(KERF_HAS_X86_LANES)
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
      __builtin_cpu_supports("bmi2"))
    all.push_back(&lanes::avx2_walks);
#endif
  all.push_back(&lanes::baseline_walks);
  return all;
}

const Walks& choose() {
  const auto all = runnable();
  const char* wish = std::getenv("KERF_LANES");
  if (wish == nullptr || std::string_view(wish).empty()) return *all.front();
  std::string names;
  for (const Walks* walk : all) {
    if (std::string_view(wish) == walk->name) return *walk;
    names += (names.empty() ? "" : ", ") + std::string(walk->name);
  }
  throw UserError("KERF_LANES = " + std::string(wish) +
                      " is no instruction set of this program and processor; set it to one of " +
                      names + ", or not at all",
                  exit_bad_input);
}

}  // namespace

const Walks& walks() {
  static const Walks& chosen = choose();
  return chosen;
}

}  // namespace kerf
