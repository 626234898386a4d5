// SPDX-License-Identifier: Apache-2.0
// The pair sums of the `standard` formulation against double loops written from its sources.
#include <gtest/gtest.h>

#include "support/gap.hpp"
#include "support/standard_mixture.hpp"

namespace kerf::test {
namespace {

template <class K>
class StandardRatesOracle : public testing::Test {
 protected:
  static constexpr int dimension = K::D;
  using Precision = typename K::P;
  // In double precision the tolerance is the rounding of sums of some hundred terms in different
  // orders; in mixed precision it is single precision in fields and pairs.
  static constexpr double tolerance = std::is_same_v<Precision, Double> ? 1e-12 : 1e-4;

  struct Gaps {
    Gap pressure, continuity, pressure_force, damping, total, from_rigid, energy;
  };

  static Gaps compare(const ReferenceState& state,
                      const LoadedStandard<dimension, Precision>& loaded,
                      ReferenceStandard::Normals normals = ReferenceStandard::Normals::unknown) {
    const ReferenceStandard oracle(state, bonds_of(state), normals);
    const auto place = loaded.places();
    const auto& p = loaded.particles;
    Gaps gaps;
    for (std::size_t i = 0; i < place.size(); ++i) {
      if (state.medium(i).phase == Phase::rigid) continue;
      const StandardRate& due = oracle.rates()[i];
      const std::size_t k = place[i];
      const double m = state.medium(i).mass;
      gaps.pressure.add(p.pressure[k], due.pressure);
      gaps.continuity.add(p.compression_rate[k], due.compression_rate);
      gaps.energy.add(p.repulsion_potential[k], due.contact_energy / m);
      gaps.pressure_force.add(of(p.pressure_acceleration[k]), due.pressure_force / m);
      gaps.damping.add(of(p.damping_acceleration[k]), due.damping / m);
      gaps.from_rigid.add(of(p.repulsion[k]), due.from_rigid / m);
      gaps.total.add(of(p.acceleration[k]), oracle.force(i) / m + state.gravity);
    }
    for (const Gap& gap : {gaps.pressure, gaps.continuity, gaps.pressure_force, gaps.damping,
                           gaps.total, gaps.from_rigid, gaps.energy})
      EXPECT_LE(gap.error, tolerance * gap.scale);
    return gaps;
  }

