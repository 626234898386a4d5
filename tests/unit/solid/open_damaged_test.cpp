// SPDX-License-Identifier: Apache-2.0
// The density of nearly incompressible solid bears tension until the solid has lost a bond.
#include <gtest/gtest.h>

#include "standard/open_damaged.hpp"
#include "support/solid_blocks.hpp"

namespace kerf::test::open_damaged_test {
namespace {

// A block of one density all of whose particles bear tension.
template <int D, class P>
class BearingBlock {
 public:
  using Real = typename P::Real;

  explicit BearingBlock(double compression)
      : trial_(block<D>({.cells = {6, 6, 6}}, soft_solid(1e-3, D))) {
    Medium<double> medium = soft_solid(1e-3, D);
    medium.phase = Phase::solid;
    medium.cavitates = true;
    medium.total_bulk_modulus = 60.0 * medium.shear_modulus;
    medium.excess_bulk_modulus = 55.0 * medium.shear_modulus;
    medium.tensile_excess = 45.0 * medium.shear_modulus;
    medium.tait = {7.0, medium.total_bulk_modulus / 7.0};
    mass_ = medium.mass;
    modulus_ = medium.tensile_excess;
    density_ = medium.density;
    particles_.resize(count());
    to_device(std::vector{Medium<Real>::from(medium)}, particles_.media);
    std::vector<Index> index(count());
    for (Index i = 0; i < count(); ++i) {
      index[i] = i;
      particles_.id[i] = i;
      particles_.source[i] = 0;
      particles_.fractured[i] = 0;
      particles_.undamaged[i] = 1;
      particles_.pressure_work[i] = 0;
      particles_.compression[i] = Real(compression);
    }
    to_device(index, number_);
    to_device(index, particle_of_);
    trial_.deform();
  }
  Index count() const { return static_cast<Index>(trial_.size()); }
  double mass() const { return mass_; }
  // What Tait's law of this modulus stores, J/kg: the integral of p / rho^2 d rho, by Simpson's
  // rule.
  double stored(double compression) const {
    constexpr int steps = 200;
    double sum = 0.0;
    for (int k = 0; k <= steps; ++k) {
      const double ratio = 1.0 + compression * k / steps;
      const double weight = k == 0 || k == steps ? 1.0 : k % 2 == 0 ? 2.0 : 4.0;
      sum += weight * modulus_ / 7.0 * (std::pow(ratio, 7.0) - 1.0) / (density_ * ratio * ratio);
    }
    return sum * compression / steps / 3.0;
  }
  void break_bonds_of(Index particle) {
    std::vector<std::uint8_t> chosen(count(), 0);
    chosen[particle] = 1;
    Array<std::uint8_t> marks;
    to_device(chosen, marks);
    trial_.solid.break_all_bonds_of(marks);
  }
  double open() {
    const SolidIndexView link{pointer(number_), count(), pointer(particle_of_)};
    OrderedSum<1> sum;
    return sum(count(), OpenDamaged<D, P>{particles_.view(), link, trial_.solid.view()}).value[0];
  }
  Index bearing() const {
    Index sum = 0;
    for (Index i = 0; i < count(); ++i) sum += particles_.undamaged[i];
    return sum;
  }
  Index with_all_bonds() const {
    const auto view = const_cast<BearingBlock*>(this)->trial_.solid.view();
    Index sum = 0;
    for (Index s = 0; s < count(); ++s) sum += view.has_broken_bonds[s] == 0;
    return sum;
  }
  double work() const {  // J/kg
    double sum = 0.0;
    for (Index i = 0; i < count(); ++i) sum += double(particles_.pressure_work[i]);
    return sum;
  }

 private:
  SolidOnTrial<D, P> trial_;
  double mass_ = 0.0, modulus_ = 0.0, density_ = 0.0;
  Particles<D, P> particles_;
  Array<Index> number_, particle_of_;
};

template <class Chosen>
class OpenDamagedDensity : public testing::Test {};
TYPED_TEST_SUITE(OpenDamagedDensity, TwoKinds);

TYPED_TEST(OpenDamagedDensity, ReleasesWhatItStoredInTension) {
  const double tolerance = std::max(1e-5, 10.0 * TypeParam::rounding);
  for (const double compression : {-0.02, 0.02}) {
    BearingBlock<TypeParam::D, typename TypeParam::P> trial(compression);
    EXPECT_EQ(trial.open(), 0.0);
    EXPECT_EQ(trial.bearing(), trial.count());
    trial.break_bonds_of(trial.count() / 2);
    const double released = trial.open();
    EXPECT_EQ(trial.bearing(), trial.with_all_bonds());
    const double opened = trial.count() - trial.bearing();
    EXPECT_GT(opened, 8.0);
    const double due = compression < 0.0 ? trial.mass() * opened * trial.stored(compression) : 0.0;
    EXPECT_GE(due, 0.0);
    EXPECT_NEAR(released, due, tolerance * due);
    EXPECT_NEAR(trial.mass() * trial.work(), -due, tolerance * due);
    EXPECT_EQ(trial.open(), 0.0);
  }
}

}  // namespace
}  // namespace kerf::test::open_damaged_test
