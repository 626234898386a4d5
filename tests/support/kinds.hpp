// SPDX-License-Identifier: Apache-2.0
// The kinds of engine that typed tests are compiled for: dimension and precision.
#pragma once

#include <gtest/gtest.h>

#include <type_traits>

#include "core/precision.hpp"

namespace kerf::test {

template <int D_, class P_>
struct Kind {
  static constexpr int D = D_;
  using P = P_;
  using Real = typename P::Real;
  // Rounding error of one sum over the bonds of a particle.
  static constexpr double rounding = std::is_same_v<Real, float> ? 4e-6 : 1e-14;
};

// Most of what a typed test costs is to compile it for each kind. By default a list has each
// dimension and each precision once, and the two lists have all four kinds; with KERF_ALL_KINDS=ON
// each list has all four.
#if defined(KERF_ALL_KINDS)
using TwoKinds = testing::Types<Kind<2, Double>, Kind<3, Double>, Kind<2, Mixed>, Kind<3, Mixed>>;
using OtherTwoKinds = TwoKinds;
#else
using TwoKinds = testing::Types<Kind<2, Double>, Kind<3, Mixed>>;
using OtherTwoKinds = testing::Types<Kind<2, Mixed>, Kind<3, Double>>;
#endif

}  // namespace kerf::test
