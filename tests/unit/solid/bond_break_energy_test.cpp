// SPDX-License-Identifier: Apache-2.0
// The energy and power that a break of bonds reports, against sums over the solid before and after.
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
    double energy, power;
    std::uint64_t bonds;
    Index detached;
  };
  static Sums measure(Trial& trial) {
    trial.solid.accelerate(trial.device_velocity);
    double power = 0.0;
    for (std::size_t i = 0; i < trial.size(); ++i)
      power += dot(trial.force(i), Vector<D, double>::from(trial.velocity[i]));
    const auto [bonds, detached] = trial.solid.count();
    return {trial.solid.energy().total() + trial.solid.softening_work(), power, bonds, detached};
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
TYPED_TEST_SUITE(BondBreakEnergy, BothPrecisions);

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
      const double scale = std::abs(before.power) + std::abs(after.power);
      EXPECT_NEAR(result.power_gain, after.power - before.power,
                  10.0 * TypeParam::rounding * scale);
    }
    EXPECT_GT(broken, 100u);
    EXPECT_GT(detached, 0u);
    EXPECT_LT(detached, trial.size());
  }
}

}  // namespace
}  // namespace kerf::test
