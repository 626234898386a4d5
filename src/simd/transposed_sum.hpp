// SPDX-License-Identifier: Apache-2.0
// sum_each() sums over the lanes of several registers at once: folding two registers into one costs
// two shuffles and an addition, whatever they hold, so that up to sixteen are summed for little
// more than one.
#pragma once

#include "core/simd_numbers.hpp"

namespace kerf::simd {

#if defined(__AVX512F__)
struct SumOf16 {
  // [a, b, a, b] in every quarter.
  [[gnu::always_inline]] static __m512 fold2(__m512 a, __m512 b) {
    return _mm512_add_ps(_mm512_unpacklo_ps(a, b), _mm512_unpackhi_ps(a, b));
  }
  // [a, b, c, d] in every quarter, of two that hold [a, b, a, b] and [c, d, c, d].
  [[gnu::always_inline]] static __m512 fold4(__m512 ab, __m512 cd) {
    return _mm512_add_ps(_mm512_shuffle_ps(ab, cd, 0x44), _mm512_shuffle_ps(ab, cd, 0xEE));
  }
  [[gnu::always_inline]] static __m512 fold_quarters(__m512 a, __m512 b) {
    return _mm512_add_ps(_mm512_shuffle_f32x4(a, b, 0x44), _mm512_shuffle_f32x4(a, b, 0xEE));
  }
  [[gnu::always_inline]] static __m512 fold_halves(__m512 a, __m512 b) {
    return _mm512_add_ps(_mm512_shuffle_f32x4(a, b, 0x88), _mm512_shuffle_f32x4(a, b, 0xDD));
  }
  [[gnu::always_inline]] static __m512 of(const __m512* r) {
    const __m512 a = fold4(fold2(r[0], r[1]), fold2(r[2], r[3]));
    const __m512 b = fold4(fold2(r[4], r[5]), fold2(r[6], r[7]));
    const __m512 c = fold4(fold2(r[8], r[9]), fold2(r[10], r[11]));
    const __m512 d = fold4(fold2(r[12], r[13]), fold2(r[14], r[15]));
    return fold_halves(fold_quarters(a, b), fold_quarters(c, d));
  }
};
#elif defined(__AVX2__)
struct SumOf8 {
  // [a, b, a, b] in both halves.
  [[gnu::always_inline]] static __m256 fold2(__m256 a, __m256 b) {
    return _mm256_add_ps(_mm256_unpacklo_ps(a, b), _mm256_unpackhi_ps(a, b));
  }
  // [a, b, c, d] in both halves, of two that hold [a, b, a, b] and [c, d, c, d].
  [[gnu::always_inline]] static __m256 fold4(__m256 ab, __m256 cd) {
    return _mm256_add_ps(_mm256_shuffle_ps(ab, cd, 0x44), _mm256_shuffle_ps(ab, cd, 0xEE));
  }
  [[gnu::always_inline]] static __m256 of(const __m256* r) {
    const __m256 a = fold4(fold2(r[0], r[1]), fold2(r[2], r[3]));
    const __m256 b = fold4(fold2(r[4], r[5]), fold2(r[6], r[7]));
    return _mm256_add_ps(_mm256_permute2f128_ps(a, b, 0x20), _mm256_permute2f128_ps(a, b, 0x31));
  }
};
#endif

// Sets total[n] to factor[n] times the sum of the lanes of parts[n], the first `scaled` of them
// times `scale` as well. `factor` must be aligned to 64 bytes.
template <int scaled, class T, int count>
[[gnu::always_inline]] inline void sum_each(const T (&parts)[count],
                                            const typename T::value_type (&factor)[count],
                                            typename T::value_type scale,
                                            typename T::value_type (&total)[count]) {
#if defined(__AVX512F__)
  if constexpr (sizeof(typename T::value_type) == 4 && T::size() == 16 && count <= 16) {
    constexpr auto wanted = static_cast<__mmask16>((1u << count) - 1u);
    constexpr auto to_scale = static_cast<__mmask16>((1u << scaled) - 1u);
    __m512 rows[16];
    for (int n = 0; n < 16; ++n)
      rows[n] = n < count ? static_cast<__m512>(parts[n]) : _mm512_setzero_ps();
    __m512 sums = _mm512_mul_ps(_mm512_maskz_load_ps(wanted, factor), SumOf16::of(rows));
    sums = _mm512_mask_mul_ps(sums, to_scale, sums, _mm512_set1_ps(scale));
    _mm512_mask_storeu_ps(total, wanted, sums);
    return;
  }
#elif defined(__AVX2__)
  if constexpr (sizeof(typename T::value_type) == 4 && T::size() == 8) {
    alignas(32) float sums[(count + 7) / 8 * 8];
    for (int first = 0; first < count; first += 8) {
      __m256 rows[8];
      for (int n = 0; n < 8; ++n)
        rows[n] = first + n < count ? static_cast<__m256>(parts[first + n]) : _mm256_setzero_ps();
      _mm256_store_ps(sums + first, SumOf8::of(rows));
    }
    for (int n = 0; n < count; ++n) total[n] = factor[n] * sums[n] * (n < scaled ? scale : 1);
    return;
  }
#endif
  for (int n = 0; n < count; ++n)
    total[n] = factor[n] * stdx::reduce(parts[n]) * (n < scaled ? scale : 1);
}
template <class T, int count>
[[gnu::always_inline]] inline void sum_each(const T (&parts)[count],
                                            typename T::value_type (&total)[count]) {
  alignas(64) typename T::value_type ones[count];
  for (int n = 0; n < count; ++n) ones[n] = 1;
  sum_each<0>(parts, ones, 1, total);
}

}  // namespace kerf::simd
