// SPDX-License-Identifier: Apache-2.0
// Places as records for lanes/ hold them. In single precision they are whole numbers of a unit of
// 2^-24 of the finest spacing or a little less, a power of two of a metre, counted round as a clock
// does: differences of neighbours are exact, wherever in space they are.
#pragma once

#include <cmath>
#include <cstdint>
#include <type_traits>

#include "exec/host_device.hpp"

namespace kerf {

template <class Real>
struct PackedNumber {
  using Place = Real;
};
template <>
struct PackedNumber<float> {
  using Place = std::int32_t;
};

template <class Real>
struct PlaceUnit {
  double unit = 1.0;  // m

  static PlaceUnit of_spacing(double finest) {
    return {std::is_same_v<Real, float> ? std::exp2(std::floor(std::log2(finest)) - 24.0) : 1.0};
  }
  // A difference of places; that of the opposite sign is the opposite.
  Real rounded(double apart) const {
    return static_cast<Real>(std::is_same_v<Real, float> ? unit * std::round(apart / unit) : apart);
  }
  KERF_FUNCTION typename PackedNumber<Real>::Place pack(double x) const {
    if constexpr (std::is_same_v<Real, float>)
      return static_cast<std::int32_t>(
          static_cast<std::uint32_t>(static_cast<std::int64_t>(std::floor(x / unit + 0.5))));
    else
      return x;
  }
};

}  // namespace kerf
