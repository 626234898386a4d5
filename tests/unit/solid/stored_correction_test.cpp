// SPDX-License-Identifier: Apache-2.0
// What a particle stores of its gradient correction is as exact as it says, in 36 bytes in 3D.
#include "solid/stored_correction.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace kerf::test {
namespace stored_correction_test {
namespace {

// Returns the largest relative error of a component over random symmetric tensors of any size.
template <int D, class Real>
double largest_error() {
  std::mt19937 engine(7);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0), exponent(-12.0, 12.0);
  double worst = 0.0;
  for (int n = 0; n < 10000; ++n) {
    Matrix<D, double> m;
    for (int a = 0; a < D; ++a)
      for (int b = 0; b <= a; ++b)
        m(a, b) = m(b, a) = uniform(engine) * std::pow(10.0, exponent(engine));
    const auto back = StoredCorrection<D, Real>::from(m).matrix();
    for (int k = 0; k < D * D; ++k)
      worst = std::max(worst, std::abs(back.component[k] / m.component[k] - 1.0));
  }
  return worst;
}

TEST(StoredCorrection, HasTwelveDigits) {
  EXPECT_LT((largest_error<2, float>()), 2e-12);
  EXPECT_LT((largest_error<3, float>()), 2e-12);
  EXPECT_EQ((largest_error<3, double>()), 0.0);
}

TEST(StoredCorrection, OfZeroIsZero) {
  const auto back = StoredCorrection<3, float>::from(Matrix<3, double>::zero()).matrix();
  for (const double number : back.component) EXPECT_EQ(number, 0.0);
}

TEST(StoredCorrection, TakesSixBytesPerNumber) {
  EXPECT_EQ(sizeof(StoredCorrection<3, float>), 36u);
}

}  // namespace
}  // namespace stored_correction_test
}  // namespace kerf::test
