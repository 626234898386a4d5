// SPDX-License-Identifier: Apache-2.0
// Vectors and tensors against Eigen's.
#include "core/tensor.hpp"

#include <gtest/gtest.h>

#include <random>
#include <set>

#include "shinohara2004/artificial_stress.hpp"
#include "support/mixture.hpp"

namespace kerf::test {
namespace {

class Random {
 public:
  double operator()() { return distribution_(engine_); }

 private:
  std::mt19937 engine_{17};
  std::uniform_real_distribution<double> distribution_{-1.0, 1.0};
};

template <int D>
SymmetricTensor<D, double> packed(const Matrix3& s) {
  auto result = SymmetricTensor<D, double>::zero();
  for (int a = 0; a < 3; ++a) result(a, a) = s(a, a);
  for (int a = 0; a < D; ++a)
    for (int b = a + 1; b < D; ++b) result(b, a) = s(a, b);
  return result;
}

TEST(SymmetricTensor, EntriesAreDistinct) {
  std::set<int> places;
  for (int a = 0; a < 3; ++a)
    for (int b = a; b < 3; ++b) {
      const int place = SymmetricTensor<3, double>::index(a, b);
      EXPECT_EQ(place, (SymmetricTensor<3, double>::index(b, a)));
      EXPECT_TRUE(places.insert(place).second);
      EXPECT_LT(place, 6);
    }
  EXPECT_EQ((SymmetricTensor<2, double>::index(0, 1)), 3);
  EXPECT_EQ((SymmetricTensor<2, double>::index(2, 2)), 2);
}

template <int D>
void expect_skew_part() {
  Random random;
  Matrix<D, double> m;
  for (double& entry : m.component) entry = random();
  const auto w = SkewTensor<D, double>::part_of(m);
  for (int a = 0; a < D; ++a)
    for (int b = 0; b < D; ++b) EXPECT_EQ(w(a, b), 0.5 * (m(a, b) - m(b, a)));
}
TEST(SkewTensor, IsTheSkewPart) {
  expect_skew_part<2>();
  expect_skew_part<3>();
}

template <int D>
void expect_division() {
  using Square = Eigen::Matrix<double, D, D>;
  Random random;
  for (int trial = 0; trial < 100; ++trial) {
    Square root, y;
    for (int k = 0; k < D * D; ++k) root(k) = random(), y(k) = random();
    const Square m = root * root.transpose() + 0.2 * Square::Identity();
    Matrix<D, double> quotient, divisor;
    for (int a = 0; a < D; ++a)
      for (int b = 0; b < D; ++b) quotient(a, b) = y(a, b), divisor(a, b) = m(a, b);
    ASSERT_TRUE(divide(quotient, divisor, 0.1));
    const Square due = y * m.inverse();
    for (int a = 0; a < D; ++a)
      for (int b = 0; b < D; ++b) EXPECT_NEAR(quotient(a, b), due(a, b), 1e-12 * due.norm());
  }
}
TEST(Matrix, DividedByASymmetricOne) {
  expect_division<2>();
  expect_division<3>();
}

TEST(Matrix, DivisionByASingularMatrixFails) {
  Matrix<2, double> y, m;
  for (int k = 0; k < 4; ++k) y.component[k] = k + 1.0, m.component[k] = 1.0;
  EXPECT_FALSE(divide(y, m, 0.1));
  for (int k = 0; k < 4; ++k) EXPECT_EQ(y.component[k], k + 1.0);
}

// By the eigenvalues of Eigen, in frames turned at random.
template <int D>
void expect_division_by_eigenvalues() {
  using Square = Eigen::Matrix<double, D, D>;
  Random random;
  for (int trial = 0; trial < 200; ++trial) {
    Square any;
    for (int k = 0; k < D * D; ++k) any(k) = random();
    const Square turn = Eigen::HouseholderQR<Square>(any).householderQ();
    Eigen::Matrix<double, D, 1> values = Eigen::Matrix<double, D, 1>::Constant(0.6);
    const double least = 0.1;
    values[trial % D] = least * (trial % 2 == 0 ? 1.0 + 1e-9 : 1.0 - 1e-9);
    const Square m = turn * values.asDiagonal() * turn.transpose();
    Matrix<D, double> divisor, quotient = identity<D, double>();
    for (int a = 0; a < D; ++a)
      for (int b = 0; b < D; ++b) divisor(a, b) = m(a, b);
    EXPECT_EQ(divide(quotient, divisor, least), trial % 2 == 0) << m;
  }
}
TEST(Matrix, IsDividedByWhatHasEigenvaluesAboveTheLeastInAnyFrame) {
  expect_division_by_eigenvalues<2>();
  expect_division_by_eigenvalues<3>();
}

template <int D>
void expect_products() {
  Random random;
  const Matrix3 s = random_deviator(D, random), u = random_deviator(D, random);
  EXPECT_NEAR(contract(packed<D>(s), packed<D>(u)), s.cwiseProduct(u).sum(), 1e-14);
  Vector3 v = Vector3::Zero();
  Matrix3 gradient = Matrix3::Zero();
  Matrix<D, double> g;
  for (int a = 0; a < D; ++a) {
    v[a] = random();
    for (int b = 0; b < D; ++b) g(a, b) = gradient(a, b) = random();
  }
  EXPECT_NEAR(contract(packed<D>(s), g), s.cwiseProduct(gradient).sum(), 1e-14);
  EXPECT_NEAR(g.trace(), gradient.trace(), 1e-15);
  const auto product = packed<D>(s) * Vector<D, double>::from(v);
  for (int a = 0; a < D; ++a) EXPECT_NEAR(product[a], (s * v)[a], 1e-14);
  const auto sum = 2.0 * packed<D>(s) + packed<D>(u);
  for (int a = 0; a < 3; ++a) EXPECT_NEAR(sum(a, a), 2.0 * s(a, a) + u(a, a), 1e-15);
  EXPECT_NEAR(sum(0, 1), 2.0 * s(0, 1) + u(0, 1), 1e-15);
}
TEST(SymmetricTensor, ProductsIn2D) {
  expect_products<2>();
}
TEST(SymmetricTensor, ProductsIn3D) {
  expect_products<3>();
}

TEST(VectorOf, Algebra) {
  const Vector<3, double> u{{1.0, -2.0, 3.0}}, v{{4.0, 0.5, -1.0}};
  EXPECT_EQ(dot(u, v), 0.0);
  EXPECT_NEAR(norm(u + v), std::sqrt(dot(u, u) + dot(v, v)), 1e-15 * norm(u + v));
  const auto w = 2.0 * u - v;
  EXPECT_EQ(w[0], -2.0);
  EXPECT_EQ(w[1], -4.5);
  EXPECT_EQ(w[2], 7.0);
}

// For the positive part s+ of a tensor s, s+ and s - s+ are semidefinite of either sign and
// commute.
template <int D>
void expect_tensile_part(const Matrix3& s) {
  const auto part = tensile_part(packed<D>(s));
  Eigen::Matrix<double, D, D> positive, whole = s.topLeftCorner(D, D);
  for (int a = 0; a < D; ++a)
    for (int b = 0; b < D; ++b) positive(a, b) = part(a, b);
  using Solver = Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, D, D>>;
  const double size = whole.norm();
  EXPECT_GE(Solver(positive).eigenvalues().minCoeff(), -1e-7 * size);
  EXPECT_LE(Solver(whole - positive).eigenvalues().maxCoeff(), 1e-7 * size);
  EXPECT_LE((positive * (whole - positive)).norm(), 1e-7 * size * size);
}
TEST(TensilePart, RandomTensors) {
  Random random;
  for (int trial = 0; trial < 100; ++trial) {
    expect_tensile_part<2>(random_deviator(2, random));
    expect_tensile_part<3>(random_deviator(3, random));
  }
}
TEST(TensilePart, EqualPrincipalValues) {
  for (double z : {2.0, -1.0, 2.0 + 1e-14}) {
    const Matrix3 s = Vector3(2.0, 2.0, z).asDiagonal().toDenseMatrix();
    expect_tensile_part<3>(s);
    expect_tensile_part<2>(s);
  }
  expect_tensile_part<3>(Matrix3::Zero());
}

}  // namespace
}  // namespace kerf::test
