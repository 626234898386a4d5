// SPDX-License-Identifier: Apache-2.0
// The Wendland kernel against quadrature, finite differences and its polynomial.
#include "kernels/wendland_c2.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace kerf::test {
namespace {

template <class Dimension>
class Wendland : public testing::Test {
 protected:
  static double value(double r, double h) { return WendlandC2<Dimension::value>::value(r, h); }
  static double slope(double r, double h) { return WendlandC2<Dimension::value>::derivative(r, h); }
};
using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(Wendland, Dimensions);

// Simpson's rule over shells assumes the volume element.
TYPED_TEST(Wendland, RadialIntegral) {
  const double h = 3e-3, pi = std::numbers::pi;
  const auto shell = [&](double r) {
    return TestFixture::value(r, h) * (TypeParam::value == 2 ? 2.0 * pi * r : 4.0 * pi * r * r);
  };
  double sum = 0.0;
  constexpr int cells = 2000;
  const double step = 2.0 * h / cells;
  for (int k = 0; k < cells; ++k)
    sum += step / 6.0 * (shell(k * step) + 4.0 * shell((k + 0.5) * step) + shell((k + 1) * step));
  EXPECT_NEAR(sum, 1.0, 1e-12);
}

// The midpoint rule over a square or cube does not assume it.
TYPED_TEST(Wendland, IntegratesToOne) {
  constexpr int dimension = TypeParam::value, cells = dimension == 2 ? 800 : 160;
  const double h = 0.7, step = 4.0 * h / cells;
  double sum = 0.0;
  for (int i = 0; i < cells; ++i)
    for (int j = 0; j < cells; ++j)
      for (int k = 0; k < (dimension == 3 ? cells : 1); ++k) {
        const double x = -2.0 * h + (i + 0.5) * step, y = -2.0 * h + (j + 0.5) * step;
        const double z = dimension == 3 ? -2.0 * h + (k + 0.5) * step : 0.0;
        sum += TestFixture::value(std::sqrt(x * x + y * y + z * z), h);
      }
  EXPECT_NEAR(sum * std::pow(step, dimension), 1.0, 1e-6);
}

TYPED_TEST(Wendland, SlopeIsTheDifferenceOfTheValue) {
  for (double h : {0.7, 1.0, 3e-3}) {
    const double step = 1e-6 * h, scale = TestFixture::value(0.0, h) / h;
    for (int k = 1; k < 210; ++k) {
      const double r = 0.01 * k * h;
      const double difference =
          (TestFixture::value(r + step, h) - TestFixture::value(r - step, h)) / (2.0 * step);
      EXPECT_NEAR(TestFixture::slope(r, h), difference, 1e-8 * scale);
      EXPECT_NEAR(-TestFixture::slope(r, h) / r,
                  WendlandC2<TypeParam::value>::slope_per_distance(r, h), 1e-14 * scale / h);
    }
  }
}

TYPED_TEST(Wendland, VanishesFromItsSupportOn) {
  for (double s : {2.0, 2.0001, 3.0, 100.0}) {
    EXPECT_EQ(TestFixture::value(s * 0.7, 0.7), 0.0);
    EXPECT_EQ(TestFixture::slope(s * 0.7, 0.7), 0.0);
  }
  EXPECT_EQ(TestFixture::slope(0.0, 0.7), 0.0);
}

// h^D W at the centre: 7/(4 pi) and 21/(16 pi); at q = 1, (1/2)^4 3 of it.
TYPED_TEST(Wendland, AsPublished) {
  const double pi = std::numbers::pi, h = 0.7;
  const double top = (TypeParam::value == 2 ? 7.0 / (4.0 * pi) : 21.0 / (16.0 * pi)) /
                     std::pow(h, TypeParam::value);
  EXPECT_NEAR(TestFixture::value(0.0, h), top, 1e-14 * top);
  EXPECT_NEAR(TestFixture::value(h, h), 3.0 / 16.0 * top, 1e-14 * top);
}

}  // namespace
}  // namespace kerf::test
