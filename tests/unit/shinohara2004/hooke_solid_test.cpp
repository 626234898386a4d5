// SPDX-License-Identifier: Apache-2.0
// Hooke's law with the Jaumann rate against closed forms.
#include "shinohara2004/hooke_solid.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

#include "support/mixture.hpp"

namespace kerf::test {
namespace {

Medium<double> tofu() {
  Medium<double> solid = mixture_solid(2e-3, 2, 0);
  solid.bulk_modulus = 1e5 / (3.0 * (1.0 - 2.0 * 0.3));
  solid.shear_modulus = 1e5 / (2.0 * (1.0 + 0.3));
  return solid;
}

// Integrates the stress at a constant velocity gradient by the classical Runge-Kutta rule.
template <int D>
SymmetricTensor<D, double> stress_after(const Matrix<D, double>& gradient, double time,
                                        SymmetricTensor<D, double> s) {
  using Stress = SymmetricTensor<D, double>;
  const auto rate = [&](const Stress& stress) {
    return HookeSolid::shear_rate(tofu(), stress, gradient,
                                  SkewTensor<D, double>::part_of(gradient));
  };
  constexpr int steps = 2000;
  const double dt = time / steps;
  for (int n = 0; n < steps; ++n) {
    const Stress k1 = rate(s);
    const Stress k2 = rate(s + 0.5 * dt * k1);
    const Stress k3 = rate(s + 0.5 * dt * k2);
    const Stress k4 = rate(s + dt * k3);
    s += dt / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
  }
  return s;
}

// Simple shear dv_x/dy = g: s_xy = G sin(gt), s_xx = -s_yy = G (1 - cos gt) (Dienes, Acta Mech. 32
// (1979) 217), at large shear as at small.
template <int D>
void expect_simple_shear() {
  auto gradient = Matrix<D, double>::zero();
  gradient(0, 1) = 40.0;
  const double g = tofu().shear_modulus;
  for (double shear : {1e-4, 0.1, 1.0, 3.0}) {
    const auto s = stress_after(gradient, shear / 40.0, SymmetricTensor<D, double>::zero());
    EXPECT_NEAR(s(0, 1), g * std::sin(shear), 1e-9 * g * shear);
    EXPECT_NEAR(s(0, 0), g * (1.0 - std::cos(shear)), 1e-9 * g * shear);
    EXPECT_NEAR(s(1, 1), -s(0, 0), 1e-12 * g);
    EXPECT_NEAR(s(2, 2), 0.0, 1e-12 * g);
  }
}
TEST(HookeSolid, SimpleShear2D) {
  expect_simple_shear<2>();
}
TEST(HookeSolid, SimpleShear3D) {
  expect_simple_shear<3>();
}

// Uniaxial strain: s_xx = 4/3 G e, s_yy = s_zz = -2/3 G e; with the pressure of the compression
// 1 / (1 + e) - 1 the axial stress is (K + 4G/3) e for a small strain.
template <int D>
void expect_uniaxial(int axis) {
  auto gradient = Matrix<D, double>::zero();
  gradient(axis, axis) = 10.0;
  const double strain = 1e-5;
  const auto s = stress_after(gradient, strain / 10.0, SymmetricTensor<D, double>::zero());
  const auto solid = tofu();
  const double g = solid.shear_modulus;
  for (int a = 0; a < 3; ++a)
    EXPECT_NEAR(s(a, a), (a == axis ? 4.0 : -2.0) / 3.0 * g * strain, 1e-9 * g * strain);
  const double p = HookeSolid::pressure(solid, 1.0 / (1.0 + strain) - 1.0, false);
  const double modulus = solid.bulk_modulus + 4.0 / 3.0 * g;
  EXPECT_NEAR(s(axis, axis) - p, modulus * strain, 2.0 * strain * modulus * strain);
}
TEST(HookeSolid, UniaxialStrain) {
  expect_uniaxial<2>(0);
  expect_uniaxial<2>(1);
  expect_uniaxial<3>(2);
}

// In plane strain the stress out of the plane is that of three dimensions with e_zz = 0, and s has
// no trace.
TEST(HookeSolid, PlaneStrainKeepsTheStressOutOfThePlane) {
  Matrix<2, double> plane;
  Matrix<3, double> space = Matrix<3, double>::zero();
  const double entries[] = {3.0, -4.0, 7.0, 2.0};
  for (int a = 0; a < 2; ++a)
    for (int b = 0; b < 2; ++b) plane(a, b) = space(a, b) = entries[2 * a + b];
  const auto s2 = stress_after(plane, 0.1, SymmetricTensor<2, double>::zero());
  const auto s3 = stress_after(space, 0.1, SymmetricTensor<3, double>::zero());
  const double g = tofu().shear_modulus;
  EXPECT_NEAR(s2(2, 2), -2.0 / 3.0 * g * 5.0 * 0.1, 1e-9 * g);
  for (int a = 0; a < 3; ++a) EXPECT_NEAR(s2(a, a), s3(a, a), 1e-12 * g);
  EXPECT_NEAR(s2(0, 1), s3(0, 1), 1e-12 * g);
  EXPECT_NEAR(s2(0, 0) + s2(1, 1) + s2(2, 2), 0.0, 1e-12 * g);
}

// The rate equals that of matrix algebra, 2 G dev(e) + w s - s w with w s of the standard form.
TEST(HookeSolid, JaumannRateIsTheCommutatorWithTheSpin) {
  std::mt19937 engine(2);
  std::uniform_real_distribution<double> distribution(-1.0, 1.0);
  const auto uniform = [&] { return distribution(engine); };
  for (int trial = 0; trial < 20; ++trial) {
    const Matrix3 stress = 1e4 * random_deviator(3, uniform);
    Matrix3 l;
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b) l(a, b) = 100.0 * uniform();
    const Matrix3 e = 0.5 * (l + l.transpose()), w = 0.5 * (l - l.transpose());
    const Matrix3 due = 2.0 * tofu().shear_modulus * (e - e.trace() / 3.0 * Matrix3::Identity()) +
                        w * stress - stress * w;
    SymmetricTensor<3, double> s;
    Matrix<3, double> gradient;
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b) {
        s(a, b) = stress(a, b);
        gradient(a, b) = l(a, b);
      }
    const auto rate =
        HookeSolid::shear_rate(tofu(), s, gradient, SkewTensor<3, double>::part_of(gradient));
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b) EXPECT_NEAR(rate(a, b), due(a, b), 1e-13 * due.norm());
  }
}

