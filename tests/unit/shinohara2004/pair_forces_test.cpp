// SPDX-License-Identifier: Apache-2.0
// Laws that pair forces of any magnitude must satisfy: action and reaction, no torque by central
// forces, no rate in a rigid motion, repulsion as the gradient of its potential.
#include <gtest/gtest.h>

#include "shinohara2004/rates.hpp"
#include "support/loaded.hpp"
#include "support/mixture.hpp"

namespace kerf::test {
namespace {

template <class Dimension>
class PairForces : public testing::Test {
 protected:
  static constexpr int D = Dimension::value;

  static ReferenceState mixture(unsigned seed) {
    MixtureChoice choice;
    choice.dimension = D;
    choice.seed = seed;
    choice.per_side = D == 2 ? 16 : 8;
    choice.rigid = false;
    return random_mixture(choice);
  }

  static Loaded<D, Double> evaluated(const ReferenceState& state) {
    Loaded<D, Double> loaded(state, {});
    const Rates<D, Double> rates(Vector<D, double>::zero(), state.epsilon, state.exponent);
    rates.evaluate(loaded.particles, loaded.list.view());
    return loaded;
  }

  struct Balance {
    Vector3 force = Vector3::Zero(), torque = Vector3::Zero();
    double force_scale = 0.0, torque_scale = 0.0;
    double power = 0.0, power_scale = 0.0;  // force . velocity, W
    double booked = 0.0;                    // pressure and artificial power, W
  };
  static Balance balance(const ReferenceState& state, const Loaded<D, Double>& loaded) {
    Balance sum;
    const auto place = loaded.places();
    for (std::size_t i = 0; i < place.size(); ++i) {
      const Vector<D, double> acceleration = loaded.particles.acceleration[place[i]];
      const double m = state.medium(i).mass;
      const Vector3 force = m * as_eigen(acceleration);
      const Vector3& x = state.particles[i].position;
      const double power = force.dot(state.particles[i].velocity);
      sum.force += force;
      sum.torque += x.cross(force);
      sum.force_scale += force.norm();
      sum.torque_scale += x.norm() * force.norm();
      sum.power += power;
      sum.power_scale += std::abs(power);
      sum.booked += m * (loaded.particles.pressure_power[place[i]] +
                         loaded.particles.artificial_power[place[i]]);
    }
    return sum;
  }
};
using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(PairForces, Dimensions);

TYPED_TEST(PairForces, SumToZero) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    auto state = TestFixture::mixture(seed);
    state.epsilon = seed % 2 ? 0.3 : 0.0;
    const auto sum = TestFixture::balance(state, TestFixture::evaluated(state));
    ASSERT_GT(sum.force_scale, 0.0);
    EXPECT_LE(sum.force.norm(), 1e-12 * sum.force_scale);
  }
}

// Pressure and artificial viscosity act along the line of centres; shear does not.
TYPED_TEST(PairForces, CentralForcesHaveNoTorque) {
  auto state = TestFixture::mixture(6);
  for (auto& medium : state.media) medium.viscosity = 0.0;
  for (auto& particle : state.particles) particle.shear.setZero();
  const auto sum = TestFixture::balance(state, TestFixture::evaluated(state));
  ASSERT_GT(sum.torque_scale, 0.0);
  EXPECT_LE(sum.torque.norm(), 1e-12 * sum.torque_scale);
}

// The power of the forces equals that in the balance: pressure work and artificial dissipation.
TYPED_TEST(PairForces, PowerIsRecorded) {
  auto state = TestFixture::mixture(7);
  for (auto& medium : state.media) medium.viscosity = 0.0;
  for (auto& particle : state.particles) particle.shear.setZero();
  state.epsilon = 0.3;
  const auto sum = TestFixture::balance(state, TestFixture::evaluated(state));
  EXPECT_LE(std::abs(sum.power + sum.booked), 1e-12 * sum.power_scale);
  EXPECT_GT(std::abs(sum.power), 1e-3 * sum.power_scale);
}

