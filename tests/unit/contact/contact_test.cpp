// SPDX-License-Identifier: Apache-2.0
// Contact of one solid: bonded particles have no contact force, particles with a broken bond have
// one.
#include <gtest/gtest.h>

#include <algorithm>

#include "standard/pair_forces.hpp"
#include "standard/solid_link.hpp"
#include "support/loaded.hpp"
#include "support/solid_blocks.hpp"

namespace kerf::test {
namespace {

constexpr double cut_at = 3e-3;  // m

template <int D>
struct ApartAt {
  KERF_FUNCTION bool operator()(const Vector<D, double>& a, const Vector<D, double>& b) const {
    return (a[0] < cut_at) != (b[0] < cut_at);
  }
};

// A block of 6 x 4 (x 4) particles compressed to 95%, so that all neighbours overlap.
template <class K>
class ContactOfBonds : public testing::Test {
 protected:
  static constexpr int dimension = K::D;
  using Precision = typename K::P;
  using Real = typename Precision::Real;

  // `gap`: reduction of the initial distance of the particles beyond the cut, m.
  static ReferenceState squeezed(const SolidLayout<dimension>& layout, double gap) {
    ReferenceState state;
    state.dimension = dimension;
    const Medium<double>& from = layout.media[0];
    Medium<double> medium;
    medium.phase = Phase::solid;
    medium.spacing = from.spacing;
    medium.smoothing_length = from.smoothing_length;
    medium.density = from.density;
    medium.mass = from.mass;
    medium.volume = from.reference_volume();
    medium.total_bulk_modulus = medium.bulk_modulus = from.bulk_modulus;
    medium.shear_modulus = from.shear_modulus;
    state.media = {medium};
    for (const auto& x : layout.reference) {
      ReferenceParticle particle;
      particle.position = 0.95 * as_eigen(x);
      if (x[0] > cut_at) particle.position[0] -= 0.95 * gap;
      state.particles.push_back(particle);
    }
    return state;
  }

  // Returns the contact force on each particle of the layout by the bonds of `solid`, N; it is the
  // same with and without fully bonded neighbours. `fully_bonded`: number of skipped particles.
  static std::vector<Vector3> forces(const SolidLayout<dimension>& layout,
                                     TotalLagrangian<dimension, Precision>& solid,
                                     std::size_t& fully_bonded, double gap = 0.0) {
    const ReferenceState state = squeezed(layout, gap);
    Loaded<dimension, Precision, ContactPairs> loaded(state, {.splits = true});
    std::vector<Index> number(layout.reference.size()), particle_of(number.size());
    const auto place = loaded.places();
    for (std::size_t s = 0; s < number.size(); ++s) {
      number[s] = static_cast<Index>(s);
      particle_of[s] = static_cast<Index>(place[s]);
    }
    const SolidIndexView link{number.data(), static_cast<Index>(number.size()), particle_of.data()};
    const StandardRates<dimension, Precision> rates(Vector<dimension, double>::zero(), state.media);
    NeighbourView list = loaded.list.view();
    const auto accelerate = [&] {
      rates.accelerate(loaded.particles.view(), loaded.particles.size(), list,
                       IntactBonds<dimension, Precision>{link, solid.view()});
      return to_host(loaded.particles.acceleration);
    };
    const auto by_all = accelerate();
    std::vector<std::uint8_t> is_fully_bonded(number.size(), 0);
    const MarkFullyBonded<dimension, Precision> mark{
        loaded.particles.view(), link, solid.view(), list, nullptr, is_fully_bonded.data()};
    for (Index s = 0; s < number.size(); ++s) mark(s);
    list.fully_bonded = is_fully_bonded.data();
    fully_bonded =
        static_cast<std::size_t>(std::count(is_fully_bonded.begin(), is_fully_bonded.end(), 1));
    const auto by_others = accelerate();
    std::vector<Vector3> result;
    for (std::size_t s = 0; s < number.size(); ++s) {
      for (int a = 0; a < dimension; ++a)
        EXPECT_EQ(by_all[place[s]][a], by_others[place[s]][a]) << s;
      result.push_back(layout.media[0].mass * as_eigen(Vector<dimension, Real>(by_all[place[s]])));
    }
    return result;
  }
};
TYPED_TEST_SUITE(ContactOfBonds, TwoKinds);

TYPED_TEST(ContactOfBonds, IntactBondsHaveNoContactForce) {
  constexpr int D = TypeParam::D;
  const auto layout = block<D>({.cells = {6, 4, 4}});
  TotalLagrangian<D, typename TypeParam::P> solid(layout);
  std::size_t fully_bonded = 0;
  for (const Vector3& force : TestFixture::forces(layout, solid, fully_bonded))
    EXPECT_EQ(force.norm(), 0.0);
  EXPECT_EQ(fully_bonded, layout.reference.size());
}

// Across the cut only nearest neighbours overlap: each of the two rows at it is repelled from it by
// M d^(D-2) times the overlap of 5% of the spacing, M = K + 4 G / 3.
TYPED_TEST(ContactOfBonds, BrokenBondsHaveContactForce) {
  constexpr int D = TypeParam::D;
  const auto layout = block<D>({.cells = {6, 4, 4}});
  TotalLagrangian<D, typename TypeParam::P> solid(layout);
  solid.cut(ApartAt<D>{});
  std::size_t fully_bonded = 0;
  const auto forces = TestFixture::forces(layout, solid, fully_bonded);
  const auto& medium = layout.media[0];
  const double modulus = medium.bulk_modulus + 4.0 / 3.0 * medium.shear_modulus;
  const double due = modulus * std::pow(1e-3, D - 2) * 0.05 * 1e-3;
  std::size_t pushed = 0;
  for (std::size_t s = 0; s < forces.size(); ++s) {
    const double x = layout.reference[s][0];
    Vector3 expected = Vector3::Zero();
    if (std::abs(x - cut_at) < 1e-3) expected[0] = x < cut_at ? -due : due;
    pushed += expected[0] != 0.0;
    // The overlap is a small difference, so that single precision leaves 1e-7 / 0.05.
    EXPECT_LE((forces[s] - expected).norm(), 20.0 * TypeParam::rounding * due) << s;
  }
  EXPECT_EQ(pushed, D == 2 ? 8u : 32u);
  EXPECT_LT(fully_bonded, layout.reference.size());  // bonds have a longer range than contact
}

// Two arms of one piece with an initial distance beyond the range of bonds, which have approached.
TYPED_TEST(ContactOfBonds, SeparatePartsInContactRepel) {
  constexpr int D = TypeParam::D;
  auto layout = block<D>({.cells = {6, 4, 4}});
  const double gap = 4e-3;  // m
  for (auto& x : layout.reference)
    if (x[0] > cut_at) x[0] += gap;
  TotalLagrangian<D, typename TypeParam::P> solid(layout);
  std::size_t fully_bonded = 0, pushed = 0;
  const auto forces = TestFixture::forces(layout, solid, fully_bonded, gap);
  for (std::size_t s = 0; s < forces.size(); ++s) {
    const double x = layout.reference[s][0] - (layout.reference[s][0] > cut_at ? gap : 0.0);
    const bool is_at_gap = std::abs(x - cut_at) < 1e-3;
    EXPECT_EQ(forces[s].norm() > 0.0, is_at_gap) << s;
    pushed += is_at_gap;
  }
  EXPECT_EQ(pushed, D == 2 ? 8u : 32u);
  EXPECT_EQ(fully_bonded, forces.size() - pushed);
}

}  // namespace
}  // namespace kerf::test
