// SPDX-License-Identifier: Apache-2.0
// A table of SIMD kernels that is compiled once for each instruction set. A source that ends in
// KERF_DEFINE_KERNELS(Table, function, ...) is compiled for each of them (kerf_add_simd of
// cmake/KerfTargets.cmake), with KERF_SIMD defined as the name of the instruction set:
//   const Table& function()    returns the table for this processor; the initialisers follow.
#pragma once

#include "simd/instruction_set.hpp"

#define KERF_NAME_OF_SIMD_IS_baseline 1
#define KERF_JOIN_OF(a, b) a##b
#define KERF_JOIN(a, b) KERF_JOIN_OF(a, b)

#define KERF_DEFINE_TABLE(Table, function, ...) \
  namespace simd::KERF_SIMD {                   \
  extern const Table function##_table;          \
  const Table function##_table = {__VA_ARGS__}; \
  }

#if defined(KERF_HAS_AVX512_SIMD)
#define KERF_AVX512_TABLE(Table, function) \
  namespace simd::avx512 {                 \
  extern const Table function##_table;     \
  }
#define KERF_CHOOSE_AVX512(function) \
  if (instruction_set() == InstructionSet::avx512) return simd::avx512::function##_table;
#else
#define KERF_AVX512_TABLE(Table, function)
#define KERF_CHOOSE_AVX512(function)
#endif

#if defined(KERF_HAS_X86_SIMD)
#define KERF_AVX2_TABLE(Table, function) \
  namespace simd::avx2 {                 \
  extern const Table function##_table;   \
  }
#define KERF_CHOOSE_AVX2(function) \
  if (instruction_set() == InstructionSet::avx2) return simd::avx2::function##_table;
#else
#define KERF_AVX2_TABLE(Table, function)
#define KERF_CHOOSE_AVX2(function)
#endif

// The source for any processor also holds the choice.
#if KERF_JOIN(KERF_NAME_OF_SIMD_IS_, KERF_SIMD) == 1
#define KERF_DEFINE_KERNELS(Table, function, ...) \
  KERF_DEFINE_TABLE(Table, function, __VA_ARGS__) \
  KERF_AVX512_TABLE(Table, function)              \
  KERF_AVX2_TABLE(Table, function)                \
  const Table& function() {                       \
    KERF_CHOOSE_AVX512(function)                  \
    KERF_CHOOSE_AVX2(function)                    \
    return simd::baseline::function##_table;      \
  }
#else
#define KERF_DEFINE_KERNELS(Table, function, ...) KERF_DEFINE_TABLE(Table, function, __VA_ARGS__)
#endif