// The shear forces have the power -s : grad v per volume, since both sums are over the same pairs.
TYPED_TEST(PairForces, ShearPowerIsStressPower) {
  auto state = TestFixture::mixture(8);
  for (auto& medium : state.media) medium.artificial_linear = medium.artificial_quadratic = 0.0;
  for (auto& particle : state.particles) particle.compression = 0.0;
  const auto loaded = TestFixture::evaluated(state);
  const auto sum = TestFixture::balance(state, loaded);
  const auto place = loaded.places();
  double stress_power = 0.0;
  for (std::size_t i = 0; i < place.size(); ++i) {
    const SymmetricTensor<TestFixture::D, double> s = loaded.particles.shear[place[i]];
    const Matrix<TestFixture::D, double> gradient = loaded.particles.velocity_gradient[place[i]];
    stress_power += state.medium(i).mass / state.density(i) *
                    as_eigen(s).cwiseProduct(as_eigen(gradient)).sum();
  }
  EXPECT_LE(std::abs(sum.power + stress_power), 1e-12 * sum.power_scale);
}

TYPED_TEST(PairForces, NoRatesInTranslation) {
  auto state = TestFixture::mixture(9);
  for (auto& particle : state.particles)
    particle.velocity = {3.0, -7.0, TestFixture::D == 3 ? 2.0 : 0.0};
  const auto loaded = TestFixture::evaluated(state);
  for (std::size_t k = 0; k < state.particles.size(); ++k) {
    EXPECT_EQ(double(loaded.particles.compression_rate[k]), 0.0);
    const Matrix<TestFixture::D, double> gradient = loaded.particles.velocity_gradient[k];
    EXPECT_EQ(as_eigen(gradient).norm(), 0.0);
    EXPECT_EQ(double(loaded.particles.artificial_power[k]), 0.0);
  }
}

// v_ij is at right angles to d_ij: no change of density, no artificial viscosity.
TYPED_TEST(PairForces, NoCompressionInRotation) {
  auto state = TestFixture::mixture(10);
  const Vector3 spin = TestFixture::D == 3 ? Vector3(40.0, -70.0, 90.0) : Vector3(0.0, 0.0, 100.0);
  for (auto& particle : state.particles) particle.velocity = spin.cross(particle.position);
  const auto loaded = TestFixture::evaluated(state);
  for (std::size_t k = 0; k < state.particles.size(); ++k) {
    // Scale: the spin times the sum of m_j |d| |grad W| / rho, of the order of 10.
    EXPECT_LE(std::abs(double(loaded.particles.compression_rate[k])), 1e-12 * 1e3);
  }
}

TYPED_TEST(PairForces, RepulsionIsTheGradientOfItsPotential) {
  constexpr int dimension = TestFixture::D;
  ReferenceState state;
  state.dimension = dimension;
  state.media = {mixture_water(1e-3, dimension), mixture_rigid(2e-3)};
  const double third = dimension == 3 ? 0.3e-3 : 0.0;
  const auto place_at = [&](const Vector3& x) {
    state.particles.assign(3, {});
    state.particles[0].position = x;
    for (std::size_t k : {1, 2}) {
      state.particles[k].source = 1;
      state.particles[k].repelling = true;
      state.particles[k].position = {k == 1 ? 5e-3 : 6.2e-3, 5e-3, 0.0};
    }
    const auto loaded = TestFixture::evaluated(state);
    const std::size_t k = loaded.places()[0];
    const Vector<dimension, double> force = loaded.particles.repulsion[k];
    return std::pair<Vector3, double>(as_eigen(force), loaded.particles.repulsion_potential[k]);
  };
  const Vector3 here(5.4e-3, 5.7e-3, third);
  const Vector3 force = place_at(here).first;
  EXPECT_GT(force[1], 0.0);  // upwards, away from the two below
  const double step = 1e-8;
  for (int a = 0; a < dimension; ++a) {
    Vector3 ahead = here, behind = here;
    ahead[a] += step;
    behind[a] -= step;
    const double slope = (place_at(ahead).second - place_at(behind).second) / (2.0 * step);
    EXPECT_NEAR(force[a], -slope, 1e-6 * force.norm());
  }
  // Both are 0 from d_0 = 1.5 mm on.
  const auto [none, zero] = place_at({5.6e-3, 5e-3 + 1.5e-3, third});
  EXPECT_EQ(none.norm(), 0.0);
  EXPECT_EQ(zero, 0.0);
}

}  // namespace
}  // namespace kerf::test
