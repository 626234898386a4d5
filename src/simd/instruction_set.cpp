// SPDX-License-Identifier: Apache-2.0
#include "simd/instruction_set.hpp"

#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"

namespace kerf {

namespace {

struct NamedSet {
  InstructionSet set;
  const char* name;
};

// The fastest first.
std::vector<NamedSet> available_sets() {
  std::vector<NamedSet> sets;
#if defined(KERF_HAS_AVX512_SIMD)
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
      __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512cd"))
    sets.push_back({InstructionSet::avx512, "avx512"});
#endif
#if defined(KERF_HAS_X86_SIMD)
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
      __builtin_cpu_supports("bmi2"))
    sets.push_back({InstructionSet::avx2, "avx2"});
#endif
  sets.push_back({InstructionSet::baseline, "baseline"});
  return sets;
}

NamedSet choose() {
  const auto sets = available_sets();
  const char* wish = std::getenv("KERF_SIMD");
  if (wish == nullptr || std::string_view(wish).empty()) return sets.front();
  std::string names;
  for (const NamedSet& set : sets) {
    if (std::string_view(wish) == set.name) return set;
    names += (names.empty() ? "" : ", ") + std::string(set.name);
  }
  throw UserError("KERF_SIMD = " + std::string(wish) +
                      " is no instruction set of this program and processor; set it to one of " +
                      names + ", or not at all",
                  exit_bad_input);
}

const NamedSet& chosen() {
  static const NamedSet set = choose();
  return set;
}

}  // namespace

InstructionSet instruction_set() {
  return chosen().set;
}

const char* instruction_set_name() {
  return chosen().name;
}

}  // namespace kerf
