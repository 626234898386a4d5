// SPDX-License-Identifier: Apache-2.0
// regula_falsi() finds the root of a function that falls from above zero: regula falsi, halving the
// value of an end that stays (the "Illinois" rule, Dowell & Jarratt, BIT 11 (1971) 168). It needs
// no slope, which the hardening of Johnson & Cook does not have at zero strain, never leaves its
// bracket, and takes one step where the function is a straight line.
#pragma once

#include <cmath>

#include "core/host_device.hpp"

namespace kerf {

// Returns x between 0 and `high` with |f(x)| <= accuracy; 0 where f(0) <= accuracy, and `high`
// where f(high) >= -accuracy.
template <class Function, class T>
KERF_FUNCTION T regula_falsi(const Function& f, T high, T accuracy) {
  T low = T(0), f_low = f(low);
  if (!(f_low > accuracy)) return low;
  T f_high = f(high);
  if (!(f_high < -accuracy)) return high;
  T x = low;
  int stayed = 0;  // 1: the low end stayed in the last step, -1: the high end
  for (int k = 0; k < 100; ++k) {
    x = low + (high - low) * (f_low / (f_low - f_high));
    const T value = f(x);
    if (!(std::abs(value) > accuracy) || !(low < x && x < high)) break;
    if (value < T(0)) {
      high = x, f_high = value;
      if (stayed == 1) f_low *= T(0.5);
      stayed = 1;
    } else {
      low = x, f_low = value;
      if (stayed == -1) f_high *= T(0.5);
      stayed = -1;
    }
  }
  return x;
}

}  // namespace kerf
