// SPDX-License-Identifier: Apache-2.0
#include "machine/jet_speed.hpp"

#include <cmath>

namespace kerf {

namespace {
constexpr double power = 1.0 - compression_exponent;
}

double jet_speed(double pressure, double density) {
  // (1 + x)^p - 1 without the loss of digits where x is small.
  const double head = std::expm1(power * std::log1p(pressure / compression_pressure));
  return std::sqrt(2.0 * compression_pressure / (density * power) * head);
}

double pump_pressure(double speed, double density) {
  const double head = speed * speed * density * power / (2.0 * compression_pressure);
  return compression_pressure * std::expm1(std::log1p(head) / power);
}

}  // namespace kerf
