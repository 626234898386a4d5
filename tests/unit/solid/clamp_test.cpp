// SPDX-License-Identifier: Apache-2.0
// Clamps hold without breaking: fracture begins beyond a support radius from them
// (solid/hold_clamped.hpp).
#include <gtest/gtest.h>

#include "fracture/crack_band.hpp"
#include "support/solid_blocks.hpp"

namespace kerf::test {
namespace {

template <class Chosen>
struct Clamps : testing::Test {};
TYPED_TEST_SUITE(Clamps, BothPrecisions);

constexpr double spacing = 1e-3;

// A bar 12 spacings long in x, whose first and last three layers are clamps.
template <int D>
bool is_in_clamp(const Vector<D, double>& x) {
  return x[0] < 3.0 * spacing || x[0] > 9.0 * spacing;
}
template <int D>
SolidLayout<D> clamped_bar(Medium<double> medium, double jitter) {
  auto layout = block<D>({.cells = {12, 6, 6}, .spacing = spacing, .jitter = jitter}, medium);
  medium.constrained = true;
  layout.media.push_back(medium);
  for (std::size_t i = 0; i < layout.reference.size(); ++i)
    if (is_in_clamp(layout.reference[i])) layout.medium_index[i] = 1;
  return layout;
}

// Whether a clamp reaches particle i, by all distances.
template <int D>
bool is_reached(const SolidLayout<D>& layout, std::size_t i) {
  const double reach = 2.0 * layout.media[0].smoothing_length;
  for (std::size_t j = 0; j < layout.reference.size(); ++j)
    if (layout.medium_index[j] == 1 && norm(layout.reference[j] - layout.reference[i]) < reach)
      return true;
  return false;
}

// In a uniform stretch far above the limit the particles that no clamp reaches lose their
// bonds to one another, and those that a clamp reaches are not detached.
TYPED_TEST(Clamps, HoldWhatTheyReach) {
  constexpr int D = TypeParam::D;
  for (auto criterion : {BondCriterion::principal_strain, BondCriterion::strain_energy})
    for (double jitter : {0.0, 0.2}) {
      auto medium = soft_solid(spacing, D);
      medium.criterion = criterion;
      medium.failure_strain = 0.02;
      SolidOnTrial<D, typename TypeParam::P> trial(clamped_bar<D>(medium, jitter));
      trial.map(1.3 * Square<D>::Identity());
      std::vector<Index> expected;
      for (std::size_t i = 0; i < trial.size(); ++i) {
        Index left = 0;
        for (std::size_t j = 0; j < trial.size(); ++j) {
          const double length = norm(trial.layout.reference[j] - trial.layout.reference[i]);
          const bool holds = is_reached(trial.layout, i) || is_reached(trial.layout, j);
          left += i != j && length < 2.0 * medium.smoothing_length && holds;
        }
        expected.push_back(left);
      }
      trial.deform();
      const FractureResult result = trial.solid.fracture();
      EXPECT_GT(result.bonds, 0u);
      EXPECT_GE(result.released, 0.0);
      for (std::size_t i = 0; i < trial.size(); ++i) {
        if (trial.solid.view().detached[i]) continue;  // too few bonds are left to it
        EXPECT_LE(trial.solid.view().intact_bonds(static_cast<Index>(i)), expected[i]);
        if (is_reached(trial.layout, i)) {
          EXPECT_FALSE(trial.solid.view().detached[i]);
        }
      }
    }
}

// Softening starts only beyond the reach of the clamps.
TYPED_TEST(Clamps, DoNotSoften) {
  constexpr int D = TypeParam::D;
  auto medium = soft_solid(spacing, D);
  medium.criterion = BondCriterion::crack_band;
  medium.softening_strain = 0.01;
  medium.failure_strain = 0.2;
  SolidOnTrial<D, typename TypeParam::P> trial(clamped_bar<D>(medium, 0.0));
  trial.map(1.05 * Square<D>::Identity());
  trial.deform();
  for (std::size_t i = 0; i < trial.size(); ++i)
    EXPECT_EQ(trial.solid.view().softens(static_cast<Index>(i)), !is_reached(trial.layout, i));
}

}  // namespace
}  // namespace kerf::test
