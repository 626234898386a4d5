// SPDX-License-Identifier: Apache-2.0
#include "machine/contraction.hpp"

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <numbers>

namespace kerf {

double contraction(double angle) {
  constexpr double pi = std::numbers::pi;
  const auto turn = [angle](double theta) {
    return std::sin(angle * theta / pi) / std::tan(0.5 * theta);
  };
  using Rule = boost::math::quadrature::gauss_kronrod<double, 61>;
  return 1.0 / (1.0 + Rule::integrate(turn, 0.0, pi, 5, 1e-12) / pi);
}

}  // namespace kerf
