// SPDX-License-Identifier: Apache-2.0
// A total Lagrangian solid with plastic flow: each particle equals a material point, evaluations do
// not change the state, the energy balance is closed, and ductile damage detaches particles.
#include <cstring>

#include "support/plastic_paths.hpp"
#include "support/solid_blocks.hpp"

namespace kerf::test {
namespace {

template <class K>
class FlowingBlock : public testing::Test {
 protected:
  static constexpr int dimension = K::D;
  using Precision = typename K::P;

  static PlasticParameters<double> soft_metal() { return linear_hardening(2e3, 2e4); }
  static SolidLayout<dimension> layout(const PlasticParameters<double>& parameters) {
    auto result = block<dimension>({.jitter = 0.1});
    result.media[0].plastic = parameters;
    return result;
  }
  // The block is compressed along y and sheared, more in each of 20 steps.
  static Square<dimension> path(int step) {
    Square<dimension> m = Square<dimension>::Identity();
    m(1, 1) -= 0.3 * step / 20.0;
    m(0, 1) += 0.2 * step / 20.0;
    return m;
  }
};
TYPED_TEST_SUITE(FlowingBlock, TwoKinds);

// The deformation is uniform, also at the surface.
TYPED_TEST(FlowingBlock, IsAMaterialPoint) {
  constexpr int D = TypeParam::D;
  using Real = typename TypeParam::Real;
  const auto parameters = TestFixture::soft_metal();
  SolidOnTrial<D, typename TypeParam::P> trial(TestFixture::layout(parameters));
  auto state = PlasticState<D, double>::virgin();
  double work = 0.0, recorded = 0.0;
  for (int step = 1; step <= 20; ++step) {
    trial.map(TestFixture::path(step));
    trial.deform();
    Matrix3 f = Matrix3::Identity();
    f.topLeftCorner(D, D) = TestFixture::path(step);
    const auto result = advance(trial.layout.media[0], parameters, gradient_of<D>(f), 0.0, state);
    state = result.state;
    work += result.plastic_work;
    recorded += trial.solid.keep_flow();
  }
  ASSERT_GT(state.plastic_strain, 0.2);
  const std::vector<PlasticState<D, Real>> flow = to_host(trial.solid.fields().flow_start);
  for (const auto& particle : flow)
    EXPECT_NEAR(particle.plastic_strain, state.plastic_strain, 100 * TypeParam::rounding);
  double volume = 0.0;
  for (std::size_t i = 0; i < trial.size(); ++i) volume += trial.layout.media[0].reference_volume();
  EXPECT_NEAR(recorded, volume * work, 300 * TypeParam::rounding * volume * work);
}

TYPED_TEST(FlowingBlock, EvaluationsKeepTheState) {
  constexpr int D = TypeParam::D;
  SolidOnTrial<D, typename TypeParam::P> plain(TestFixture::layout(TestFixture::soft_metal()));
  SolidOnTrial<D, typename TypeParam::P> looked_at(plain.layout);
  for (int step = 1; step <= 20; ++step) {
    looked_at.map(TestFixture::path(2 * step));
    looked_at.deform();
    for (auto* trial : {&plain, &looked_at}) {
      trial->map(TestFixture::path(step));
      trial->deform();
      trial->solid.keep_flow();
    }
  }
  const auto a = plain.solid.save(), b = looked_at.solid.save();
  ASSERT_EQ(a.flow.size(), plain.size());
  EXPECT_EQ(std::memcmp(a.flow.data(), b.flow.data(), a.flow.size() * sizeof(a.flow[0])), 0);
}

// The kinetic, stored and dissipated energy of a block that is compressed by its own motion. The
// steps are of first order: a tenth of a percent of the input.
TYPED_TEST(FlowingBlock, ConservesTheEnergy) {
  constexpr int D = TypeParam::D;
  using Real = typename TypeParam::Real;
  SolidOnTrial<D, typename TypeParam::P> trial(TestFixture::layout(TestFixture::soft_metal()));
  const auto& medium = trial.layout.media[0];
  for (std::size_t i = 0; i < trial.size(); ++i)
    trial.velocity[i][1] = static_cast<Real>(-1000.0 * (trial.layout.reference[i][1] - 4e-3));
  const auto kinetic = [&] {
    double sum = 0.0;
    for (const auto& v : trial.velocity) sum += 0.5 * medium.mass * double(dot(v, v));
    return sum;
  };
  const double came = kinetic(), dt = 0.025 * medium.spacing / medium.bond_wave_speed();
  double plastic = 0.0, viscous = 0.0;
  for (int step = 0; step < 1600; ++step) {
    for (std::size_t i = 0; i < trial.size(); ++i)
      trial.position[i] += 0.5 * dt * Vector<D, double>::from(trial.velocity[i]);
    trial.evaluate();
    viscous += dt * trial.solid.viscous_power();
    plastic += trial.solid.keep_flow();
    trial.kick(dt);
    for (std::size_t i = 0; i < trial.size(); ++i)
      trial.position[i] += 0.5 * dt * Vector<D, double>::from(trial.velocity[i]);
  }
  trial.deform();
  const double stored = kinetic() + trial.solid.energy().total() + trial.solid.flow_work();
  EXPECT_GT(plastic, 0.3 * came);
  EXPECT_GE(viscous, 0.0);
  EXPECT_NEAR(stored + plastic + viscous, came, 3e-3 * came);
}

TYPED_TEST(FlowingBlock, DuctileDamageDetachesParticles) {
  constexpr int D = TypeParam::D;
  auto parameters = TestFixture::soft_metal();
  parameters.damage.constant = 0.1;
  parameters.damage.least_failure_strain = 1e-3;
  SolidOnTrial<D, typename TypeParam::P> trial(TestFixture::layout(parameters));
  for (int step = 1; step <= 20; ++step) {
    trial.map(TestFixture::path(step));
    trial.deform();
    const FractureResult result = trial.solid.fracture();
    const auto now = to_host(trial.solid.fields().current_flow);
    const double strain = now[0].plastic_strain;
    EXPECT_EQ(result.detached > 0, strain >= 0.1) << strain;
    if (result.detached > 0) {
      EXPECT_EQ(result.detached, trial.size());
      return;
    }
    trial.solid.keep_flow();
  }
  FAIL() << "nothing failed";
}

}  // namespace
}  // namespace kerf::test
