// SPDX-License-Identifier: Apache-2.0
// FixedPointScale converts positions to those of packed particles. In single precision they are
// fixed-point coordinates: integers in a unit of 2^-24 of the finest spacing or a little less,
// a power of two of a metre. They are integers that wrap around, so that differences of neighbours
// are exact anywhere in space.
#pragma once

#include <cmath>
#include <cstdint>
#include <type_traits>

#include "core/host_device.hpp"

namespace kerf {

template <class Real>
struct PackedNumber {
  using Position = Real;
};
template <>
struct PackedNumber<float> {
  using Position = std::int32_t;
};

template <class Real>
struct FixedPointScale {
  double unit = 1.0;  // m

  static FixedPointScale of_spacing(double finest) {
    return {std::is_same_v<Real, float> ? std::exp2(std::floor(std::log2(finest)) - 24.0) : 1.0};
  }
  // Rounds a difference of positions; that of the opposite sign is the opposite.
  Real rounded(double difference) const {
    return static_cast<Real>(std::is_same_v<Real, float> ? unit * std::round(difference / unit)
                                                         : difference);
  }
  KERF_FUNCTION typename PackedNumber<Real>::Position pack(double x) const {
    if constexpr (std::is_same_v<Real, float>)
      return static_cast<std::int32_t>(
          static_cast<std::uint32_t>(static_cast<std::int64_t>(std::floor(x / unit + 0.5))));
    else
      return x;
  }
};

}  // namespace kerf
