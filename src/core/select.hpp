// SPDX-License-Identifier: Apache-2.0
// Choices without a branch, so that a formula written once runs on one number, or on several side
// by side (lanes/lane_numbers.hpp has the same functions for those).
#pragma once

#include <cmath>

#include "exec/host_device.hpp"

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

}  // namespace kerf

#if defined(KERF_LANES)
#include "lanes/lane_numbers.hpp"
#endif