TEST(HookeSolid, FracturedBearsCompressionOnly) {
  const auto solid = tofu();
  EXPECT_EQ(HookeSolid::pressure(solid, 0.02, true), solid.bulk_modulus * 0.02);
  EXPECT_EQ(HookeSolid::pressure(solid, -0.02, true), 0.0);
  EXPECT_EQ(HookeSolid::pressure(solid, -0.02, false), -solid.bulk_modulus * 0.02);
  EXPECT_EQ(HookeSolid::volumetric_energy(solid, -0.02, true), 0.0);
  EXPECT_GT(HookeSolid::volumetric_energy(solid, -0.02, false), 0.0);
}

// The energy is half of stress times elastic strain, s : s / 4G per volume.
TEST(HookeSolid, DeviatoricEnergy) {
  SymmetricTensor<2, double> s = SymmetricTensor<2, double>::zero();
  s(0, 1) = 300.0;
  const auto solid = tofu();
  const double strain = 300.0 / (2.0 * solid.shear_modulus);  // e_xy
  // Two entries, xy and yx; at a compression of 3 %.
  EXPECT_NEAR(HookeSolid::deviatoric_energy(solid, s, 0.03),
              0.5 * 2.0 * 300.0 * strain / (solid.density * 1.03),
              1e-14 * 300.0 * strain / solid.density);
}

}  // namespace
}  // namespace kerf::test
