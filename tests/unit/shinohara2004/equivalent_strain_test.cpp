// SPDX-License-Identifier: Apache-2.0
// The equivalent strain against the principal strains that Eigen finds.
#include "shinohara2004/simple_fracture.hpp"

#include <gtest/gtest.h>

#include <random>

#include "support/mixture.hpp"

namespace kerf::test {
namespace {

// (sqrt(2)/3) sqrt[(e1-e2)^2 + (e2-e3)^2 + (e3-e1)^2] of the elastic strain s/2G + (pressure part).
double from_principal_strains(const Matrix3& shear, double shear_modulus, double volume_strain) {
  const Matrix3 strain = shear / (2.0 * shear_modulus) + volume_strain / 3.0 * Matrix3::Identity();
  const Vector3 e = Eigen::SelfAdjointEigenSolver<Matrix3>(strain).eigenvalues();
  return std::sqrt(2.0) / 3.0 *
         std::sqrt(std::pow(e[0] - e[1], 2) + std::pow(e[1] - e[2], 2) + std::pow(e[2] - e[0], 2));
}

template <int D, class T>
SymmetricTensor<D, T> packed(const Matrix3& s) {
  auto result = SymmetricTensor<D, T>::zero();
  for (int a = 0; a < 3; ++a) result(a, a) = static_cast<T>(s(a, a));
  for (int a = 0; a < D; ++a)
    for (int b = a + 1; b < D; ++b) result(a, b) = static_cast<T>(s(a, b));
  return result;
}

template <int D>
void expect_random_tensors() {
  std::mt19937 engine(D);
  std::uniform_real_distribution<double> distribution(-1.0, 1.0);
  const auto uniform = [&] { return distribution(engine); };
  const double g = 3.8e4;
  for (int trial = 0; trial < 200; ++trial) {
    const Matrix3 s = 8e3 * random_deviator(D, uniform);
    const double due = from_principal_strains(s, g, 0.1 * uniform());
    EXPECT_NEAR(equivalent_strain(packed<D, double>(s), g), due, 1e-13 * due);
    EXPECT_NEAR(equivalent_strain(packed<D, float>(s), static_cast<float>(g)), due, 1e-6 * due);
  }
}
TEST(EquivalentStrain, RandomTensors2D) {
  expect_random_tensors<2>();
}
TEST(EquivalentStrain, RandomTensors3D) {
  expect_random_tensors<3>();
}

// A bar stretched by e at constant volume has the equivalent strain e; simple shear by gamma has
// gamma / sqrt(3).
TEST(EquivalentStrain, KnownStates) {
  const double g = 1e4, e = 0.07;
  Matrix3 stretched = 2.0 * g * Vector3(e, -e / 2.0, -e / 2.0).asDiagonal().toDenseMatrix();
  EXPECT_NEAR(equivalent_strain(packed<2, double>(stretched), g), e, 1e-14);
  Matrix3 sheared = Matrix3::Zero();
  sheared(0, 1) = sheared(1, 0) = g * e;
  EXPECT_NEAR(equivalent_strain(packed<3, double>(sheared), g), e / std::sqrt(3.0), 1e-14);
}

}  // namespace
}  // namespace kerf::test
