// SPDX-License-Identifier: Apache-2.0
// StoredCorrection is a gradient correction B / V as a particle stores it: symmetric, and in single
// precision with what the rounding of each number took, in 2^-24 of that number. Together they have
// relative errors of 2e-12 in six bytes per number (solid/gradient_correction.hpp says why).
#pragma once

#include <cmath>
#include <cstdint>
#include <type_traits>

#include "core/matrix.hpp"

namespace kerf {

template <int D, class Real>
struct StoredCorrection {
  static constexpr int count = D * (D + 1) / 2;
  static constexpr bool is_rounded = std::is_same_v<Real, float>;
  static constexpr double parts = 32767.0;

  Real number[count];
  std::int16_t rest[is_rounded ? count : 1];

  KERF_FUNCTION static StoredCorrection from(const Matrix<D, double>& m) {
    StoredCorrection stored{};
    for (int a = 0, n = 0; a < D; ++a)
      for (int b = 0; b <= a; ++b, ++n) stored.set(n, 0.5 * (m(a, b) + m(b, a)));
    return stored;
  }
  KERF_FUNCTION Matrix<D, double> matrix() const {
    Matrix<D, double> m;
    for (int a = 0, n = 0; a < D; ++a)
      for (int b = 0; b <= a; ++b, ++n) {
        double value = double(number[n]);
        if constexpr (is_rounded) value += double(rest[n]) * unit_of(number[n]);
        m(a, b) = m(b, a) = value;
      }
    return m;
  }

 private:
  KERF_FUNCTION void set(int n, double value) {
    number[n] = static_cast<Real>(value);
    if constexpr (is_rounded) {
      const double unit = unit_of(number[n]), left = value - double(number[n]);
      if (unit > 0.0) rest[n] = static_cast<std::int16_t>(std::round(left / unit));
    }
  }
  // Half of a unit in the last place of a float is at most 2^-24 of it.
  KERF_FUNCTION static double unit_of(Real of) {
    return (of < Real(0) ? -double(of) : double(of)) * (0x1p-24 / parts);
  }
};

}  // namespace kerf
