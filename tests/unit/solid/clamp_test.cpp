// SPDX-License-Identifier: Apache-2.0
// Clamps hold without breaking: fracture begins beyond a support radius from them
// (solid/hold_clamped.hpp).
#include <gtest/gtest.h>

#include <vector>

#include "fracture/crack_band.hpp"
#include "support/solid_blocks.hpp"

namespace kerf::test::clamp_test {
namespace {

template <class Chosen>
struct Clamps : testing::Test {};
TYPED_TEST_SUITE(Clamps, TwoKinds);

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

// The bonds of each particle of which a clamp reaches an end, by all distances.
template <int D>
std::vector<Index> held_bonds(const SolidLayout<D>& layout) {
  std::vector<Index> held;
  for (std::size_t i = 0; i < layout.reference.size(); ++i) {
    Index count = 0;
    for (std::size_t j = 0; j < layout.reference.size(); ++j) {
      const double length = norm(layout.reference[j] - layout.reference[i]);
      const bool holds = is_reached(layout, i) || is_reached(layout, j);
      count += i != j && length < 2.0 * layout.media[0].smoothing_length && holds;
    }
    held.push_back(count);
  }
  return held;
}

// In a uniform stretch far above the limit no bonds are left but those that a clamp holds, and what
// a clamp reaches is not detached.
template <class Kind>
void expect_held(BondCriterion criterion, double jitter) {
  constexpr int D = Kind::D;
  auto medium = soft_solid(spacing, D);
  medium.criterion = criterion;
  medium.failure_strain = 0.02;
  SolidOnTrial<D, typename Kind::P> trial(clamped_bar<D>(medium, jitter));
  trial.map(1.3 * Square<D>::Identity());
  const auto expected = held_bonds<D>(trial.layout);
  trial.deform();
  const FractureResult result = trial.solid.fracture();
  EXPECT_GT(result.bonds, 0u);
  EXPECT_GE(result.released, 0.0);
  const auto view = trial.solid.view();
  for (std::size_t i = 0; i < trial.size(); ++i) {
    EXPECT_FALSE(view.detached[i] && is_reached(trial.layout, i));
    const Index left = view.detached[i] ? 0 : view.intact_bonds(static_cast<Index>(i));
    EXPECT_LE(left, expected[i]);
  }
}

TYPED_TEST(Clamps, HoldWhatTheyReach) {
  for (auto criterion : {BondCriterion::principal_strain, BondCriterion::strain_energy})
    for (double jitter : {0.0, 0.2}) expect_held<TypeParam>(criterion, jitter);
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
}  // namespace kerf::test::clamp_test
