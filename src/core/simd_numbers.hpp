// SPDX-License-Identifier: Apache-2.0
// SimdNumbers is a SIMD register as the number type of formulas, with the functions of
// core/select.hpp. Only files that are compiled for one instruction set include it
// (docs/performance.md); they define KERF_SIMD.
#pragma once

#include <bit>
#include <cstdint>
#include <experimental/simd>
#include <type_traits>

#if defined(__AVX512F__) || defined(__AVX2__)
#include <immintrin.h>
#endif

#include "core/select.hpp"

namespace kerf {

namespace simd {
namespace stdx = std::experimental;

template <class Real>
using SimdNumbers = stdx::native_simd<Real>;
}  // namespace simd

#define KERF_SIMD_FUNCTION [[gnu::always_inline]] inline
// Stands after the parameters of a loop body that is inlined into its loop, so that its sums stay
// in registers.
#define KERF_SIMD_BODY __attribute__((always_inline))

template <class R, class A>
KERF_SIMD_FUNCTION std::experimental::simd<R, A> select(
    const std::experimental::simd_mask<R, A>& chosen, const std::experimental::simd<R, A>& a,
    std::experimental::simd<R, A> b) {
  where(chosen, b) = a;
  return b;
}
template <class R, class A>
KERF_SIMD_FUNCTION std::experimental::simd<R, A> maximum(const std::experimental::simd<R, A>& a,
                                                         const std::experimental::simd<R, A>& b) {
  return std::experimental::max(a, b);
}
template <class R, class A>
KERF_SIMD_FUNCTION std::experimental::simd<R, A> minimum(const std::experimental::simd<R, A>& a,
                                                         const std::experimental::simd<R, A>& b) {
  return std::experimental::min(a, b);
}
template <class R, class A>
KERF_SIMD_FUNCTION std::experimental::simd<R, A> magnitude(const std::experimental::simd<R, A>& a) {
  return std::experimental::abs(a);
}
template <class R, class A>
KERF_SIMD_FUNCTION std::experimental::simd<R, A> square_root(
    const std::experimental::simd<R, A>& a) {
  return std::experimental::sqrt(a);
}

// Returns a - b. The difference of integers wraps around, as that of fixed-point coordinates must
// (simd/packed_position.hpp).
template <class R, class A>
KERF_SIMD_FUNCTION std::experimental::simd<R, A> wrapping_difference(
    const std::experimental::simd<R, A>& a, const std::experimental::simd<R, A>& b) {
  if constexpr (std::is_integral_v<R>) {
    using Signed = std::experimental::simd<R, A>;
    using Unsigned = std::experimental::rebind_simd_t<std::make_unsigned_t<R>, Signed>;
    return std::bit_cast<Signed>(std::bit_cast<Unsigned>(a) - std::bit_cast<Unsigned>(b));
  } else {
    return a - b;
  }
}

// Exact to the last digit or two: the processor's estimate where there is one, and a Newton step.
template <class R, class A>
KERF_SIMD_FUNCTION std::experimental::simd<R, A> reciprocal(
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
KERF_SIMD_FUNCTION std::experimental::simd<R, A> reciprocal_square_root(
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

// Exact to the last digit or two. Where the processor has no estimate, the inverse is sqrt(a) times
// 1 / a, which are computed side by side, instead of a division that waits for the root.
template <class R, class A>
KERF_SIMD_FUNCTION RootAndInverse<std::experimental::simd<R, A>> root_and_inverse(
    const std::experimental::simd<R, A>& a) {
#if defined(__AVX512F__)
  if constexpr (std::is_same_v<R, float> && std::experimental::simd<R, A>::size() == 16) {
    const auto inverse = reciprocal_square_root(a);
    return {a * inverse, inverse};
  }
#endif
  const auto root = std::experimental::sqrt(a);
  return {root, root * (R(1) / a)};
}

}  // namespace kerf
