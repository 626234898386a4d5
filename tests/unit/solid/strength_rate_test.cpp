// SPDX-License-Identifier: Apache-2.0
// Blocks whose strength depends on the rate of strain (fracture/strength_rate.hpp).
#include "support/solid_blocks.hpp"

namespace kerf::test {
namespace {

template <int D>
Medium<double> rate_solid(BondCriterion criterion) {
  auto medium = soft_solid(1e-3, D);
  medium.criterion = criterion;
  medium.failure_strain = 0.01;
  if (criterion == BondCriterion::crack_band) {
    medium.softening_strain = 0.01;
    medium.failure_strain = 0.05;
  }
  medium.principal_stress.tensile_strength = 1e3;
  medium.strength_rate = {0.2, 1.0};
  return medium;
}

template <int D, class P>
void stretch_in_step(SolidOnTrial<D, P>& trial, double strain, double dt) {
  Square<D> map = Square<D>::Identity();
  map(0, 0) += strain;
  trial.map(map);
  trial.deform(dt);
}
template <int D, class P>
void end_step(SolidOnTrial<D, P>& trial) {
  trial.solid.keep_loading();
  trial.solid.keep_softening();
}

template <class T>
class StrengthRateOfSolid : public testing::Test {};
TYPED_TEST_SUITE(StrengthRateOfSolid, TwoKinds);

// Returns the uniform strain at which bonds break first in a block that is stretched at a rate.
template <int D, class P>
double strain_of_first_break(const Medium<double>& medium, double rate) {
  SolidOnTrial<D, P> trial(block<D>({.cells = {6, 5, 5}}, medium));
  const double step = 2e-5;
  for (int n = 1; n < 20000; ++n) {
    stretch_in_step(trial, n * step, step / rate);
    if (trial.solid.fracture().bonds > 0) return n * step;
    end_step(trial);
  }
  return 0.0;
}
// The strain, and with it the stress, of the first break grows as rate^n. k is that of a tensile
// test that stores as much as uniaxial strain does, and its rate higher by the square root of the
// moduli's ratio M / E = 1.346, whatever the rate. All strains are small.
TYPED_TEST(StrengthRateOfSolid, BreaksAtAStrainThatGrowsAsThePowerOfItsRate) {
  constexpr int D = TypeParam::D;
  for (const auto criterion : {BondCriterion::principal_strain, BondCriterion::principal_stress}) {
    auto medium = rate_solid<D>(criterion);
    using P = typename TypeParam::P;
    medium.strength_rate.exponent = 0.0;
    const double slow = strain_of_first_break<D, P>(medium, 1.0);
    medium.strength_rate.exponent = 0.2;
    for (const double rate : {10.0, 1000.0}) {
      const double fast = strain_of_first_break<D, P>(medium, rate);
      EXPECT_NEAR(fast / slow, std::pow(rate * std::sqrt(1.346), 0.2), 0.02 * std::pow(rate, 0.2));
    }
  }
}

// Softening begins at R e_0 and ends at R e_f: the stress of the block is that of the law.
TYPED_TEST(StrengthRateOfSolid, SoftensFromAStrainThatGrowsWithTheRate) {
  constexpr int D = TypeParam::D;
  SolidOnTrial<D, typename TypeParam::P> trial(
      block<D>({.cells = {6, 5, 5}}, rate_solid<D>(BondCriterion::crack_band)));
  const double rate = 100.0, step = 1e-4;
  const double factor = std::pow(rate * std::sqrt(1.346), 0.2);
  const Index middle = static_cast<Index>(trial.size() / 2);
  double undamaged = 0.0;  // the largest strain without damage
  for (int n = 1; n <= 600; ++n) {
    stretch_in_step(trial, n * step, step / rate);
    const auto view = trial.solid.view();
    const double k = double(view.current_strain[middle]);
    if (undamaged_share(view.medium(middle), view.softening_strain(middle)) == 1)
      undamaged = k;
    else
      EXPECT_NEAR(double(view.softening_strain(middle)), k / factor, 0.01 * k / factor);
    end_step(trial);
  }
  EXPECT_NEAR(undamaged, factor * 0.01, 0.02 * factor * 0.01);
}

// What is stored and what softening has taken add up to the work of the load, by the trapezoidal
// rule: also where the block is pulled ever slower after a fast start, so that R falls until it
// is damaged.
TYPED_TEST(StrengthRateOfSolid, BalanceOfEnergyCloses) {
  constexpr int D = TypeParam::D;
  auto medium = rate_solid<D>(BondCriterion::crack_band);
  medium.hourglass = 0.0;
  SolidOnTrial<D, typename TypeParam::P> trial(block<D>({.cells = {6, 5, 5}}, medium));
  const double step = 2e-5;
  double work = 0.0, stress_before = 0.0, most_factor = 0.0;
  for (int n = 1; n <= 2500; ++n) {
    stretch_in_step(trial, n * step, step / 1000.0 * std::exp(0.02 * n));
    const auto view = trial.solid.view();
    double stress = 0.0;  // sum over particles of volume x first Piola-Kirchhoff stress
    for (Index i = 0; i < trial.size(); ++i) {
      const auto h = view.gradient[i];
      stress +=
          medium.reference_volume() * double(first_piola(elastic_stress(view, i, h), h)(0, 0));
      most_factor = std::max(most_factor, double(view.strength_factor(i)));
    }
    work += 0.5 * (stress + stress_before) * step;
    stress_before = stress;
    end_step(trial);
  }
  EXPECT_GT(most_factor, 3.0);  // 1000^0.2 = 4, at the start
  const double dissipated = trial.solid.softening_work();
  EXPECT_GT(dissipated, 0.3 * work);
  EXPECT_NEAR(trial.solid.energy().total() + dissipated, work, 2e-3 * work);
}

TYPED_TEST(StrengthRateOfSolid, IsRestoredBitForBit) {
  constexpr int D = TypeParam::D;
  using Trial = SolidOnTrial<D, typename TypeParam::P>;
  const auto layout =
      block<D>({.cells = {6, 5, 5}, .jitter = 0.1}, rate_solid<D>(BondCriterion::crack_band));
  Trial first(layout), second(layout);
  for (int n = 1; n <= 20; ++n) {
    stretch_in_step(first, 1e-3 * n, 1e-5);
    first.solid.fracture();
    end_step(first);
  }
  second.solid.restore(first.solid.save());
  for (Trial* trial : {&first, &second})
    for (int n = 21; n <= 40; ++n) {
      stretch_in_step(*trial, 1e-3 * n, 1e-4);
      trial->solid.fracture();
      end_step(*trial);
    }
  const auto one = first.solid.save(), other = second.solid.save();
  EXPECT_EQ(one.bond_intact, other.bond_intact);
  EXPECT_EQ(one.strain, other.strain);
  for (std::size_t i = 0; i < first.size(); ++i) {
    ASSERT_EQ(one.loading[i].factor, other.loading[i].factor);
    ASSERT_EQ(one.loading[i].time, other.loading[i].time);
    EXPECT_GT(one.loading[i].factor, 1.0);
  }
}

}  // namespace
}  // namespace kerf::test
