// SPDX-License-Identifier: Apache-2.0
#include "machine/contraction.hpp"

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <numbers>

namespace kerf {

namespace {

constexpr double pi = std::numbers::pi;

// C_c with the source at t_0; 0 = a vessel without walls.
double contraction_with_source(double angle, double source) {
  const auto turn = [angle, source](double theta) {
    // Over (t_0 + 1/t_0) / 2 - cos theta, both multiplied by 2 t_0.
    const double supplied =
        2.0 * source * std::sin(theta) / (1.0 + source * (source - 2.0 * std::cos(theta)));
    return std::sin(angle * theta / pi) * (1.0 / std::tan(0.5 * theta) - supplied);
  };
  using Rule = boost::math::quadrature::gauss_kronrod<double, 61>;
  return 1.0 / (1.0 + Rule::integrate(turn, 0.0, pi, 5, 1e-12) / pi);
}

}  // namespace

double contraction(double angle, double share) {
  double result = contraction_with_source(angle, 0.0);
  if (share == 0.0) return result;
  // Each step reduces the error by a factor of at most about `share`.
  for (double last = 0.0; std::abs(result - last) > 1e-12;) {
    last = result;
    result = contraction_with_source(angle, std::pow(last * share, pi / angle));
  }
  return result;
}

}  // namespace kerf
