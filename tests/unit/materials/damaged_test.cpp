// SPDX-License-Identifier: Apache-2.0
// An elastic solid whose tension is reduced by damage.
#include "materials/damaged.hpp"

#include <gtest/gtest.h>

#include <random>

#include "support/solid_blocks.hpp"

namespace kerf::test {
namespace {

template <class T>
class Damaged : public testing::Test {};
TYPED_TEST_SUITE(Damaged, DoubleOnly);

template <int D>
SymmetricTensor<D, double> some_strain(std::mt19937& engine, double size) {
  std::uniform_real_distribution<double> uniform(-size, size);
  auto green = SymmetricTensor<D, double>::zero();
  for (int a = 0; a < D; ++a)
    for (int b = a; b < D; ++b) green(a, b) = uniform(engine);
  return green;
}

// S = d psi / dE by central differences, whose error is of second order in the step; an
// off-diagonal component counts twice.
TYPED_TEST(Damaged, StressIsTheDerivativeOfTheEnergy) {
  constexpr int D = TypeParam::D;
  const auto solid = soft_solid(1e-3, D);
  std::mt19937 engine(4);
  const double step = 1e-6, damage = 0.7;
  for (int trial = 0; trial < 50; ++trial) {
    const auto green = some_strain<D>(engine, 0.1);
    const auto stress = second_piola(solid, green, damage);
    for (int a = 0; a < D; ++a)
      for (int b = a; b < D; ++b) {
        auto more = green, less = green;
        more(a, b) += step;
        less(a, b) -= step;
        const double slope =
            (energy_density(solid, more, damage) - energy_density(solid, less, damage)) /
            (2.0 * step) / (a == b ? 1.0 : 2.0);
        EXPECT_NEAR(stress(a, b), slope, 1e-5 * solid.bulk_modulus);
      }
  }
}

// At small strain a fully damaged solid carries no uniaxial tension, and all of a compression.
TYPED_TEST(Damaged, CarriesCompressionOnly) {
  constexpr int D = TypeParam::D;
  const auto solid = soft_solid(1e-3, D);
  auto green = SymmetricTensor<D, double>::zero();
  green(0, 0) = 1e-5;
  const auto pulled = second_piola(solid, green, 1.0), undamaged = second_piola(solid, green);
  EXPECT_NEAR(pulled(0, 0), 0.0, 1e-4 * undamaged(0, 0));
  green(0, 0) = -1e-5;
  const auto pressed = second_piola(solid, green, 1.0);
  EXPECT_EQ(pressed(0, 0), second_piola(solid, green)(0, 0));
  EXPECT_EQ(energy_density(solid, green, 1.0), energy_density(solid, green));
  // In shear half of the energy is tensile.
  green = SymmetricTensor<D, double>::zero();
  green(0, 1) = 1e-5;
  EXPECT_NEAR(energy_density(solid, green, 1.0), 0.5 * energy_density(solid, green),
              1e-4 * energy_density(solid, green));
}

// The largest principal stress over E is the strain in a uniaxial stress.
TYPED_TEST(Damaged, ScalarStrainIsThatOfATensileTest) {
  const auto solid = soft_solid(1e-3, TypeParam::D);
  const double strain = 1e-6, nu = 0.3;
  const Vector<3, double> green{-nu * strain, strain, -nu * strain};
  EXPECT_NEAR(TensionLaw<double>::of(solid).scalar_strain(green), strain, 1e-5 * strain);
}

}  // namespace
}  // namespace kerf::test
