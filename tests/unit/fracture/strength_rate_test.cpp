// SPDX-License-Identifier: Apache-2.0
// Strength that grows with the rate of strain: the law, the rate that it finds in a history of
// strain, and the limits of criteria that it multiplies.
#include "fracture/strength_rate.hpp"

#include <gtest/gtest.h>

#include <random>

#include "fracture/bond_criterion.hpp"
#include "fracture/softening.hpp"

namespace kerf::test {
namespace {

constexpr StrengthRate<double> law{0.2, 1e-2, 1e6};
constexpr double slow_strain = 0.1;

TEST(StrengthRate, GrowsAsAPowerBetweenItsBounds) {
  EXPECT_EQ(law.factor(0.0), 1.0);
  EXPECT_EQ(law.factor(1e-2), 1.0);
  EXPECT_NEAR(law.factor(1e3), 10.0, 1e-12);  // (10^5)^0.2
  EXPECT_NEAR(law.factor(1e6), std::pow(10.0, 1.6), 1e-12);
  EXPECT_EQ(law.factor(1e9), law.factor(1e6));
}

// Strains at a constant rate by random steps around `size`, as far as three times the slow limit.
void expect_rate(double rate, double size) {
  std::mt19937 engine(3);
  std::uniform_real_distribution<double> step(0.1, 3.0);
  Loading<double> loading;
  for (double time = 0.0; loading.strain < 3.0 * slow_strain;) {
    const double dt = step(engine) * size / rate;
    loading = law.advance(loading, rate * (time += dt), dt, slow_strain);
    if (loading.strain > 0.1 * slow_strain) {
      EXPECT_NEAR(loading.factor, law.factor(rate), 1e-9);
    }
  }
}
// Whatever the steps, also where the first one passes all limits.
TEST(StrengthRate, FindsAConstantRate) {
  for (const double rate : {1.0, 1e3, 1e5})
    for (const double size : {1e-3, 0.02, 0.5}) expect_rate(rate, size);
}

TEST(StrengthRate, FallsWhileALoadRestsAndStartsAnewAfterIt) {
  Loading<double> loading = law.advance({}, 0.09, 1e-4, slow_strain);  // 900 per second
  EXPECT_NEAR(loading.factor, law.factor(900.0), 1e-9);
  for (int n = 0; n < 100; ++n) loading = law.advance(loading, 0.09, 1e-4, slow_strain);
  EXPECT_NEAR(loading.factor, law.factor(0.08 / (0.08 / 900.0 + 1e-2)), 1e-9);
  EXPECT_EQ(law.advance(loading, 0.005, 1e-4, slow_strain).factor, 1.0);  // unloaded
  // Without time nothing is known of the rate.
  EXPECT_EQ(law.advance(loading, 0.5, 0.0, slow_strain).factor, loading.factor);
}

// An undamaged solid stays undamaged at a strain that it has borne, and a damaged one keeps its
// limits.
TEST(StrengthRate, OnlyStrainDamages) {
  Loading<double> loading = law.advance_softening({}, 0.3, 1e-4, slow_strain, 0.0);
  const double fast = loading.factor;
  EXPECT_NEAR(fast, law.factor(3e3), 2e-3 * fast);  // the onset counts from 0.01
  for (int n = 0; n < 5; ++n) loading = law.advance_softening(loading, 0.3, 10.0, slow_strain, 0.3);
  EXPECT_NEAR(loading.factor, 3.0, 1e-12);  // the slow factor is 1.2
  loading = law.advance_softening(loading, 0.4, 1e-9, slow_strain, 0.31);
  EXPECT_NEAR(loading.factor, 3.0, 1e-12);
}

// Limits that are R times as large: the dissipated energy int psi_t dD, by the trapezoidal rule, is
// R^2 times the loss of a slow test.
TEST(StrengthRate, TakesItsSquareOfTheEnergy) {
  BreakableSolid<double> slow;
  slow.bulk_modulus = 1e5;
  slow.shear_modulus = 5e4;
  slow.softening_strain = slow_strain;
  slow.failure_strain = 0.4;
  const double factor = 2.5;
  const auto psi = [&](double k) { return 0.5 * slow.young_modulus() * k * k; };
  double sum = 0.0, before = factor * slow_strain;
  for (int n = 1; n <= 3000; ++n) {
    const double k = factor * (slow_strain + 0.3 * n / 3000.0);
    sum += 0.5 * (psi(k) + psi(before)) *
           (undamaged_share(slow, before / factor) - undamaged_share(slow, k / factor));
    if (n % 1000 == 0) {
      EXPECT_NEAR(factor * factor * softening_loss(slow, k / factor), sum, 1e-6 * sum);
    }
    before = k;
  }
}

BondedSolid<double> solid_of(BondCriterion criterion) {
  BondedSolid<double> solid;
  solid.criterion = criterion;
  solid.bulk_modulus = 1e9;
  solid.shear_modulus = 0.6e9;
  solid.failure_strain = 1e-3;
  solid.principal_stress.tensile_strength = 1e6;
  if (criterion == BondCriterion::crack_band || criterion == BondCriterion::brittle_band)
    solid.softening_strain = 0.5e-3;
  return solid;
}
// The least uniaxial strain at which a bond along it breaks, by bisection.
double least_breaking_strain(const BondedSolid<double>& solid) {
  const auto breaks = [&](double strain) {
    auto green = SymmetricTensor<2, double>::zero();
    green(0, 0) = strain + 0.5 * strain * strain;
    BondStrain<double> bond;
    bond.mean = bond.own = 2.0 * green(0, 0);
    bond.prepared = prepare_criterion(solid, ElasticParticle<2, double>{solid, green});
    return bond_breaks(bond, solid);
  };
  double low = 0.0, high = 0.1;
  for (int n = 0; n < 60; ++n) (breaks(0.5 * (low + high)) ? high : low) = 0.5 * (low + high);
  return high;
}
TEST(StrengthRate, MultipliesTheLimitsOfEveryCriterion) {
  for (const auto criterion : {BondCriterion::principal_strain, BondCriterion::equivalent_strain,
                               BondCriterion::principal_stress, BondCriterion::strain_energy,
                               BondCriterion::crack_band, BondCriterion::brittle_band}) {
    const auto solid = solid_of(criterion);
    const double slow = least_breaking_strain(solid);
    EXPECT_NEAR(least_breaking_strain(solid.strengthened(3.0)), 3.0 * slow, 0.01 * slow)
        << int(criterion);
  }
  EXPECT_NEAR(solid_of(BondCriterion::principal_stress).slow_failure_strain(), 1e6 / 1.5e9, 1e-12);
  EXPECT_EQ(solid_of(BondCriterion::crack_band).slow_failure_strain(), 0.5e-3);
  EXPECT_EQ(solid_of(BondCriterion::strain_energy).slow_failure_strain(), 1e-3);
}

}  // namespace
}  // namespace kerf::test
