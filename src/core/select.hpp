// SPDX-License-Identifier: Apache-2.0
// These functions choose without a branch, so that a formula written once runs on one number or on
// a SIMD register (core/simd_numbers.hpp has the same functions for registers).
#pragma once

#include <cmath>

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
  return T(1) / std::sqrt(a);
}

}  // namespace kerf

#if defined(KERF_SIMD)
#include "core/simd_numbers.hpp"
#endif
