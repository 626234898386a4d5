// SPDX-License-Identifier: Apache-2.0
// The right-hand side of the engine against double loops written from the paper's equations.
#include <gtest/gtest.h>

#include "support/kinds.hpp"
#include "support/loaded.hpp"
#include "support/mixture.hpp"

namespace kerf::test {
namespace {

// In double precision the tolerance is the rounding of sums of some hundred terms in different
// orders; in mixed precision it is single precision in fields and pairs.
template <class P>
constexpr double tolerance = std::is_same_v<P, Double> ? 1e-12 : 1e-4;

// Checks the largest error of a field over the largest value of that field.
struct Worst {
  double error = 0.0, scale = 0.0;
  void add(double difference, double magnitude) {
    error = std::max(error, difference);
    scale = std::max(scale, magnitude);
  }
};

template <class K>
class RatesOracle : public testing::Test {
 protected:
  static constexpr int D = K::D;
  using P = typename K::P;

  static ReferenceState mixture(unsigned seed) {
    MixtureChoice choice;
    choice.dimension = D;
    choice.seed = seed;
    choice.per_side = D == 2 ? 14 : 7;
    return random_mixture(choice);
  }

  static Loaded<D, P> evaluated(const ReferenceState& state) {
    Loaded<D, P> loaded(state, {});
    evaluate(state, loaded);
    return loaded;
  }
  static void evaluate(const ReferenceState& state, Loaded<D, P>& loaded) {
    const Rates<D, P> rates(Vector<D, double>::from(state.gravity), state.epsilon, state.exponent);
    rates.evaluate(loaded.particles, loaded.list.view());
  }

  static void compare(const ReferenceState& state, const Loaded<D, P>& loaded) {
    const ReferenceSph oracle(state);
    const auto place = loaded.places();
    Worst continuity, pressure, gradient, spin, shear, acceleration, repulsion, potential;
    for (std::size_t i = 0; i < place.size(); ++i) {
      const ReferenceRate& due = oracle.rates()[i];
      const auto& p = loaded.particles;
      const std::size_t k = place[i];
      if (state.medium(i).phase == Phase::rigid) continue;
      const auto add = [](Worst& worst, const auto& value, const auto& expected) {
        worst.add((value - expected).norm(), expected.norm());
      };
      continuity.add(std::abs(double(p.compression_rate[k]) - due.compression_rate),
                     std::abs(due.compression_rate));
      pressure.add(std::abs(double(p.pressure[k]) - due.pressure), std::abs(due.pressure));
      potential.add(std::abs(double(p.repulsion_potential[k]) - due.repulsion_potential),
                    due.repulsion_potential);
      add(gradient, as_eigen(Matrix<D, typename P::Real>(p.velocity_gradient[k])), due.gradient);
      if (state.medium(i).phase == Phase::solid)
        add(spin, as_eigen(SkewTensor<D, typename P::Real>(p.spin[k])), due.spin);
      add(shear, as_eigen(SymmetricTensor<D, typename P::Real>(p.shear[k])), due.shear);
      add(acceleration, as_eigen(Vector<D, typename P::Real>(p.acceleration[k])), due.acceleration);
      add(repulsion, as_eigen(Vector<D, typename P::Real>(p.repulsion[k])), due.repulsion);
    }
    EXPECT_LE(continuity.error, tolerance<P> * continuity.scale);
    EXPECT_LE(pressure.error, tolerance<P> * pressure.scale);
    EXPECT_LE(gradient.error, tolerance<P> * gradient.scale);
    EXPECT_LE(spin.error, tolerance<P> * spin.scale);
    EXPECT_GT(spin.scale, 0.0);
    EXPECT_LE(shear.error, tolerance<P> * shear.scale);
    EXPECT_LE(acceleration.error, tolerance<P> * acceleration.scale);
    EXPECT_LE(repulsion.error, tolerance<P> * repulsion.scale);
    EXPECT_LE(potential.error, tolerance<P> * potential.scale);
  }
};

TYPED_TEST_SUITE(RatesOracle, TwoKinds);

TYPED_TEST(RatesOracle, MixedParticlesWithGravity) {
  for (unsigned seed : {1u, 2u, 3u}) {
    auto state = TestFixture::mixture(seed);
    state.gravity = {0.3, -9.81, TestFixture::D == 3 ? 0.7 : 0.0};
    TestFixture::compare(state, TestFixture::evaluated(state));
  }
}

TYPED_TEST(RatesOracle, ArtificialStress) {
  auto state = TestFixture::mixture(4);
  state.epsilon = 0.3;
  TestFixture::compare(state, TestFixture::evaluated(state));
}

// Each term is tested alone, because strong terms would hide an error of weak ones.
TYPED_TEST(RatesOracle, ViscousStressAlone) {
  auto state = TestFixture::mixture(5);
  for (auto& medium : state.media)
    medium.artificial_linear = medium.artificial_quadratic = medium.repulsion = 0.0;
  for (auto& particle : state.particles) {
    particle.compression = 0.0;
    particle.shear.setZero();
  }
  TestFixture::compare(state, TestFixture::evaluated(state));
}

TYPED_TEST(RatesOracle, LinearArtificialViscosityAlone) {
  auto state = TestFixture::mixture(6);
  for (auto& medium : state.media) medium.viscosity = medium.artificial_quadratic = 0.0;
  for (auto& particle : state.particles) particle.shear.setZero();
  const ReferenceSph with(state);
  for (auto& medium : state.media) medium.artificial_linear = 0.0;
  const ReferenceSph without(state);
  for (auto& medium : state.media)
    medium.artificial_linear = medium.phase == Phase::solid ? 2.5 : 0.01;
  const auto loaded = TestFixture::evaluated(state);
  auto inviscid = state;
  for (auto& medium : inviscid.media) medium.artificial_linear = 0.0;
  const auto plain = TestFixture::evaluated(inviscid);
  const auto place = loaded.places(), plain_place = plain.places();
  Worst worst;
  for (std::size_t i = 0; i < place.size(); ++i) {
    using Field = Vector<TestFixture::D, typename TestFixture::P::Real>;
    const Vector3 expected = with.rates()[i].acceleration - without.rates()[i].acceleration;
    const Vector3 value = as_eigen(Field(loaded.particles.acceleration[place[i]])) -
                          as_eigen(Field(plain.particles.acceleration[plain_place[i]]));
    if (state.medium(i).phase != Phase::rigid)
      worst.add((value - expected).norm(), expected.norm());
  }
  EXPECT_LE(worst.error, tolerance<typename TestFixture::P> * worst.scale);
}

// The list holds while no particle has moved more than half the skin.
TYPED_TEST(RatesOracle, AfterMotionWithinTheSkin) {
  auto state = TestFixture::mixture(7);
  Loaded<TestFixture::D, typename TestFixture::P> loaded(state, {});
  const auto place = loaded.places();
  std::mt19937 engine(11);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (std::size_t i = 0; i < place.size(); ++i) {
    Vector3 step(uniform(engine), uniform(engine), TestFixture::D == 3 ? uniform(engine) : 0.0);
    step *= 0.2499 * 1e-3 / step.norm();
    state.particles[i].position += step;
    loaded.particles.position[place[i]] =
        Vector<TestFixture::D, double>::from(state.particles[i].position);
  }
  EXPECT_FALSE(loaded.list.is_outdated(loaded.particles, 0.0));
  TestFixture::evaluate(state, loaded);
  TestFixture::compare(state, loaded);
}

}  // namespace
}  // namespace kerf::test
