// SPDX-License-Identifier: Apache-2.0
// Cracks that grow from flaws (fracture/grady_kipp.hpp) in a block of solid.
#include <cmath>

#include "support/solid_blocks.hpp"

namespace kerf::test {
namespace {

template <class T>
class Flaws : public testing::Test {};
TYPED_TEST_SUITE(Flaws, OtherTwoKinds);

// About two flaws per particle are active at a strain of 1%.
template <int D, class P>
SolidOnTrial<D, P> flawed_block() {
  auto medium = soft_solid(1e-3, D);
  medium.criterion = BondCriterion::grady_kipp;
  medium.grady_kipp.exponent = 6.0;
  medium.grady_kipp.unit_strain = 0.01 * std::pow(2.0, -1.0 / 6.0);
  medium.grady_kipp.growth = 1.0;
  medium.grady_kipp.seed = 9;
  return SolidOnTrial<D, P>(block<D>({.jitter = 0.1}, medium));
}

template <int D>
Square<D> stretch(double strain) {
  Square<D> map = Square<D>::Identity();
  map(0, 0) += strain;
  return map;
}

// At a constant deformation damage releases the energy that it removes from the stored energy,
// including hourglass control; without a break nothing else releases energy. Energies are sums in
// double of fields in single precision.
TYPED_TEST(Flaws, ReleaseTheEnergyThatTheyRemove) {
  constexpr int D = TypeParam::D;
  auto trial = flawed_block<D, typename TypeParam::P>();
  trial.map(stretch<D>(0.012));
  trial.displace_randomly(1e-5, 3);
  trial.deform();
  const double before = trial.solid.energy().total();
  double freed = 0.0;
  for (int n = 0; n < 5; ++n) freed += trial.solid.keep_damage(0.06);
  trial.deform();
  const double after = trial.solid.energy().total();
  EXPECT_GT(freed, 0.02 * before);
  EXPECT_NEAR(before - after, freed, 100.0 * TypeParam::rounding * before);
}

// Returns the stored energy if one particle is displaced along an axis.
template <int D>
double energy_moved(SolidOnTrial<D, Double>& trial, std::size_t i, int axis, double shift) {
  auto moved = trial.position;
  moved[i][axis] += shift;
  Array<Vector<D, double>> positions;
  to_device(moved, positions);
  trial.solid.deform(positions);
  return trial.solid.energy().total();
}

// The force with damage is minus the gradient of the energy: the work of a small motion is stored.
// Central differences have a step of 1e-6 spacings; the tolerance is 1e-4 of the load of a face.
TEST(FlawsInSpace, ForceIsTheGradientOfTheEnergy) {
  auto trial = flawed_block<3, Double>();
  trial.map(stretch<3>(0.012));
  trial.displace_randomly(2e-5, 3);
  trial.deform();
  for (int n = 0; n < 5; ++n) trial.solid.keep_damage(0.06);
  const double face = trial.layout.media[0].bulk_modulus * 0.012 * 1e-6, step = 1e-9;
  for (const std::size_t i : {trial.size() / 2, std::size_t{0}})
    for (int a = 0; a < 3; ++a) {
      trial.evaluate();
      const double force = trial.force(i)[a];
      const double slope =
          (energy_moved(trial, i, a, step) - energy_moved(trial, i, a, -step)) / (2.0 * step);
      EXPECT_NEAR(-slope, force, 1e-4 * face);
    }
}

// In tension the block separates: fully damaged particles lose their stretched bonds. In
// compression it keeps all bonds.
TYPED_TEST(Flaws, FullDamageBreaksStretchedBonds) {
  constexpr int D = TypeParam::D;
  for (const double strain : {0.02, -0.02}) {
    auto trial = flawed_block<D, typename TypeParam::P>();
    trial.map(stretch<D>(0.02));
    trial.deform();
    EXPECT_EQ(trial.solid.fracture().bonds, 0u);
    for (int n = 0; n < 20; ++n) trial.solid.keep_damage(0.2);
    trial.map(stretch<D>(strain));
    trial.deform();
    const FractureResult result = trial.solid.fracture();
    EXPECT_EQ(result.bonds > 0, strain > 0.0);
  }
}

// A restored state continues with the same results.
TYPED_TEST(Flaws, AreRestoredBitForBit) {
  constexpr int D = TypeParam::D;
  auto first = flawed_block<D, typename TypeParam::P>();
  first.map(stretch<D>(0.012));
  first.deform();
  for (int n = 0; n < 3; ++n) first.solid.keep_damage(0.1);
  auto second = flawed_block<D, typename TypeParam::P>();
  second.map(stretch<D>(0.012));
  second.solid.restore(first.solid.save());
  for (auto* trial : {&first, &second}) {
    trial->deform();
    trial->solid.keep_damage(0.1);
    trial->evaluate();
  }
  const auto one = first.solid.save(), other = second.solid.save();
  for (std::size_t i = 0; i < first.size(); ++i) {
    for (int a = 0; a < D; ++a) ASSERT_EQ(one.acceleration[i][a], other.acceleration[i][a]);
    ASSERT_EQ(one.flaws[i].damage, other.flaws[i].damage);
    ASSERT_EQ(one.flaws[i].next, other.flaws[i].next);
  }
}

}  // namespace
}  // namespace kerf::test
