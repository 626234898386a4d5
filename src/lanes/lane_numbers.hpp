// SPDX-License-Identifier: Apache-2.0
// Several numbers side by side in one register, as the number type of formulas: the functions of
// core/select.hpp for them. Only for files that are compiled for one instruction set
// (docs/performance.md), which define KERF_LANES.
#pragma once

#include <bit>
#include <cstdint>
#include <experimental/simd>
#include <type_traits>

#if defined(__AVX512F__) || defined(__AVX2__)
#include <immintrin.h>
#endif

namespace kerf {

namespace lanes {
namespace simd = std::experimental;

template <class Real>
using Numbers = simd::native_simd<Real>;
}  // namespace lanes

#define KERF_LANE_FUNCTION [[gnu::always_inline]] inline
// After the parameters of a loop body that is to be one piece of code with its loop: what it sums
// up stays in registers.
#define KERF_LANE_BODY __attribute__((always_inline))

template <class R, class A>
KERF_LANE_FUNCTION std::experimental::simd<R, A> select(
    const std::experimental::simd_mask<R, A>& chosen, const std::experimental::simd<R, A>& a,
    std::experimental::simd<R, A> b) {
  where(chosen, b) = a;
  return b;
}
template <class R, class A>
KERF_LANE_FUNCTION std::experimental::simd<R, A> maximum(const std::experimental::simd<R, A>& a,
                                                         const std::experimental::simd<R, A>& b) {
  return std::experimental::max(a, b);
}
template <class R, class A>
KERF_LANE_FUNCTION std::experimental::simd<R, A> minimum(const std::experimental::simd<R, A>& a,
                                                         const std::experimental::simd<R, A>& b) {
  return std::experimental::min(a, b);
}
template <class R, class A>
KERF_LANE_FUNCTION std::experimental::simd<R, A> magnitude(const std::experimental::simd<R, A>& a) {
  return std::experimental::abs(a);
}
template <class R, class A>
KERF_LANE_FUNCTION std::experimental::simd<R, A> square_root(
    const std::experimental::simd<R, A>& a) {
  return std::experimental::sqrt(a);
}

// To the last digit or two: an estimate of the processor, and a step of Newton where there is one.
template <class R, class A>
KERF_LANE_FUNCTION std::experimental::simd<R, A> reciprocal(
    const std::experimental::simd<R, A>& a) {
#if defined(__AVX512F__)
  using Lanes = std::experimental::simd<R, A>;
  if constexpr (std::is_same_v<R, float> && Lanes::size() == 16) {
    const Lanes guess(_mm512_rcp14_ps(static_cast<__m512>(a)));
    return guess * (R(2) - a * guess);
  }
#endif
  return R(1) / a;
}
template <class R, class A>
KERF_LANE_FUNCTION std::experimental::simd<R, A> reciprocal_square_root(
    const std::experimental::simd<R, A>& a) {
#if defined(__AVX512F__)
  using Lanes = std::experimental::simd<R, A>;
  if constexpr (std::is_same_v<R, float> && Lanes::size() == 16) {
    const Lanes guess(_mm512_rsqrt14_ps(static_cast<__m512>(a)));
    return guess * (R(1.5) - (R(0.5) * a * guess) * guess);
  }
#endif
  return R(1) / std::experimental::sqrt(a);
}

}  // namespace kerf
