// SPDX-License-Identifier: Apache-2.0
// The kernel against the printed polynomials, quadrature and finite differences.
#include "kernels/cubic_spline.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/reference_sph.hpp"

namespace kerf::test {
namespace {

template <class Dimension>
class Kernel : public testing::Test {
 protected:
  static constexpr int D = Dimension::value;
  static double value(double r, double h) { return CubicSpline<D>::value(r, h); }
  static double slope(double r, double h) { return CubicSpline<D>::derivative(r, h); }
};
using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(Kernel, Dimensions);

const double lengths[] = {0.7, 1.0, 3e-3};

TYPED_TEST(Kernel, AsPrinted) {
  for (double h : lengths)
    for (int k = 0; k <= 250; ++k) {
      const double r = 0.01 * k * h;
      const double top = paper_kernel(0.0, h, TestFixture::D);
      EXPECT_NEAR(TestFixture::value(r, h), paper_kernel(r, h, TestFixture::D), 1e-14 * top);
      EXPECT_NEAR(TestFixture::slope(r, h), paper_kernel_slope(r, h, TestFixture::D),
                  1e-14 * top / h);
    }
}

// The midpoint rule is over the square or cube that contains the support, not over the radius, so
// that it tests both the normalisation and the volume element.
TYPED_TEST(Kernel, IntegratesToOne) {
  constexpr int dimension = TestFixture::D;
  constexpr int cells = dimension == 2 ? 800 : 240;
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

// The same integral by Simpson's rule over the radius is exact up to rounding.
TYPED_TEST(Kernel, RadialIntegral) {
  const double h = 3e-3, pi = std::numbers::pi;
  const auto shell = [&](double r) {
    return TestFixture::value(r, h) * (TestFixture::D == 2 ? 2.0 * pi * r : 4.0 * pi * r * r);
  };
  double sum = 0.0;
  constexpr int cells = 2000;  // so that s = 1 is a node
  const double step = 2.0 * h / cells;
  for (int k = 0; k < cells; ++k)
    sum += step / 6.0 * (shell(k * step) + 4.0 * shell((k + 0.5) * step) + shell((k + 1) * step));
  EXPECT_NEAR(sum, 1.0, 1e-12);
}

TYPED_TEST(Kernel, SlopeIsTheDifferenceOfTheValue) {
  for (double h : lengths) {
    const double step = 1e-6 * h, scale = TestFixture::value(0.0, h) / h;
    for (int k = 1; k < 210; ++k) {
      const double r = 0.01 * k * h;
      const double difference =
          (TestFixture::value(r + step, h) - TestFixture::value(r - step, h)) / (2.0 * step);
      EXPECT_NEAR(TestFixture::slope(r, h), difference, 1e-8 * scale);
    }
  }
}

TYPED_TEST(Kernel, SmoothAtOneAndAtItsEnd) {
  const double h = 0.7, e = 1e-9;
  const double top = TestFixture::value(0.0, h), steep = top / h;
  EXPECT_NEAR(TestFixture::value(h * (1.0 - e), h), TestFixture::value(h * (1.0 + e), h),
              5.0 * e * top);
  EXPECT_NEAR(TestFixture::slope(h * (1.0 - e), h), TestFixture::slope(h * (1.0 + e), h),
              10.0 * e * steep);
  EXPECT_NEAR(TestFixture::slope(h * (2.0 - e), h), 0.0, 1e-14 * steep);
  EXPECT_EQ(TestFixture::slope(0.0, h), 0.0);
}

TYPED_TEST(Kernel, ZeroOutside) {
  for (double h : lengths)
    for (double s : {2.0, 2.0001, 3.0, 100.0}) {
      EXPECT_EQ(TestFixture::value(s * h, h), 0.0);
      EXPECT_EQ(TestFixture::slope(s * h, h), 0.0);
    }
}

// The kernel is repulsive at every distance: the slope is never positive, also in single precision.
TYPED_TEST(Kernel, FallsEverywhere) {
  for (int k = 0; k <= 4000; ++k) {
    const double r = 0.0005 * k;
    EXPECT_LE(TestFixture::slope(r, 1.0), 0.0) << r;
    EXPECT_LE(CubicSpline<TestFixture::D>::derivative(static_cast<float>(r), 1.0f), 1e-7f) << r;
    EXPECT_GE(TestFixture::value(r, 1.0), 0.0) << r;
  }
}

}  // namespace
}  // namespace kerf::test
