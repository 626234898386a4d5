// SPDX-License-Identifier: Apache-2.0
// The energy that a break of bonds reports, against sums over the solid before and after.
#include <gtest/gtest.h>

#include <algorithm>

#include "support/solid_blocks.hpp"

namespace kerf::test {
namespace {

template <class Chosen>
class BondBreakEnergy : public testing::Test {
 protected:
  static constexpr int D = Chosen::D;
  using Trial = SolidOnTrial<D, typename Chosen::P>;

  struct Sums {
    double energy;
    std::uint64_t bonds;
    Index detached;
  };
  static Sums measure(Trial& trial) {
    const auto [bonds, detached] = trial.solid.count();
    return {trial.solid.energy().total() + trial.solid.softening_work(), bonds, detached};
  }
  // Stretches a zone in the middle along x and adds random displacements; moves the rest rigidly.
  static void pull(Trial& trial, double stretch) {
    std::mt19937 engine(4);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    for (std::size_t i = 0; i < trial.size(); ++i) {
      auto x = trial.layout.reference[i];
      const double zone = std::clamp(x[0] - 5e-3, 0.0, 3e-3);
      x[0] += stretch * zone;
      if (zone > 0.0 && zone < 3e-3) x[1] += 4e-4 * stretch * uniform(engine);
      trial.position[i] = x;
      for (int a = 0; a < D; ++a)
        trial.velocity[i][a] = static_cast<typename Chosen::Real>(uniform(engine));
    }
    trial.evaluate();
  }
};
TYPED_TEST_SUITE(BondBreakEnergy, TwoKinds);

TYPED_TEST(BondBreakEnergy, EqualsTheChangeOfTheSums) {
  for (const auto criterion : {BondCriterion::principal_strain, BondCriterion::crack_band}) {
    auto medium = soft_solid(1e-3, TypeParam::D);
    medium.criterion = criterion;
    medium.failure_strain = 0.1;
    if (criterion == BondCriterion::crack_band) medium.softening_strain = 0.04;
    typename TestFixture::Trial trial(
        block<TypeParam::D>({.cells = {14, 8, 6}, .jitter = 0.1, .seed = 5}, medium));
    std::uint64_t broken = 0;
    Index detached = 0;
    for (const double stretch : {0.05, 0.1, 0.12, 0.2, 0.5}) {
      this->pull(trial, stretch);
      const auto before = this->measure(trial);
      const FractureResult result = trial.solid.fracture();
      const auto after = this->measure(trial);
      broken += result.bonds;
      detached += result.detached;
      EXPECT_EQ(result.bonds, before.bonds - after.bonds);
      EXPECT_EQ(result.detached, after.detached - before.detached);
      EXPECT_NEAR(result.released, before.energy - after.energy,
                  TypeParam::rounding * before.energy);
    }
    EXPECT_GT(broken, 100u);
    EXPECT_GT(detached, 0u);
    EXPECT_LT(detached, trial.size());
  }
}

// In a run the whole step is without the bonds that break in its middle: what they release is the
// energy at its start. It falls there too.
TYPED_TEST(BondBreakEnergy, IsThatAtTheStartOfTheStep) {
  auto medium = soft_solid(1e-3, TypeParam::D);
  medium.criterion = BondCriterion::principal_strain;
  medium.failure_strain = 0.1;
  typename TestFixture::Trial trial(
      block<TypeParam::D>({.cells = {14, 8, 6}, .jitter = 0.1, .seed = 5}, medium));
  const double half_step = 1e-4;  // s: some per cent of strain at the velocities of pull(), 1 m/s
  std::uint64_t broken = 0;
  for (const double stretch : {0.12, 0.2, 0.4}) {
    this->pull(trial, stretch);
    const auto middle = trial.position;
    auto start = middle;
    for (std::size_t i = 0; i < trial.size(); ++i)
      start[i] -= half_step * Vector<TypeParam::D, double>::from(trial.velocity[i]);
    const auto energy_at_start = [&] {
      trial.position = start;
      trial.deform();
      return trial.solid.energy().total();
    };
    const double before = energy_at_start();
    trial.position = middle;
    trial.evaluate();
    const FractureResult result = trial.solid.fracture(half_step);
    const double after = energy_at_start();
    broken += result.bonds;
    EXPECT_NEAR(result.released, before - after, 10.0 * TypeParam::rounding * before);
    EXPECT_GE(result.released, 0.0);
  }
  EXPECT_GT(broken, 100u);
}

}  // namespace
}  // namespace kerf::test
