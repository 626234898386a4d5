// SPDX-License-Identifier: Apache-2.0
// A particle that becomes detached continues as a fluid with the pressure that it had.
#include <gtest/gtest.h>

#include "standard/solid_link.hpp"
#include "support/solid_blocks.hpp"

namespace kerf::test {
namespace {

template <class Chosen>
class DetachedPressure : public testing::Test {};
TYPED_TEST_SUITE(DetachedPressure, BothPrecisions);

// For a neo-Hookean solid p = K_b (1 / J - J) / 2 by the bonds, and the rest of K by the density.
TYPED_TEST(DetachedPressure, IsUnchanged) {
  constexpr int D = TypeParam::D;
  using P = typename TypeParam::P;
  using Real = typename P::Real;
  const auto by_bonds = soft_solid(1e-3, D);
  const double excess = 4e5, total = by_bonds.bulk_modulus + excess;
  Medium<double> medium;
  medium.phase = Phase::solid;
  medium.cavitates = true;
  medium.total_bulk_modulus = total;
  medium.excess_bulk_modulus = excess;
  medium.tait.exponent = 7.0;
  medium.tait.coefficient = total / 7.0;
  for (const double volume : {0.5, 0.9, 0.99, 1.02}) {
    SolidOnTrial<D, P> trial(block<D>({.cells = {6, 6, 6}}, by_bonds));
    trial.map(std::pow(volume, 1.0 / D) * Square<D>::Identity());
    trial.deform();
    Particles<D, P> particles;
    particles.resize(trial.size());
    to_device(std::vector{Medium<Real>::from(medium)}, particles.media);
    const auto count = static_cast<Index>(trial.size());
    std::vector<Index> index(count);
    for (Index i = 0; i < trial.size(); ++i) {
      index[i] = i;
      particles.id[i] = i;
      particles.source[i] = 0;
      particles.fractured[i] = 0;
      particles.compression[i] = Real(1.0 / volume - 1.0);
    }
    Array<Index> number, particle_of;
    to_device(index, number);
    to_device(index, particle_of);
    const SolidIndexView link{pointer(number), count, pointer(particle_of)};
    to_device(std::vector<std::uint8_t>(trial.size(), 1), particles.flags);
    Array<std::uint8_t> chosen;
    to_device(std::vector<std::uint8_t>(trial.size(), 1), chosen);
    trial.solid.break_all_bonds_of(chosen);
    for_each_index(count, MarkDetached<D, P>{particles.view(), link, trial.solid.view()});
    const double k = by_bonds.bulk_modulus;
    const double density_part = volume < 1.0 ? excess / 7.0 * (std::pow(volume, -7.0) - 1.0) : 0.0;
    const double due = std::max(0.0, 0.5 * k * (1.0 / volume - volume) + density_part);
    const double tolerance = std::is_same_v<Real, float> ? 3e-4 : 1e-10;
    for (Index i = 0; i < trial.size(); ++i) {
      ASSERT_EQ(particles.fractured[i], 1);
      const double after = pressure_at(Medium<Real>::from(medium), Real(particles.compression[i]));
      EXPECT_NEAR(after, due, tolerance * due);
    }
  }
}

}  // namespace
}  // namespace kerf::test
