// SPDX-License-Identifier: Apache-2.0
// Principal frames reproduce the tensor, and Eigen's iterative solver finds the same values.
#include "core/principal_frame.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

namespace kerf::test {
namespace {

template <int D, class T>
SymmetricTensor<D, T> random_tensor(std::mt19937& engine) {
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  SymmetricTensor<D, T> s;
  for (T& entry : s.component) entry = static_cast<T>(uniform(engine));
  return s;
}

// Each of some 12 rotations adds a rounding of the largest value to an entry.
template <int D, class T>
void expect_frame(const SymmetricTensor<D, T>& s, T largest) {
  const T tolerance = T(12) * std::numeric_limits<T>::epsilon();
  const auto frame = PrincipalFrame<D, T>::of(s);
  const auto again = frame.tensor(frame.value);
  for (int k = 0; k < SymmetricTensor<D, T>::count; ++k)
    EXPECT_NEAR(again.component[k], s.component[k], tolerance * largest);
  for (int k = 0; k < D; ++k)
    for (int l = 0; l < D; ++l) {
      T product = T(0);
      for (int a = 0; a < D; ++a) product += frame.axes(a, k) * frame.axes(a, l);
      EXPECT_NEAR(product, k == l ? T(1) : T(0), tolerance);
    }
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
  matrix(2, 2) = static_cast<double>(s(2, 2));
  for (int a = 0; a < D; ++a)
    for (int b = 0; b < D; ++b) matrix(a, b) = static_cast<double>(s(a, b));
  const Eigen::Vector3d expected =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(matrix).eigenvalues();
  Vector<3, T> values = frame.value;
  std::sort(values.component, values.component + 3);
  for (int a = 0; a < 3; ++a)
    EXPECT_NEAR(static_cast<double>(values[a]), expected[a],
                static_cast<double>(tolerance * largest));
}

template <class Case>
class Frame : public testing::Test {};
template <int dimension, class Number>
struct Of {
  static constexpr int D = dimension;
  using T = Number;
};
using Cases = testing::Types<Of<2, float>, Of<2, double>, Of<3, float>, Of<3, double>>;
TYPED_TEST_SUITE(Frame, Cases);

TYPED_TEST(Frame, ReproducesTheTensor) {
  constexpr int D = TypeParam::D;
  using T = typename TypeParam::T;
  std::mt19937 engine(1);
  for (int n = 0; n < 1000; ++n)
    for (T size : {T(1), T(1e-6)}) expect_frame<D, T>(size * random_tensor<D, T>(engine), size);
}

// Two or three values are nearly equal: the closed forms fail here.
TYPED_TEST(Frame, HandlesNearlyEqualValues) {
  constexpr int D = TypeParam::D;
  using T = typename TypeParam::T;
  std::mt19937 engine(2);
  for (T little : {T(0), T(1e-7), T(1e-4)})
    for (int n = 0; n < 200; ++n) {
      auto s = little * random_tensor<D, T>(engine);
      for (int a = 0; a < 3; ++a) s(a, a) += a == 0 && n % 2 ? T(0.5) : T(1);
      expect_frame<D, T>(s, T(1));
    }
}

TYPED_TEST(Frame, HandlesTheZeroTensor) {
  constexpr int D = TypeParam::D;
  using T = typename TypeParam::T;
  const auto frame = PrincipalFrame<D, T>::of(SymmetricTensor<D, T>::zero());
  for (int a = 0; a < 3; ++a) EXPECT_EQ(frame.value[a], T(0));
  for (int a = 0; a < D; ++a) EXPECT_EQ(frame.axes(a, a), T(1));
}

}  // namespace
}  // namespace kerf::test
