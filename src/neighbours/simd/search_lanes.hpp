// SPDX-License-Identifier: Apache-2.0
// SearchLanes has the operations of the neighbour search on a register of integers. A set of lanes
// is an integer with one bit for each lane.
#pragma once

#include <array>
#include <cstdint>

#include "core/simd_numbers.hpp"

namespace kerf::simd::KERF_SIMD {

#if defined(__AVX512F__)
struct SearchLanes {
  static constexpr std::uint32_t width = 16;
  using Integers = __m512i;
  using Set = __mmask16;
  using T = SimdNumbers<float>;

  KERF_SIMD_FUNCTION static Integers filled(std::uint32_t number) {
    return _mm512_set1_epi32(static_cast<int>(number));
  }
  KERF_SIMD_FUNCTION static Integers load(const void* from) { return _mm512_loadu_si512(from); }
  // `first`, `first` + 1, ...
  KERF_SIMD_FUNCTION static Integers numbered(std::uint32_t first) {
    return _mm512_add_epi32(
        filled(first), _mm512_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15));
  }
  KERF_SIMD_FUNCTION static T difference(Integers a, Integers b) {
    return T(_mm512_cvtepi32_ps(_mm512_sub_epi32(a, b)));
  }
  // The first `count` lanes.
  KERF_SIMD_FUNCTION static Set first(std::uint32_t count) {
    return count < width ? Set((1u << count) - 1u) : Set(0xffff);
  }
  // The lanes of `among` where a < b.
  KERF_SIMD_FUNCTION static Set less(Set among, const T& a, const T& b) {
    return _mm512_mask_cmp_ps_mask(among, static_cast<__m512>(a), static_cast<__m512>(b),
                                   _CMP_LT_OQ);
  }
  KERF_SIMD_FUNCTION static Set equal(Set among, Integers a, Integers b) {
    return _mm512_mask_cmpeq_epi32_mask(among, a, b);
  }
  KERF_SIMD_FUNCTION static Set unequal(Set among, Integers a, Integers b) {
    return _mm512_mask_cmpneq_epi32_mask(among, a, b);
  }
  // Writes the numbers of the lanes in `which` to the list, which has room for a register; returns
  // its end.
  KERF_SIMD_FUNCTION static std::uint32_t* append(std::uint32_t* list, Set which, Integers number) {
    _mm512_storeu_si512(list, _mm512_maskz_compress_epi32(which, number));
    return list + __builtin_popcount(which);
  }
};
#elif defined(__AVX2__)
// For each set of eight lanes, its lanes one after the other, one in each byte from the lowest on.
inline constexpr auto lanes_of_set = [] {
  std::array<std::uint64_t, 256> lanes{};
  for (unsigned set = 0; set < lanes.size(); ++set) {
    unsigned shift = 0;
    for (std::uint64_t lane = 0; lane < 8; ++lane) {
      if ((set >> lane & 1u) == 0) continue;
      lanes[set] |= lane << shift;
      shift += 8;
    }
  }
  return lanes;
}();

struct SearchLanes {
  static constexpr std::uint32_t width = 8;
  using Integers = __m256i;
  using Set = std::uint32_t;
  using T = SimdNumbers<float>;

  KERF_SIMD_FUNCTION static Integers filled(std::uint32_t number) {
    return _mm256_set1_epi32(static_cast<int>(number));
  }
  KERF_SIMD_FUNCTION static Integers load(const void* from) {
    return _mm256_loadu_si256(static_cast<const __m256i*>(from));
  }
  // `first`, `first` + 1, ...
  KERF_SIMD_FUNCTION static Integers numbered(std::uint32_t first) {
    return _mm256_add_epi32(filled(first), _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7));
  }
  KERF_SIMD_FUNCTION static T difference(Integers a, Integers b) {
    return T(_mm256_cvtepi32_ps(_mm256_sub_epi32(a, b)));
  }
  // The first `count` lanes.
  KERF_SIMD_FUNCTION static Set first(std::uint32_t count) {
    return count < width ? (1u << count) - 1u : 0xffu;
  }
  // The lanes of `among` where a < b.
  KERF_SIMD_FUNCTION static Set less(Set among, const T& a, const T& b) {
    return among & bits(_mm256_cmp_ps(static_cast<__m256>(a), static_cast<__m256>(b), _CMP_LT_OQ));
  }
  KERF_SIMD_FUNCTION static Set equal(Set among, Integers a, Integers b) {
    return among & bits(_mm256_castsi256_ps(_mm256_cmpeq_epi32(a, b)));
  }
  KERF_SIMD_FUNCTION static Set unequal(Set among, Integers a, Integers b) {
    return among & ~bits(_mm256_castsi256_ps(_mm256_cmpeq_epi32(a, b)));
  }
  // Writes the numbers of the lanes in `which` to the list, which has room for a register; returns
  // its end.
  KERF_SIMD_FUNCTION static std::uint32_t* append(std::uint32_t* list, Set which, Integers number) {
    const __m256i order =
        _mm256_cvtepu8_epi32(_mm_cvtsi64_si128(static_cast<long long>(lanes_of_set[which])));
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(list),
                        _mm256_permutevar8x32_epi32(number, order));
    return list + __builtin_popcount(which);
  }

 private:
  KERF_SIMD_FUNCTION static Set bits(__m256 mask) {
    return static_cast<Set>(_mm256_movemask_ps(mask));
  }
};
#endif

}  // namespace kerf::simd::KERF_SIMD
