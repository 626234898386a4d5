// SPDX-License-Identifier: Apache-2.0
// The broken bonds, the pieces, and the released energy.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "support/notched_strip.hpp"

namespace kerf::test {
namespace {

template <class Chosen>
class SolidFracture : public testing::Test {};
TYPED_TEST_SUITE(SolidFracture, TwoKinds);
template <class Chosen>
class PlaneFracture : public testing::Test {};
TYPED_TEST_SUITE(PlaneFracture, PlaneOnly);
template <class Chosen>
class FractureByHand : public testing::Test {};
TYPED_TEST_SUITE(FractureByHand, DoubleOnly);

template <int D, class P>
SolidOnTrial<D, P> brittle_block(BondCriterion criterion, double limit) {
  auto medium = soft_solid(1e-3, D);
  medium.criterion = criterion;
  medium.failure_strain = limit;
  return SolidOnTrial<D, P>(block<D>({.cells = {9, 8, 7}, .jitter = 0.2}, medium));
}

template <int D>
Square<D> stretch_along_x(double stretch) {
  Square<D> map = Square<D>::Identity();
  map(0, 0) = stretch;
  return map;
}

// No bond breaks below the limit or in compression. For the equivalent strain, 2/3 of a uniaxial
// one, the limit is 3/2 as high.
TYPED_TEST(SolidFracture, BreaksAboveTheLimitOnly) {
  constexpr int D = TypeParam::D;
  for (auto criterion : {BondCriterion::principal_strain, BondCriterion::equivalent_strain}) {
    const double limit = criterion == BondCriterion::principal_strain ? 0.1 : 0.15;
    auto trial = brittle_block<D, typename TypeParam::P>(criterion, 0.1);
    for (double share : {-5.0, -1.0, 0.0, 0.5, 0.999, 1.001}) {
      trial.map(stretch_along_x<D>(std::exp(share * limit)));
      trial.deform();
      const FractureResult result = trial.solid.fracture();
      EXPECT_EQ(result.bonds > 0, share > 1.0) << share;
      EXPECT_EQ(result.released > 0.0, share > 1.0) << share;
    }
  }
}

// A solid that can break and is compressed to a fifth of its volume, or turned inside out, fails in
// compression: all particles are detached, without stress. A solid that cannot break carries the
// stress.
TYPED_TEST(SolidFracture, FailsInCompressionBelowAFifthOfTheVolume) {
  constexpr int D = TypeParam::D;
  for (double limit : {0.0, 0.1})
    for (double volume : {0.9, 0.21, 0.19, -0.5}) {
      auto trial = brittle_block<D, typename TypeParam::P>(BondCriterion::principal_strain, limit);
      Square<D> map = std::pow(std::abs(volume), 1.0 / D) * Square<D>::Identity();
      if (volume < 0.0) map.row(0) *= -1.0;
      trial.map(map);
      trial.deform();
      const FractureResult result = trial.solid.fracture();
      EXPECT_EQ(result.detached, limit > 0.0 && volume < 0.2 ? trial.size() : 0u) << volume;
      trial.evaluate();
      if (result.detached == 0) continue;
      for (Index i = 0; i < trial.size(); ++i) EXPECT_EQ(norm(trial.force(i)), 0.0);
      EXPECT_EQ(trial.solid.energy().total(), 0.0);
    }
}

// The bonds that break by the largest principal strain, computed for all pairs with Eigen's
// principal values: some break by the mean of two ends of which one has a small strain.
TYPED_TEST(FractureByHand, PrincipalStrain) {
  constexpr int D = TypeParam::D;
  const double limit = 0.1, above = std::expm1(2.0 * limit);
  auto trial = brittle_block<D, Double>(BondCriterion::principal_strain, limit);
  const double swelling = D == 2 ? 0.35 : 0.25, width = D == 2 ? 1.5e-3 : 2e-3;
  for (auto& x : trial.position) {
    auto arm = x;
    for (int a = 0; a < D; ++a) arm[a] -= 4e-3;
    x += swelling * std::exp(-dot(arm, arm) / (width * width)) * arm;
  }
  trial.deform();
  const auto green = [&](Index i) -> Square<D> {
    const Square<D> h = as_square<D>(trial.gradient(i));
    return 0.5 * (h + h.transpose() + h.transpose() * h);
  };
  const auto largest = [&](Index i) {
    return 2.0 *
           std::max(0.0,
                    Eigen::SelfAdjointEigenSolver<Square<D>>(green(i)).eigenvalues().maxCoeff());
  };
  std::uint64_t expected = 0, of_mean = 0;
  for (Index i = 0; i < trial.size(); ++i)
    for (Index j = i + 1; j < trial.size(); ++j) {
      const auto bond = as_column(trial.layout.reference[j] - trial.layout.reference[i]);
      if (!(bond.norm() < 2.0 * trial.layout.media[0].smoothing_length)) continue;
      const double length = norm(trial.position[j] - trial.position[i]) / bond.norm();
      const double own = length * length - 1.0, prepared = 0.5 * (largest(i) + largest(j));
      const double mean = bond.normalized().dot((green(i) + green(j)) * bond.normalized());
      const bool by_place = prepared > above && mean > 0.25 * prepared && own > 0.5 * mean;
      expected += own > above || by_place;
      of_mean += own <= above && by_place && std::min(largest(i), largest(j)) < 0.8 * above;
    }
  EXPECT_GT(of_mean, 3u);
  const FractureResult result = trial.solid.fracture();
  EXPECT_EQ(result.detached, 0u);
  EXPECT_EQ(result.bonds, expected);
}

// One half is moved away: the tensors of a band are strained, but only bonds across the gap break.
TYPED_TEST(SolidFracture, OnlyBondsAcrossTheGapBreak) {
  constexpr int D = TypeParam::D;
  for (auto criterion : {BondCriterion::principal_strain, BondCriterion::equivalent_strain}) {
    auto trial = brittle_block<D, typename TypeParam::P>(criterion, 0.1);
    const auto is_upper = [&](Index i) { return trial.layout.reference[i][0] > 4.5e-3; };
    for (Index i = 0; i < trial.size(); ++i)
      if (is_upper(i)) trial.position[i][0] += 1.5e-3;
    trial.deform();
    double seeming = 0.0;
    for (Index i = 0; i < trial.size(); ++i)
      seeming = std::max(seeming, static_cast<double>(trial.gradient(i)(0, 0)));
    EXPECT_GT(seeming, 0.3);
    std::uint64_t broken = 0;
    for (FractureResult result{.bonds = 1};
         result.bonds > 0;) {  // the remaining bonds may break in turn
      result = trial.solid.fracture();
      broken += result.bonds;
    }
    EXPECT_GT(broken, 0u);
    EXPECT_EQ(trial.solid.count().second, 0u);
    const auto solid = trial.solid.view();
    for (Index i = 0; i < trial.size(); ++i)
      for (Index k = solid.bonds.first(i); k < solid.bonds.last(i); ++k)
        ASSERT_EQ(!solid.is_intact(i, k), is_upper(i) != is_upper(solid.bonds.end(i, k)));
    // Both halves are at rest.
    EXPECT_LE(trial.solid.energy().total(), 1e-9);
  }
}

// Keeps only the bonds along x of those across a plane.
struct AllButStraightBonds {
  template <class Position>
  KERF_FUNCTION bool operator()(const Position& x, const Position& y) const {
    const auto apart = y - x;
    const bool across = (x[0] > 4.5e-3) != (y[0] > 4.5e-3);
    return across && norm(apart) > 1.1 * std::abs(apart[0]);
  }
};

// Bonds between both sides of a crack turn without stretch if one side slides: they are intact
// while the deformation gradients follow them, and fail when the sides have slid apart.
TYPED_TEST(SolidFracture, BondsOfSlidingFacesFail) {
  constexpr int D = TypeParam::D;
  for (const double turn : {0.02, 0.4}) {
    auto medium = soft_solid(1e-3, D);
    medium.criterion = BondCriterion::principal_strain;
    medium.failure_strain = 0.02;
    SolidOnTrial<D, typename TypeParam::P> trial(block<D>({.cells = {9, 8, 7}}, medium));
    const auto is_upper = [&](Index i) { return trial.layout.reference[i][0] > 4.5e-3; };
    trial.solid.cut(AllButStraightBonds{});
    const auto before = trial.solid.count().first;
    for (Index i = 0; i < trial.size(); ++i)
      if (is_upper(i)) {
        trial.position[i][1] += 1e-3 * std::sin(turn);
        trial.position[i][0] -= 1e-3 * (1.0 - std::cos(turn));
      }
    trial.deform();
    for (FractureResult result{.bonds = 1}; result.bonds > 0;) result = trial.solid.fracture();
    const auto solid = trial.solid.view();
    std::uint64_t across = 0;
    for (Index i = 0; i < trial.size(); ++i)
      for (Index k = solid.bonds.first(i); k < solid.bonds.last(i); ++k)
        across += is_upper(i) != is_upper(solid.bonds.end(i, k)) && solid.is_intact(i, k);
    if (turn < 0.1)
      EXPECT_EQ(trial.solid.count().first, before);
    else
      EXPECT_EQ(across, 0u);
    EXPECT_EQ(trial.solid.count().second, 0u);
  }
}

// A particle with D neighbours has no strain of its own; one with many has.
TYPED_TEST(SolidFracture, DetachedParticles) {
  constexpr int D = TypeParam::D;
  auto layout = block<D>({.cells = {5, 5, 5}});
  auto alone = layout.reference.back();
  for (int a = 0; a < D; ++a) alone[a] += 10e-3;
  layout.reference.push_back(alone);  // has no neighbour
  auto far = layout.reference.front();
  far[0] -= 2.5e-3;
  layout.reference.push_back(far);  // has one neighbour
  layout.medium_index.resize(layout.reference.size(), 0);
  SolidOnTrial<D, typename TypeParam::P> trial(layout);
  EXPECT_EQ(trial.solid.count().second, 2u);
  trial.map(some_map<D>());
  trial.evaluate();
  for (std::size_t i : {trial.size() - 1, trial.size() - 2}) {
    EXPECT_EQ(trial.solid.fields().detached[i], 1);
    EXPECT_EQ(norm(trial.force(i)), 0.0);
  }
  // A single row of particles does not determine the strain across it: all are detached.
  SolidOnTrial<D, typename TypeParam::P> row(block<D>({.cells = {20, 1, 1}}));
  EXPECT_EQ(row.solid.count(), std::make_pair(std::uint64_t(0), Index(20)));
}

// Returns the piece of each particle, by its intact bonds.
template <int D, class P>
std::vector<Index> pieces_of(SolidOnTrial<D, P>& trial) {
  std::vector<Index> root(trial.size());
  std::iota(root.begin(), root.end(), Index(0));
  const auto find = [&](Index i) {
    while (root[i] != i) i = root[i] = root[root[i]];
    return i;
  };
  const auto solid = trial.solid.view();
  for (Index i = 0; i < trial.size(); ++i)
    for (Index k = solid.bonds.first(i); k < solid.bonds.last(i); ++k)
      if (solid.is_intact(i, k)) root[find(i)] = find(solid.bonds.end(i, k));
  for (Index i = 0; i < trial.size(); ++i) root[i] = find(i);
  return root;
}

// The crack extends from the notch to the other side, between the rows on both sides of the line of
// the notch; no particle is detached by it, and the two halves exert no force on one another.
TYPED_TEST(PlaneFracture, CrackOfANotchedStrip) {
  auto trial = notched_strip<typename TypeParam::P>();
  pull(trial, 0.03, 0.04);
  const auto piece = pieces_of(trial);
  int astray = 0;
  for (std::size_t i = 0; i < trial.size(); ++i) {
    const bool upper = trial.layout.reference[i][1] > 10e-3;
    astray += piece[i] != piece[upper ? trial.size() - 1 : 0];
  }
  EXPECT_NE(piece.front(), piece.back());
  EXPECT_EQ(astray, 0);
  EXPECT_EQ(trial.solid.count().second, 0u);

  trial.evaluate();
  std::vector<Vector<2, double>> force;
  double largest = 0.0;
  for (std::size_t i = 0; i < trial.size(); ++i) {
    force.push_back(trial.force(i));
    largest = std::max(largest, norm(force[i]));
  }
  for (std::size_t i = 0; i < trial.size(); ++i)
    if (piece[i] == piece.back()) trial.position[i] -= {0.3e-3, 3e-3};
  trial.evaluate();
  for (std::size_t i = 0; i < trial.size(); ++i)
    EXPECT_LE(norm(trial.force(i) - force[i]), 100.0 * TypeParam::rounding * largest);
}

// A strip breaks by its own motion: the sum of stored, kinetic, dissipated and released energy is
// constant.
TYPED_TEST(PlaneFracture, EnergyIsRecorded) {
  auto trial = notched_strip<typename TypeParam::P>();
  const double dt = 0.1 * 1e-3 / trial.layout.media[0].bond_wave_speed();
  for (std::size_t i = 0; i < trial.size(); ++i)
    trial.velocity[i] = {
        0, static_cast<typename TypeParam::Real>(150.0 * (trial.layout.reference[i][1] - 10e-3))};
  trial.evaluate();
  const double start = trial.kinetic_energy() + trial.solid.energy().total();
  double released = 0.0, dissipated = 0.0;
  const auto power = [&] {
    double sum = 0.0;
    for (std::size_t i = 0; i < trial.size(); ++i) sum += trial.solid.fields().viscous_power[i];
    return sum;
  };
  double power_before = power();
  for (int n = 0; n < 1500; ++n) {
    trial.kick(0.5 * dt);
    for (std::size_t i = 0; i < trial.size(); ++i)
      trial.position[i] += dt * Vector<2, double>::from(trial.velocity[i]);
    trial.deform();
    released += trial.solid.fracture().released;
    trial.evaluate();
    trial.kick(0.5 * dt);
    dissipated += 0.5 * dt * (power_before + power());
    power_before = power();
  }
  const double end = trial.kinetic_energy() + trial.solid.energy().total();
  this->RecordProperty("released_percent", std::to_string(100.0 * released / start));
  this->RecordProperty("dissipated_percent", std::to_string(100.0 * dissipated / start));
  this->RecordProperty("off_percent",
                       std::to_string(100.0 * (end + released + dissipated - start) / start));
  this->RecordProperty("detached", static_cast<int>(trial.solid.count().second));
  EXPECT_GT(released, 0.01 * start);
  EXPECT_NEAR(end + released + dissipated, start, 0.005 * start);
}

}  // namespace
}  // namespace kerf::test
