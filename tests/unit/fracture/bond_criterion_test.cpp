// SPDX-License-Identifier: Apache-2.0
// The bonds that a criterion breaks in a uniform strain, over all directions.
#include "fracture/bond_criterion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace kerf::test {
namespace {

// The bond at an angle from x in the plane strain of principal Hencky strains `first`, `second`.
struct UniformStrain {
  double first, second;
  BondedSolid<double> solid;

  SymmetricTensor<2, double> green() const {
    auto strain = SymmetricTensor<2, double>::zero();
    strain(0, 0) = 0.5 * std::expm1(2.0 * first);
    strain(1, 1) = 0.5 * std::expm1(2.0 * second);
    return strain;
  }
  BondStrain<double> bond(double angle) const {
    const double c = std::cos(angle), s = std::sin(angle);
    BondStrain<double> bond;
    bond.mean = bond.own = 2.0 * (c * c * green()(0, 0) + s * s * green()(1, 1));
    bond.prepared = prepared();
    return bond;
  }
  double prepared() const {
    return prepare_criterion(solid, ElasticParticle<2, double>{solid, green()});
  }
  int broken() const {  // number of 180 directions, 1 degree apart
    int count = 0;
    for (int degree = 0; degree < 180; ++degree)
      count += bond_breaks(bond((degree + 0.5) * std::numbers::pi / 180.0), solid);
    return count;
  }
};

BondedSolid<double> brittle(BondCriterion criterion, double limit) {
  BondedSolid<double> solid;
  solid.criterion = criterion;
  solid.failure_strain = limit;
  return solid;
}

TEST(BondCriterion, PrincipalStrain) {
  const auto solid = brittle(BondCriterion::principal_strain, 0.1);
  EXPECT_EQ((UniformStrain{0.0999, 0.0, solid}.broken()), 0);
  EXPECT_EQ((UniformStrain{0.1001, 0.0, solid}.broken()), 120);  // within 60 degrees of x
  EXPECT_EQ((UniformStrain{0.0, 0.1001, solid}.broken()), 120);  // of y
  EXPECT_EQ((UniformStrain{0.1001, 0.1001, solid}.broken()), 180);
  EXPECT_EQ((UniformStrain{-0.5, -0.5, solid}.broken()), 0);
  const int in_shear = UniformStrain{0.1001, -0.1001, solid}.broken();
  EXPECT_GT(in_shear, 60);
  EXPECT_LT(in_shear, 90);  // stretched ones only
}

TEST(BondCriterion, EquivalentStrain) {
  const auto solid = brittle(BondCriterion::equivalent_strain, 0.1);
  EXPECT_EQ((UniformStrain{0.1499, 0.0, solid}.broken()), 0);  // 2/3 e
  EXPECT_GT((UniformStrain{0.1501, 0.0, solid}.broken()), 170);
  EXPECT_EQ((UniformStrain{-0.3, 0.0, solid}.broken()), 0);  // no bond is stretched
  // Pure shear has 2/sqrt(3) e.
  EXPECT_EQ((UniformStrain{0.0866, -0.0866, solid}.broken()), 0);
  // Bonds are stretched, e^(2e) cos^2 + e^(-2e) sin^2 > 1, within atan(e^e) = 47.5 degrees of x.
  EXPECT_EQ((UniformStrain{0.0867, -0.0867, solid}.broken()), 94);
}

BondedSolid<double> strong(double strength) {
  BondedSolid<double> solid;
  solid.criterion = BondCriterion::principal_stress;
  solid.elasticity = ElasticLaw::st_venant_kirchhoff;
  solid.bulk_modulus = 1e9;
  solid.shear_modulus = 0.6e9;
  solid.principal_stress.tensile_strength = strength;
  return solid;
}

// Small strains: stress by Hooke, K + 4 G / 3 = 1.8 GPa and K - 2 G / 3 = 0.6 GPa, to a percent.
// Squeezed along y and free along x in plane strain, a solid breaks where it spreads by f_t / (2
// G).
TEST(BondCriterion, PrincipalStressLimitsTheSpreadOfASqueezedSolid) {
  const auto solid = strong(1e6);
  const double across = solid.lame() / (solid.lame() + 2.0 * solid.shear_modulus);
  const double limit = 1e6 / (2.0 * solid.shear_modulus) / across;
  EXPECT_EQ((UniformStrain{across * 0.99 * limit, -0.99 * limit, solid}.broken()), 0);
  EXPECT_GT((UniformStrain{across * 1.01 * limit, -1.01 * limit, solid}.broken()), 0);
}

TEST(BondCriterion, PrincipalStress) {
  const auto solid = strong(1.8e6);
  EXPECT_EQ((UniformStrain{0.99e-3, 0.0, solid}.broken()), 0);
  const int in_tension = UniformStrain{1.01e-3, 0.0, solid}.broken();
  EXPECT_GT(in_tension, 90);  // the bonds across the crack, not those along it
  EXPECT_LT(in_tension, 150);
  // If the other strain is equal, the stress is 2.4 GPa times it.
  EXPECT_EQ((UniformStrain{0.74e-3, 0.74e-3, solid}.broken()), 0);
  EXPECT_EQ((UniformStrain{0.76e-3, 0.76e-3, solid}.broken()), 180);
  // In pure shear it is 2 G times the strain.
  EXPECT_EQ((UniformStrain{1.48e-3, -1.48e-3, solid}.broken()), 0);
  EXPECT_GT((UniformStrain{1.52e-3, -1.52e-3, solid}.broken()), 45);
  EXPECT_EQ((UniformStrain{-0.1, -0.1, solid}.broken()), 0);
}

TEST(BondCriterion, StrainEnergy) {
  auto solid = brittle(BondCriterion::strain_energy, 0.1);
  solid.bulk_modulus = 1e9;
  solid.shear_modulus = 0.6e9;
  // Uniaxial strain stores M e^2 / 2: the limit is that strain.
  EXPECT_EQ((UniformStrain{0.0999, 0.0, solid}.broken()), 0);
  EXPECT_GT((UniformStrain{0.1001, 0.0, solid}.broken()), 90);
  // Both strains store (K + G / 3) e^2 per half; e = limit sqrt(1.8 / 4.8).
  EXPECT_EQ((UniformStrain{0.0611, 0.0611, solid}.broken()), 0);
  EXPECT_EQ((UniformStrain{0.0614, 0.0614, solid}.broken()), 180);
  // Compression stores no energy that opens a crack; the rest is G e^2.
  const double sheared = 0.1 * std::sqrt(1.8 / 1.2);
  EXPECT_EQ((UniformStrain{-0.3, -0.3, solid}.broken()), 0);
  EXPECT_NEAR((UniformStrain{sheared, -sheared, solid}.prepared()), 0.1, 1e-12);
}

TEST(BondCriterion, NoLimitNeverBreaks) {
  for (auto criterion : {BondCriterion::principal_strain, BondCriterion::equivalent_strain,
                         BondCriterion::strain_energy})
    EXPECT_EQ((UniformStrain{2.0, 2.0, brittle(criterion, 0.0)}.broken()), 0);
  EXPECT_EQ((UniformStrain{2.0, 2.0, strong(0.0)}.broken()), 0);
}

// The bond across a crack is longer than the smoothed tensors indicate, a bond beside it is not.
TEST(BondCriterion, OnlyStretchedBondsBreak) {
  for (auto criterion : {BondCriterion::principal_strain, BondCriterion::equivalent_strain}) {
    const UniformStrain smeared{0.3, 0.0, brittle(criterion, 0.1)};
    auto bond = smeared.bond(0.0);
    bond.own = 0.01;
    EXPECT_FALSE(bond_breaks(bond, smeared.solid));
    bond.own = 1.0;
    EXPECT_TRUE(bond_breaks(bond, smeared.solid));
    const UniformStrain faint{0.02, 0.0, brittle(criterion, 0.1)};  // but with a long bond
    bond = faint.bond(1.0);
    bond.own = 1.0;
    EXPECT_TRUE(bond_breaks(bond, faint.solid));
  }
}

}  // namespace
}  // namespace kerf::test
