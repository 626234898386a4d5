// SPDX-License-Identifier: Apache-2.0
// These functions choose without a branch, so that a formula written once runs on one number or on
// a SIMD register (core/simd_numbers.hpp has the same functions for registers).
#pragma once

#include <cmath>
#include <type_traits>

#include "core/host_device.hpp"

namespace kerf {

template <class T>
KERF_FUNCTION T select(bool chosen, T a, T b) {
  return chosen ? a : b;
}
template <class T>
KERF_FUNCTION T maximum(T a, T b) {
  return a > b ? a : b;
}
template <class T>
KERF_FUNCTION T minimum(T a, T b) {
  return a < b ? a : b;
}
template <class T>
KERF_FUNCTION T magnitude(T a) {
  return std::abs(a);
}
template <class T>
KERF_FUNCTION T square_root(T a) {
  return std::sqrt(a);
}
template <class T>
KERF_FUNCTION T reciprocal(T a) {
  return T(1) / a;
}
template <class T>
KERF_FUNCTION T reciprocal_square_root(T a) {
#if defined(__CUDA_ARCH__)
  return rsqrt(a);
#else
  return T(1) / std::sqrt(a);
#endif
}
// Returns a - b. The difference of integers wraps around, as that of fixed-point coordinates must
// (simd/packed_position.hpp).
template <class T>
KERF_FUNCTION T wrapping_difference(T a, T b) {
  if constexpr (std::is_integral_v<T>) {
    using Unsigned = std::make_unsigned_t<T>;
    return static_cast<T>(static_cast<Unsigned>(a) - static_cast<Unsigned>(b));
  } else {
    return a - b;
  }
}

template <class Numbers>
struct RootAndInverse {
  Numbers root, inverse;  // sqrt(a), 1 / sqrt(a)
};
template <class T>
KERF_FUNCTION RootAndInverse<T> root_and_inverse(T a) {
  const T inverse = reciprocal_square_root(a);
  return {a * inverse, inverse};
}

}  // namespace kerf

#if defined(KERF_SIMD)
#include "core/simd_numbers.hpp"
#endif
