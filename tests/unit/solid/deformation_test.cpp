// SPDX-License-Identifier: Apache-2.0
// The deformation gradient against the maps that define it.
#include <gtest/gtest.h>

#include <numbers>

#include "support/solid_blocks.hpp"

namespace kerf::test {
namespace {

template <class Chosen>
class Deformation : public testing::Test {
 protected:
  using Trial = SolidOnTrial<Chosen::D, typename Chosen::P>;
  // The large displacement of the body must not lose digits.
  static double worst_gradient(Trial& trial, const Square<Chosen::D>& map, double shift) {
    using Tensor = Square<Chosen::D>;
    trial.map(map, shift);
    trial.deform();
    double worst = 0.0;
    for (std::size_t i = 0; i < trial.size(); ++i) {
      const Tensor f = as_square(trial.gradient(i)) + Tensor::Identity();
      worst = std::max(worst, (f - map).cwiseAbs().maxCoeff());
    }
    return worst;
  }
};
TYPED_TEST_SUITE(Deformation, TwoKinds);

TYPED_TEST(Deformation, PatchTestOnEveryParticle) {
  constexpr int D = TypeParam::D;
  for (unsigned seed = 1; seed <= 3; ++seed) {
    typename TestFixture::Trial trial(block<D>({.jitter = 0.25, .seed = seed}));
    ASSERT_EQ(trial.solid.count().second, 0u);
    const double worst = TestFixture::worst_gradient(trial, some_map<D>(), 0.1);
    EXPECT_LE(worst, 10.0 * TypeParam::rounding);
  }
}

// Small strains keep their digits: the error is relative to the strain, not to 1.
TYPED_TEST(Deformation, SmallStrain) {
  constexpr int D = TypeParam::D;
  typename TestFixture::Trial trial(block<D>({.jitter = 0.25}));
  const double size = 1e-5;
  const Square<D> map = Square<D>::Identity() + size * some_map<D>();
  // Positions in double are exact to 1e-16 of 0.01 m, over a bond of 1e-3 m.
  EXPECT_LE(TestFixture::worst_gradient(trial, map, 0.0),
            10.0 * TypeParam::rounding * size + 1e-14);
}

TYPED_TEST(Deformation, TenRotationsStoreNoEnergy) {
  constexpr int D = TypeParam::D;
  typename TestFixture::Trial trial(block<D>({.jitter = 0.25}));
  const auto& medium = trial.layout.media[0];
  const auto solid = Medium<typename TypeParam::Real>::from(medium);
  for (int n = 1; n <= 40; ++n) {
    trial.map(rotation<D>(n * 0.5 * std::numbers::pi + 0.3), 1.0);
    trial.evaluate();
    const auto energy = trial.solid.energy();
    // Strain to rounding, of sums and of positions (1e-16 of 1 m over 1e-3 m, of two ends, over
    // bonds of each direction); energy to its square.
    const double strain = 10.0 * TypeParam::rounding + 1e-12;
    const double scale = medium.young_modulus() * medium.reference_volume() * trial.size();
    ASSERT_LE(energy.elastic, strain * strain * scale);
    ASSERT_LE(energy.hourglass, strain * strain * scale);
    for (std::size_t i = 0; i < trial.size(); ++i) {
      const auto stress = cauchy(solid, trial.gradient(i));
      for (double s : stress.component) ASSERT_LE(std::abs(s), strain * medium.young_modulus());
    }
  }
}

// The shortest time of a wave and the particle that sets it, although most particles are skipped.
TYPED_TEST(Deformation, WaveTimeIsTheMinimumOverParticles) {
  constexpr int D = TypeParam::D;
  typename TestFixture::Trial trial(block<D>({.jitter = 0.25}));
  for (int n = 0; n < 5; ++n) {
    trial.map(rotation<D>(0.4 * n) * (Square<D>::Identity() + 0.1 * n * some_map<D>()), 0.0);
    for (auto& x : trial.position)  // not uniform
      for (int a = 0; a < D; ++a) x[a] *= 1.0 - 20.0 * n * x[a];
    trial.deform();
    const WaveTimeLimit<D, typename TypeParam::P> limit{trial.solid.view(), 0.25};
    WaveTime due = limit(0);
    for (Index i = 1; i < trial.solid.size(); ++i) due = ShorterWave{}(due, limit(i));
    const WaveTime is = trial.solid.wave_time(0.25);
    EXPECT_EQ(is.time, due.time);
    EXPECT_EQ(is.particle, due.particle);
  }
}

// Bonds are all pairs closer than 2 h, by a brute-force search.
TYPED_TEST(Deformation, BondsAreAllPairsWithinTheCutoff) {
  constexpr int D = TypeParam::D;
  auto layout = block<D>({.jitter = 0.4, .seed = 4});
  auto coarse = soft_solid(1.7e-3, D), other = soft_solid(1e-3, D);
  coarse.level = 1;
  other.piece = 1;
  layout.media.push_back(coarse);
  layout.media.push_back(other);
  std::mt19937 engine(5);
  for (auto& index : layout.medium_index) index = engine() % 3;
  const BondLists lists = BondFinder<D>(layout).find();
  std::size_t found = 0;
  for (Index i = 0; i < layout.reference.size(); ++i)
    for (Index j = 0; j < layout.reference.size(); ++j) {
      const auto& a = layout.media[layout.medium_index[i]];
      const auto& b = layout.media[layout.medium_index[j]];
      const double distance = norm(layout.reference[i] - layout.reference[j]);
      if (i == j || a.piece != b.piece) continue;
      if (!(distance < a.smoothing_length + b.smoothing_length)) continue;
      ASSERT_LT(found, lists.neighbour.size());
      ASSERT_EQ(lists.neighbour[found], j);
      ASSERT_GE(found, lists.begin[i]);
      ASSERT_LT(found, lists.begin[i + 1]);
      ++found;
    }
  EXPECT_EQ(found, lists.neighbour.size());
}

// The budget of 1 KiB per particle in three dimensions, with bonds.
TYPED_TEST(Deformation, MemoryPerParticle) {
  constexpr int D = TypeParam::D;
  typename TestFixture::Trial trial(block<D>({.cells = {24, 24, 24}}));
  const double bytes = static_cast<double>(trial.solid.bytes()) / trial.size();
  this->RecordProperty("bytes", std::to_string(bytes));
  if (std::is_same_v<typename TypeParam::Real, float>) {
    EXPECT_LE(bytes, 1024.0);
  }
}

}  // namespace
}  // namespace kerf::test