 private:
  static Vector3 of(const Vector<dimension, typename Precision::Real>& v) { return as_eigen(v); }
};
TYPED_TEST_SUITE(StandardRatesOracle, OtherTwoKinds);

TYPED_TEST(StandardRatesOracle, MixedParticlesWithGravity) {
  constexpr int D = TypeParam::D;
  for (unsigned seed : {1u, 2u, 3u}) {
    auto state = standard_mixture(D, seed);
    state.gravity = {3000.0, -9810.0,
                     D == 3 ? 700.0 : 0.0};  // large enough to be significant beside the pressures
    if (seed > 1) stiffen_volume(state);
    const auto gaps =
        TestFixture::compare(state, evaluated_standard<D, typename TypeParam::P>(state));
    for (const Gap& gap : {gaps.pressure, gaps.continuity, gaps.pressure_force, gaps.damping,
                           gaps.total, gaps.from_rigid, gaps.energy})
      EXPECT_GT(gap.scale, 0.0);
  }
}

// All pairs use the general terms, without the SIMD kernels.
TYPED_TEST(StandardRatesOracle, MixedParticlesInOnePairLoop) {
  constexpr int D = TypeParam::D;
  auto state = standard_mixture(D, 2);
  state.gravity = {3000.0, -9810.0, D == 3 ? 700.0 : 0.0};
  stiffen_volume(state);
  const auto gaps =
      TestFixture::compare(state, evaluated_standard<D, typename TypeParam::P>(state, false));
  EXPECT_GT(gaps.pressure_force.scale, 0.0);
}

// Each term is tested alone, because strong terms would hide an error of weak ones. Water that
// expands everywhere and has no pressure has viscous forces only.
TYPED_TEST(StandardRatesOracle, ViscosityAlone) {
  constexpr int D = TypeParam::D;
  auto state = standard_mixture(D, 4);
  const Vector3 spin(0.0, 0.0, 200.0);
  for (auto& particle : state.particles) {
    particle.compression = -0.01;
    particle.velocity = 100.0 * particle.position + spin.cross(particle.position);
  }
  const auto gaps =
      TestFixture::compare(state, evaluated_standard<D, typename TypeParam::P>(state));
  EXPECT_EQ(gaps.pressure_force.scale, 0.0);
  EXPECT_GT(gaps.damping.scale, 0.0);
}

TYPED_TEST(StandardRatesOracle, DissipationAlone) {
  constexpr int D = TypeParam::D;
  auto state = standard_mixture(D, 5);
  for (auto& medium : state.media) medium.viscosity = 0.0;
  for (auto& particle : state.particles) particle.compression = -0.01;
  const auto gaps =
      TestFixture::compare(state, evaluated_standard<D, typename TypeParam::P>(state));
  EXPECT_EQ(gaps.pressure_force.scale, 0.0);
  EXPECT_GT(gaps.damping.scale, 0.0);
}

TYPED_TEST(StandardRatesOracle, PressureAtRest) {
  constexpr int D = TypeParam::D;
  auto state = standard_mixture(D, 6);
  for (auto& particle : state.particles) particle.velocity.setZero();
  const auto gaps =
      TestFixture::compare(state, evaluated_standard<D, typename TypeParam::P>(state));
  EXPECT_EQ(gaps.damping.scale, 0.0);
  EXPECT_GT(gaps.pressure_force.scale, 0.0);
  EXPECT_GT(gaps.continuity.scale, 0.0);  // differences in pressure diffuse density
}

// From the second step on the normals of walls are known.
TYPED_TEST(StandardRatesOracle, WithNormalsOfWalls) {
  constexpr int D = TypeParam::D;
  using P = typename TypeParam::P;
  auto state = standard_mixture(D, 9);
  for (auto& medium : state.media) medium.viscosity = 0.0;
  LoadedStandard<D, P> loaded(state, {.splits = true});
  evaluate_standard(state, loaded);
  evaluate_standard(state, loaded);
  const auto gaps = TestFixture::compare(state, loaded, ReferenceStandard::Normals::known);
  EXPECT_GT(gaps.damping.scale, 0.0);
}

// The kernel sum of particles against the double sum. Compressed neighbours of another phase have a
// smaller volume than at rest.
TYPED_TEST(StandardRatesOracle, KernelSum) {
  constexpr int D = TypeParam::D;
  using P = typename TypeParam::P;
  auto state = standard_mixture(D, 8);
  stiffen_volume(state);
  const auto loaded = evaluated_standard<D, P>(state);
  const auto place = loaded.places();
  int squeezed = 0;
  for (std::size_t i = 0; i < place.size(); ++i) {
    const ReferenceParticle& a = state.particles[i];
    const auto& m = state.medium(i);
    const bool flows = m.phase == Phase::water || a.fractured;
    if (!flows) continue;  // the lists of others do not have all neighbours
    double due = m.volume * wendland(0.0, m.smoothing_length, D);
    for (std::size_t j = 0; j < place.size(); ++j) {
      if (j == i) continue;
      const auto& n = state.medium(j);
      const double h = m.phase == n.phase ? (m.smoothing_length + n.smoothing_length) / 2.0
                                          : std::max(m.smoothing_length, n.smoothing_length);
      const ReferenceParticle& b = state.particles[j];
      const bool has_density =
          n.phase == Phase::water || b.fractured || n.excess_bulk_modulus > 0.0;
      const bool is_squeezed = m.phase != n.phase && has_density && b.compression > 0.0;
      squeezed += is_squeezed;
      const double volume = is_squeezed ? n.volume / (1.0 + b.compression) : n.volume;
      due += volume * wendland((a.position - b.position).norm(), h, D);
    }
    EXPECT_NEAR(double(loaded.particles.kernel_sum[place[i]]), due, TestFixture::tolerance * due);
  }
  EXPECT_GT(squeezed, 10);
}

// The list holds while no particle has moved more than half the skin.
TYPED_TEST(StandardRatesOracle, AfterMotionWithinTheSkin) {
  constexpr int D = TypeParam::D;
  using P = typename TypeParam::P;
  auto state = standard_mixture(D, 7);
  LoadedStandard<D, P> loaded(state, {});
  const auto place = loaded.places();
  std::mt19937 engine(11);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (std::size_t i = 0; i < place.size(); ++i) {
    Vector3 step(uniform(engine), uniform(engine), D == 3 ? uniform(engine) : 0.0);
    step *= 0.2499 * 1e-3 / step.norm();
    state.particles[i].position += step;
    loaded.particles.position[place[i]] = Vector<D, double>::from(state.particles[i].position);
  }
  EXPECT_FALSE(loaded.list.is_outdated(loaded.particles, 0.0));
  evaluate_standard(state, loaded);
  TestFixture::compare(state, loaded);
}

}  // namespace
}  // namespace kerf::test
