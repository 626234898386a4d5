// SPDX-License-Identifier: Apache-2.0
// Which bonds of a uniform strain a criterion breaks, over all directions.
#include "fracture/bond_criterion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace kerf::test {
namespace {

// The bond at an angle from x in the plane strain of principal Hencky strains `first`, `second`.
struct UniformStrain {
  double first, second;
  SolidMedium<double> solid;

  BondStrain<double> bond(double angle) const {
    auto green = SymmetricTensor<2, double>::zero();
    green(0, 0) = 0.5 * std::expm1(2.0 * first);
    green(1, 1) = 0.5 * std::expm1(2.0 * second);
    const double c = std::cos(angle), s = std::sin(angle);
    BondStrain<double> bond;
    bond.mean = bond.own = 2.0 * (c * c * green(0, 0) + s * s * green(1, 1));
    bond.prepared = prepare_criterion(solid, green);
    return bond;
  }
  int broken() const {  // of 180 directions, one a degree
    int count = 0;
    for (int degree = 0; degree < 180; ++degree)
      count += bond_breaks(bond((degree + 0.5) * std::numbers::pi / 180.0), solid);
    return count;
  }
};

SolidMedium<double> brittle(BondCriterion criterion, double limit) {
  SolidMedium<double> solid;
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
  // Pure shear: 2/sqrt(3) e.
  EXPECT_EQ((UniformStrain{0.0866, -0.0866, solid}.broken()), 0);
  // Stretched, e^(2e) cos^2 + e^(-2e) sin^2 > 1, within atan(e^e) = 47.5 degrees of x.
  EXPECT_EQ((UniformStrain{0.0867, -0.0867, solid}.broken()), 94);
}

TEST(BondCriterion, NoLimitNeverBreaks) {
  for (auto criterion : {BondCriterion::principal_strain, BondCriterion::equivalent_strain})
    EXPECT_EQ((UniformStrain{2.0, 2.0, brittle(criterion, 0.0)}.broken()), 0);
}

// The bond that spans a crack is longer than the smeared tensors say, that beside it is not.
TEST(BondCriterion, OnlyWhatOpensBreaks) {
  for (auto criterion : {BondCriterion::principal_strain, BondCriterion::equivalent_strain}) {
    const UniformStrain smeared{0.3, 0.0, brittle(criterion, 0.1)};
    auto bond = smeared.bond(0.0);
    bond.own = 0.01;
    EXPECT_FALSE(bond_breaks(bond, smeared.solid));
    bond.own = 1.0;
    EXPECT_TRUE(bond_breaks(bond, smeared.solid));
    const UniformStrain faint{0.02, 0.0, brittle(criterion, 0.1)};  // but far apart
    bond = faint.bond(1.0);
    bond.own = 1.0;
    EXPECT_TRUE(bond_breaks(bond, faint.solid));
  }
}

}  // namespace
}  // namespace kerf::test
