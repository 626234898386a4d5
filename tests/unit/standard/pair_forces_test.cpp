// SPDX-License-Identifier: Apache-2.0
// Laws that the pair sums of the `standard` formulation must satisfy for any magnitude: action and
// reaction, no torque of central forces, no negative dissipation, contact force as the gradient of
// its potential.
#include <gtest/gtest.h>

#include <map>

#include "support/standard_mixture.hpp"

namespace kerf::test {
namespace {

template <class Dimension>
class StandardPairs : public testing::Test {
 protected:
  static constexpr int dimension = Dimension::value;
  using Mixture = LoadedStandard<dimension, Double>;

  // The particles have no rigid ones, on which no forces act.
  static ReferenceState mixture(unsigned seed) {
    ReferenceState state = standard_mixture(dimension, seed);
    std::erase_if(state.particles, [&](const ReferenceParticle& p) {
      return state.media[p.source].phase == Phase::rigid;
    });
    return state;
  }
  static Vector3 of(const Vector<dimension, double>& v) { return as_eigen(v); }

  struct Sums {
    Vector3 force = Vector3::Zero(), torque = Vector3::Zero();
    double force_scale = 0.0, torque_scale = 0.0;
    double loss = 0.0;  // W, - damping force . velocity
    void add(const Vector3& x, const Vector3& push) {
      force += push;
      torque += x.cross(push);
      force_scale += push.norm();
      torque_scale += x.norm() * push.norm();
    }
  };
  static Sums sums(const ReferenceState& state, const Mixture& loaded) {
    Sums sum;
    const auto place = loaded.places();
    for (std::size_t i = 0; i < place.size(); ++i) {
      const double m = state.medium(i).mass;
      sum.add(state.particles[i].position, m * of(loaded.particles.acceleration[place[i]]));
      sum.loss -=
          m * of(loaded.particles.damping_acceleration[place[i]]).dot(state.particles[i].velocity);
    }
    return sum;
  }
};
TYPED_TEST_SUITE(StandardPairs, MixtureDimensions);

// The pairs are water with water and with solid, and solids in contact; gravity enters the pairs of
// water and solid, and is subtracted.
TYPED_TEST(StandardPairs, ForcesSumToZero) {
  constexpr int D = TypeParam::value;
  for (unsigned seed = 1; seed <= 5; ++seed) {
    auto state = TestFixture::mixture(seed);
    if (seed > 2) stiffen_volume(state);
    state.gravity = {50.0, -981.0, D == 3 ? 30.0 : 0.0};
    const auto sum = TestFixture::sums(state, evaluated_standard<D, Double>(state));
    double mass = 0.0;
    for (std::size_t i = 0; i < state.particles.size(); ++i) mass += state.medium(i).mass;
    ASSERT_GT(sum.force_scale, 10.0 * mass * state.gravity.norm());
    EXPECT_LE((sum.force - mass * state.gravity).norm(), 1e-12 * sum.force_scale);
  }
}

// The force of water on solid is opposite to that of solid on water: the momentum gain of the water
// is the loss of the solid.
TYPED_TEST(StandardPairs, WaterAndSolidForcesAreOpposite) {
  constexpr int D = TypeParam::value;
  auto state = TestFixture::mixture(6);
  const auto loaded = evaluated_standard<D, Double>(state);
  const auto place = loaded.places();
  std::map<Phase, Vector3> force{{Phase::water, Vector3::Zero()}, {Phase::solid, Vector3::Zero()}};
  double scale = 0.0;
  for (std::size_t i = 0; i < place.size(); ++i) {
    const Vector3 push =
        state.medium(i).mass * TestFixture::of(loaded.particles.acceleration[place[i]]);
    force[state.medium(i).phase] += push;
    scale += push.norm();
  }
  EXPECT_GT(force[Phase::water].norm(), 1e-3 * scale);
  EXPECT_LE((force[Phase::water] + force[Phase::solid]).norm(), 1e-12 * scale);
}

// Pressure, its dissipation and contact act along the line of centres, viscosity and friction along
// the velocity; without these there is no torque.
TYPED_TEST(StandardPairs, CentralForcesHaveNoTorque) {
  auto state = TestFixture::mixture(7);
  for (auto& medium : state.media) medium.viscosity = medium.friction = 0.0;
  const auto sum = TestFixture::sums(state, evaluated_standard<TypeParam::value, Double>(state));
  ASSERT_GT(sum.torque_scale, 0.0);
  EXPECT_LE(sum.torque.norm(), 1e-12 * sum.torque_scale);
}

TYPED_TEST(StandardPairs, DissipationIsNotNegative) {
  for (unsigned seed = 8; seed <= 40; ++seed) {
    auto state = TestFixture::mixture(seed);
    if (seed % 2 == 0)
      for (auto& medium : state.media) medium.viscosity = 0.0;
    const auto sum = TestFixture::sums(state, evaluated_standard<TypeParam::value, Double>(state));
    EXPECT_GT(sum.loss, 0.0);
  }
}

// Each pair is tested alone, including water with wall or solid, so that no gain cancels in a sum.
TYPED_TEST(StandardPairs, DissipationOfEachPairIsNotNegative) {
  constexpr int D = TypeParam::value;
  std::mt19937 engine(5);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (int n = 0; n < 300; ++n) {
    auto state = standard_mixture(D, 1);
    state.particles.resize(2);
    state.particles[0].source = static_cast<std::size_t>(n % 2);
    state.particles[1].source = static_cast<std::size_t>(n / 2 % 6);
    state.particles[1].fractured = state.medium(1).phase == Phase::solid && n % 3 == 0;
    if (n % 4 < 2)
      for (auto& medium : state.media) medium.viscosity = 0.0;
    for (auto& particle : state.particles)
      for (int a = 0; a < D; ++a) {
        particle.position[a] = 5e-3 + 7e-4 * uniform(engine);
        particle.velocity[a] = 20.0 * uniform(engine);
      }
    if (state.medium(1).phase == Phase::rigid) state.particles[1].velocity.setZero();
    const double loss = TestFixture::sums(state, evaluated_standard<D, Double>(state)).loss;
    EXPECT_GE(loss, -1e-14);  // W, rounding of some tenths of a watt
  }
}

// Water between two wall particles, so that the normal of the wall is not the line of centres: the
// velocity towards the wall is damped, and the dissipation must not be negative for any position
// and motion.
TYPED_TEST(StandardPairs, DissipationInACornerIsNotNegative) {
  constexpr int D = TypeParam::value;
  std::mt19937 engine(6);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  int damped = 0;
  for (int n = 0; n < 500; ++n) {
    auto state = standard_mixture(D, 1);
    state.particles.resize(3);
    for (auto& medium : state.media) medium.viscosity = medium.friction = 0.0;
    state.particles[0].source = 0;
    state.particles[1].source = state.particles[2].source = static_cast<std::size_t>(2 + n % 4);
    for (auto& particle : state.particles) {
      particle.fractured = false;
      for (int a = 0; a < D; ++a) {
        particle.position[a] = 5e-3 + 7e-4 * uniform(engine);
        particle.velocity[a] = 20.0 * uniform(engine);
      }
    }
    for (std::size_t k : {1u, 2u})
      if (state.medium(k).phase == Phase::rigid) state.particles[k].velocity.setZero();
    LoadedStandard<D, Double> loaded(state, {.splits = true});
    evaluate_standard(state, loaded);  // computes the normal
    evaluate_standard(state, loaded);
    const double loss = TestFixture::sums(state, loaded).loss;
    EXPECT_GE(loss, -1e-13);
    damped += loss > 1e-6 ? 1 : 0;
  }
  EXPECT_GT(damped, 100);
}

TYPED_TEST(StandardPairs, NoRatesInTranslation) {
  constexpr int D = TypeParam::value;
  auto state = standard_mixture(D, 9);
  for (auto& particle : state.particles) {
    particle.velocity = {3.0, -7.0, D == 3 ? 2.0 : 0.0};
    particle.compression = 0.01;
  }
  const auto loaded = evaluated_standard<D, Double>(state);
  const auto place = loaded.places();
  double scale = 0.0;
  for (std::size_t i = 0; i < place.size(); ++i)
    scale = std::max(scale, std::abs(double(loaded.particles.compression_rate[place[i]])));
  // Both waters have uniform pressure: only the diffusion between them remains.
  for (std::size_t i = 0; i < place.size(); ++i)
    if (state.medium(i).phase != Phase::rigid) {
      EXPECT_LE(TestFixture::of(loaded.particles.damping_acceleration[place[i]]).norm(), 1e-9);
    }
  EXPECT_GT(scale, 0.0);
  for (auto& particle : state.particles) particle.compression = 0.0;
  const auto at_rest = evaluated_standard<D, Double>(state);
  for (std::size_t k = 0; k < place.size(); ++k)
    EXPECT_NEAR(double(at_rest.particles.compression_rate[k]), 0.0, 1e-9);
}

// A solid particle among two of its own body, one of another and a rigid one.
template <int D>
struct Touching {
  ReferenceState state = standard_mixture(D, 1);
  explicit Touching(const Vector3& x) {
    state.particles.assign(5, {});
    const double third = D == 3 ? 0.2e-3 : 0.0;
    const Vector3 places[] = {x,
                              {5.5e-3, 5.3e-3, third},
                              {4.3e-3, 4.8e-3, 0.0},
                              {4.9e-3, 5.9e-3, -third},
                              {5.0e-3, 4.1e-3, third}};
    const std::size_t sources[] = {2, 2, 3, 4,
                                   5};  // the coarse particles have another modulus below
    for (std::size_t k = 0; k < 5; ++k) {
      state.particles[k].position = places[k];
      state.particles[k].source = sources[k];
    }
    state.media[4].total_bulk_modulus = 5e5;
  }
};

TYPED_TEST(StandardPairs, ContactForceIsTheGradientOfItsPotential) {
  constexpr int D = TypeParam::value;
  const auto look = [](const Vector3& x) {
    const Touching<D> touching(x);
    const auto loaded = evaluated_standard<D, Double>(touching.state);
    const auto place = loaded.places();
    double energy = 0.0;
    for (std::size_t i = 0; i < place.size(); ++i)
      if (touching.state.medium(i).phase == Phase::solid)
        energy +=
            touching.state.medium(i).mass * double(loaded.particles.repulsion_potential[place[i]]);
    const Vector3 force = touching.state.medium(0).mass *
                          as_eigen(Vector<D, double>(loaded.particles.acceleration[place[0]]));
    return std::pair<Vector3, double>(force, energy);
  };
  const Vector3 here(5.1e-3, 5.0e-3, D == 3 ? 0.1e-3 : 0.0);
  const Vector3 force = look(here).first;
  EXPECT_GT(force.norm(), 0.0);
  const double step = 1e-8;  // the potential is quadratic: only rounding remains
  for (int a = 0; a < D; ++a) {
    Vector3 ahead = here, behind = here;
    ahead[a] += step;
    behind[a] -= step;
    const double slope = (look(ahead).second - look(behind).second) / (2.0 * step);
    EXPECT_NEAR(force[a], -slope, 1e-6 * force.norm());
  }
}

}  // namespace
}  // namespace kerf::test
