// SPDX-License-Identifier: Apache-2.0
// A block that is crushed with a compressive strength: the work of its stress is what it stores and
// what softening takes.
#include <gtest/gtest.h>

#include "fracture/compressive_strength.hpp"
#include "support/solid_blocks.hpp"

namespace kerf::test::confined_softening_test {
namespace {

constexpr double failure = 0.02;

// A compressive strength of `ratio` times the tensile one.
Medium<double> crushed_solid(int dimension, double ratio) {
  auto medium = soft_solid(1e-3, dimension);
  medium.criterion = BondCriterion::crack_band;
  medium.softening_strain = failure;
  medium.failure_strain = 8.0 * failure;
  medium.confinement = confinement_of(medium, ratio);
  return medium;
}

// The displacement gradient of a block that is squeezed along x by e and stretched across.
template <int D>
Matrix<D, double> squeezed(double e, double stretched = 0.25) {
  auto h = Matrix<D, double>::zero();
  h(0, 0) = -e;
  for (int a = 1; a < D; ++a) h(a, a) = stretched * e;
  return h;
}

template <int D>
void set_gradient(SolidOnTrial<D, Double>& trial, const Matrix<D, double>& h) {
  trial.map(Square<D>::Identity() + as_square(h));
  trial.deform();
}

// First Piola-Kirchhoff stress of the block, by the strain that it keeps.
template <int D>
Matrix<D, double> stress_of(const SolidOnTrial<D, Double>& trial, const Matrix<D, double>& h,
                            double strain) {
  const auto& medium = trial.layout.media[0];
  const auto green = green_strain(h);
  return first_piola(second_piola(softened(medium, green, undamaged_share(medium, strain)), green),
                     h);
}

template <class Chosen>
class ConfinedSoftening : public testing::Test {};
TYPED_TEST_SUITE(ConfinedSoftening, DoubleOnly);

// Squeezes a block in small steps.
template <int D>
void expect_work_to_be_stored_or_taken(double ratio, double stretched) {
  SolidOnTrial<D, Double> trial(block<D>({.cells = {5, 5, 5}}, crushed_solid(D, ratio)));
  constexpr int steps = 4000;
  const double most = 0.3;
  double work = 0.0, released = 0.0;  // J/m^3, J
  auto before = Matrix<D, double>::zero();
  auto stress_before = before;
  for (int n = 1; n <= steps; ++n) {
    const auto h = squeezed<D>(most * n / steps, stretched);
    set_gradient(trial, h);
    const auto stress = stress_of(trial, h, trial.solid.view().softening_strain(0));
    for (int a = 0; a < D; ++a)
      work += 0.5 * (stress(a, a) + stress_before(a, a)) * (h(a, a) - before(a, a));
    released += trial.solid.keep_softening();
    before = h;
    stress_before = stress;
  }
  const auto& medium = trial.layout.media[0];
  const double strain = trial.solid.view().softening_strain(0);
  ASSERT_LT(undamaged_share(medium, strain), 0.5);  // it has softened under pressure
  const auto green = green_strain(before);
  const double stored =
      energy_density(softened(medium, green, undamaged_share(medium, strain)), green);
  const double volume = static_cast<double>(trial.size()) * medium.reference_volume();
  const double taken = (trial.solid.softening_work() + released) / volume;
  EXPECT_GT(released, 0.0);
  EXPECT_NEAR(stored + taken, work, 2e-3 * work);
  EXPECT_GT(taken, 0.1 * work);
}

TYPED_TEST(ConfinedSoftening, TakesTheWorkThatIsNotStored) {
  expect_work_to_be_stored_or_taken<TypeParam::D>(3.0, 0.25);
}
// Stretched across by so much that the largest principal stress is a tension, which drives
// softening, while the volume is compressed.
TYPED_TEST(ConfinedSoftening, TakesTheWorkOfTensionAcrossCompression) {
  constexpr int D = TypeParam::D;
  expect_work_to_be_stored_or_taken<D>(8.0, D == 2 ? 0.6 : 0.4);
}

// A block that is squeezed and released again takes nothing more.
TYPED_TEST(ConfinedSoftening, TakesNothingBelowItsLargestStrain) {
  constexpr int D = TypeParam::D;
  SolidOnTrial<D, Double> trial(block<D>({.cells = {5, 5, 5}}, crushed_solid(D, 3.0)));
  for (const double e : {0.2, 0.3}) {
    set_gradient(trial, squeezed<D>(e));
    EXPECT_GT(trial.solid.keep_softening(), 0.0) << e;
  }
  const double taken = trial.solid.softening_work();
  for (const double e : {0.25, 0.05, 0.0, 0.29}) {
    set_gradient(trial, squeezed<D>(e));
    EXPECT_EQ(trial.solid.keep_softening(), 0.0) << e;
    EXPECT_EQ(trial.solid.softening_work(), taken) << e;
  }
}

}  // namespace
}  // namespace kerf::test::confined_softening_test
