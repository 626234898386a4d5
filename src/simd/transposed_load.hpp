// SPDX-License-Identifier: Apache-2.0
// load_transposed() loads the packed particles of a batch into one register for each of their
// numbers. A load of a complete packed particle and a few shuffles take a third of the time of the
// processor's own gathers, number by number.
#pragma once

#include "core/simd_numbers.hpp"

namespace kerf::simd {

#if defined(__AVX512F__)
// Eight numbers of each of 16 records; `from` is the first of them in record 0. With half the loads
// of two quarters.
template <class Index>
[[gnu::always_inline]] inline void load_half(const char* from, std::ptrdiff_t stride,
                                             const Index* index, __m512* slot) {
  const auto at = [&](int lane) {
    return _mm256_loadu_ps(reinterpret_cast<const float*>(from + stride * index[lane]));
  };
  const auto pair = [&](int lane) {
    return _mm512_insertf32x8(_mm512_castps256_ps512(at(lane)), at(lane + 4), 1);
  };
  // Of each four rows: [slot r of 0 .. 3, slot 4 + r of 0 .. 3, the same of 4 .. 7].
  __m512 turned[2][4];
  for (int half = 0; half < 2; ++half) {
    __m512 row[4];
    for (int r = 0; r < 4; ++r) row[r] = pair(8 * half + r);
    const __m512d low01 = _mm512_castps_pd(_mm512_unpacklo_ps(row[0], row[1]));
    const __m512d high01 = _mm512_castps_pd(_mm512_unpackhi_ps(row[0], row[1]));
    const __m512d low23 = _mm512_castps_pd(_mm512_unpacklo_ps(row[2], row[3]));
    const __m512d high23 = _mm512_castps_pd(_mm512_unpackhi_ps(row[2], row[3]));
    turned[half][0] = _mm512_castpd_ps(_mm512_unpacklo_pd(low01, low23));
    turned[half][1] = _mm512_castpd_ps(_mm512_unpackhi_pd(low01, low23));
    turned[half][2] = _mm512_castpd_ps(_mm512_unpacklo_pd(high01, high23));
    turned[half][3] = _mm512_castpd_ps(_mm512_unpackhi_pd(high01, high23));
  }
  for (int r = 0; r < 4; ++r) {
    slot[r] = _mm512_shuffle_f32x4(turned[0][r], turned[1][r], 0x88);
    slot[4 + r] = _mm512_shuffle_f32x4(turned[0][r], turned[1][r], 0xDD);
  }
}
// Four numbers of each of 16 records; `from` is the first of them in record 0.
template <class Index>
[[gnu::always_inline]] inline void load_quarter(const char* from, std::ptrdiff_t stride,
                                                const Index* index, __m512* slot) {
  const auto at = [&](int lane) {
    return _mm_load_ps(reinterpret_cast<const float*>(from + stride * index[lane]));
  };
  __m512 row[4];
  for (int r = 0; r < 4; ++r) {
    row[r] = _mm512_castps128_ps512(at(r));
    row[r] = _mm512_insertf32x4(row[r], at(r + 4), 1);
    row[r] = _mm512_insertf32x4(row[r], at(r + 8), 2);
    row[r] = _mm512_insertf32x4(row[r], at(r + 12), 3);
  }
  const __m512d low01 = _mm512_castps_pd(_mm512_unpacklo_ps(row[0], row[1]));
  const __m512d high01 = _mm512_castps_pd(_mm512_unpackhi_ps(row[0], row[1]));
  const __m512d low23 = _mm512_castps_pd(_mm512_unpacklo_ps(row[2], row[3]));
  const __m512d high23 = _mm512_castps_pd(_mm512_unpackhi_ps(row[2], row[3]));
  slot[0] = _mm512_castpd_ps(_mm512_unpacklo_pd(low01, low23));
  slot[1] = _mm512_castpd_ps(_mm512_unpackhi_pd(low01, low23));
  slot[2] = _mm512_castpd_ps(_mm512_unpacklo_pd(high01, high23));
  slot[3] = _mm512_castpd_ps(_mm512_unpackhi_pd(high01, high23));
}
// Two doubles of each of 8 records.
template <class Index>
[[gnu::always_inline]] inline void load_pair(const char* from, std::ptrdiff_t stride,
                                             const Index* index, __m512d* slot) {
  const auto at = [&](int lane) {
    return _mm_load_pd(reinterpret_cast<const double*>(from + stride * index[lane]));
  };
  __m512d row[2];
  for (int r = 0; r < 2; ++r) {
    row[r] = _mm512_castpd128_pd512(at(r));
    row[r] = _mm512_insertf64x2(row[r], at(r + 2), 1);
    row[r] = _mm512_insertf64x2(row[r], at(r + 4), 2);
    row[r] = _mm512_insertf64x2(row[r], at(r + 6), 3);
  }
  slot[0] = _mm512_unpacklo_pd(row[0], row[1]);
  slot[1] = _mm512_unpackhi_pd(row[0], row[1]);
}
#elif defined(__AVX2__)
// Four numbers of each of 8 records.
template <class Index>
[[gnu::always_inline]] inline void load_quarter(const char* from, std::ptrdiff_t stride,
                                                const Index* index, __m256* slot) {
  const auto at = [&](int lane) {
    return _mm_load_ps(reinterpret_cast<const float*>(from + stride * index[lane]));
  };
  __m256 row[4];
  for (int r = 0; r < 4; ++r)
    row[r] = _mm256_insertf128_ps(_mm256_castps128_ps256(at(r)), at(r + 4), 1);
  const __m256d low01 = _mm256_castps_pd(_mm256_unpacklo_ps(row[0], row[1]));
  const __m256d high01 = _mm256_castps_pd(_mm256_unpackhi_ps(row[0], row[1]));
  const __m256d low23 = _mm256_castps_pd(_mm256_unpacklo_ps(row[2], row[3]));
  const __m256d high23 = _mm256_castps_pd(_mm256_unpackhi_ps(row[2], row[3]));
  slot[0] = _mm256_castpd_ps(_mm256_unpacklo_pd(low01, low23));
  slot[1] = _mm256_castpd_ps(_mm256_unpackhi_pd(low01, low23));
  slot[2] = _mm256_castpd_ps(_mm256_unpacklo_pd(high01, high23));
  slot[3] = _mm256_castpd_ps(_mm256_unpackhi_pd(high01, high23));
}
// Two doubles of each of 4 records.
template <class Index>
[[gnu::always_inline]] inline void load_pair(const char* from, std::ptrdiff_t stride,
                                             const Index* index, __m256d* slot) {
  const auto at = [&](int lane) {
    return _mm_load_pd(reinterpret_cast<const double*>(from + stride * index[lane]));
  };
  __m256d row[2];
  for (int r = 0; r < 2; ++r)
    row[r] = _mm256_insertf128_pd(_mm256_castpd128_pd256(at(r)), at(r + 2), 1);
  slot[0] = _mm256_unpacklo_pd(row[0], row[1]);
  slot[1] = _mm256_unpackhi_pd(row[0], row[1]);
}
#endif

// slot[s][lane] = number s of records[index[lane]] for s from `first` up to `end`, and a few more.
template <class Record, int first, int end, class T, class Index>
[[gnu::always_inline]] inline void load_transposed(const Record* records, const Index* index,
                                                   T* slot) {
  using Real = typename T::value_type;
  const char* from = reinterpret_cast<const char*>(records);
#if defined(__AVX2__)
  if constexpr (sizeof(Real) == 4) {
#if defined(__AVX512F__)
    constexpr int halves = (end - first) / 8;
    __m512 raw[8];
    for (int s = first; s < first + 8 * halves; s += 8) {
      load_half(from + 4 * s, static_cast<std::ptrdiff_t>(sizeof(Record)), index, raw);
      for (int r = 0; r < 8; ++r) slot[s + r] = T(raw[r]);
    }
#else
    constexpr int halves = 0;
    __m256 raw[4];
#endif
    for (int s = first + 8 * halves; s < end; s += 4) {
      load_quarter(from + 4 * s, static_cast<std::ptrdiff_t>(sizeof(Record)), index, raw);
      for (int r = 0; r < 4; ++r) slot[s + r] = T(raw[r]);
    }
  } else {
#if defined(__AVX512F__)
    __m512d raw[2];
#else
    __m256d raw[2];
#endif
    for (int s = first; s < end; s += 2) {
      load_pair(from + 8 * s, static_cast<std::ptrdiff_t>(sizeof(Record)), index, raw);
      for (int r = 0; r < 2; ++r) slot[s + r] = T(raw[r]);
    }
  }
#else
  for (int s = first; s < end; ++s) {
    alignas(64) Real numbers[T::size()];
    for (std::size_t lane = 0; lane < T::size(); ++lane)
      __builtin_memcpy(
          &numbers[lane],
          from + static_cast<std::ptrdiff_t>(sizeof(Record)) * index[lane] + sizeof(Real) * s,
          sizeof(Real));
    slot[s].copy_from(numbers, stdx::vector_aligned);
  }
#endif
}

}  // namespace kerf::simd
