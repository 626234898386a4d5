// SPDX-License-Identifier: Apache-2.0
// Position Verlet on harmonic oscillators: second order, and an energy that oscillates without
// drift. The sound of water is of second order, its dissipation of first.
#include "time/verlet.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/precision.hpp"
#include "shinohara2004/midpoint.hpp"
#include "time/save_step_start.hpp"

namespace kerf::test {
namespace {

// One particle per frequency, along every axis with the phase of the axis.
template <int D>
class Oscillators {
 public:
  static constexpr int count = 3;
  explicit Oscillators(double dt) : dt_(dt) {
    std::vector<Medium<double>> media(1);
    media[0].phase = Phase::solid;
    media[0].density = 1.0;
    to_device(media, particles_.media);
    particles_.resize(count);
    for (int i = 0; i < count; ++i) {
      particles_.source[i] = 0;
      particles_.flags[i] = 0;
      Vector<D, double> x, v;
      for (int a = 0; a < D; ++a) {
        x[a] = std::cos(phase(a));
        v[a] = -omega(i) * std::sin(phase(a));
      }
      particles_.position[i] = x;
      particles_.velocity[i] = v;
    }
  }

  static double omega(int i) { return 1.0 + 0.5 * i; }  // 1/s
  static double phase(int a) { return 0.3 + 0.7 * a; }

  void step() {
    for_each_index(count, SaveStepStart<D, Double>{particles_.view()});
    for_each_index(count, DriftHalf<D, Double>{particles_.view(), nullptr, dt_});
    for (int i = 0; i < count; ++i)
      particles_.acceleration[i] = -omega(i) * omega(i) * Vector<D, double>(particles_.position[i]);
    for_each_index(count, KickAndDrift<D, Double>{particles_.view(), nullptr, dt_});
  }
  void turn_round() {
    for (int i = 0; i < count; ++i)
      particles_.velocity[i] = -1.0 * Vector<D, double>(particles_.velocity[i]);
  }

  Vector<D, double> position(int i) const { return particles_.position[i]; }
  double energy(int i) const {  // over omega^2
    const Vector<D, double> x = particles_.position[i], v = particles_.velocity[i];
    return 0.5 * (dot(x, x) + dot(v, v) / (omega(i) * omega(i)));
  }
  double error(double time) const {
    double worst = 0.0;
    for (int i = 0; i < count; ++i)
      for (int a = 0; a < D; ++a)
        worst = std::max(worst, std::abs(position(i)[a] - std::cos(omega(i) * time + phase(a))));
    return worst;
  }

 private:
  double dt_;
  Particles<D, Double> particles_;
};

template <class Dimension>
class Verlet : public testing::Test {};
using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(Verlet, Dimensions);

TYPED_TEST(Verlet, IsOfSecondOrder) {
  double errors[3];
  for (int k = 0; k < 3; ++k) {
    const int steps = 100 << k;
    Oscillators<TypeParam::value> oscillators(5.0 / steps);
    for (int n = 0; n < steps; ++n) oscillators.step();
    errors[k] = oscillators.error(5.0);
  }
  std::printf("errors %.3e %.3e %.3e\n", errors[0], errors[1], errors[2]);
  // The error is divided by four each time, up to the next order of the series, (omega dt)^2 = 1%.
  EXPECT_NEAR(errors[0] / errors[1], 4.0, 0.05);
  EXPECT_NEAR(errors[1] / errors[2], 4.0, 0.02);
}

// A wave of sound: a = - w eps, d eps/dt = w v. The density is that of half a step ahead, so
// eps starts as - sin(w dt / 2); v = - cos(w t), eps = - sin(w (t + dt / 2)).
template <int D>
struct Sound {
  static constexpr double w = 1.1, end = 5.0;
  double damping = 0.0;  // 1/s, by a dissipative force - damping v
  Particles<D, Double> particles;

  explicit Sound(double g) : damping(g) {
    std::vector<Medium<double>> media(1);
    media[0].phase = Phase::water;
    media[0].density = 1.0;
    to_device(media, particles.media);
    particles.resize(1);
    particles.kernel_sum[0] = -10.0;
  }
  // Returns the largest error of v and eps after `steps` steps.
  double error(int steps) {
    const double dt = end / steps;
    auto v = Vector<D, double>::zero();
    v[1] = -scale;
    particles.velocity[0] = v;
    particles.conservative_acceleration[0] = Vector<D, double>::zero();
    particles.compression[0] = damping > 0.0 ? 0.0 : -scale * std::sin(0.5 * w * dt);
    for (int n = 0; n < steps; ++n) step(dt, n == 0);
    v = particles.velocity[0];
    if (damping > 0.0) return std::abs(v[1] / scale + std::exp(-damping * end));
    return std::max(std::abs(v[1] / scale + std::cos(w * end)),
                    std::abs(particles.compression[0] / scale + std::sin(w * (end + 0.5 * dt))));
  }

 private:
  static constexpr double scale = 0.01;  // of eps and v
  void step(double dt, bool is_first) {
    const double stiffness = damping > 0.0 ? 0.0 : w;
    auto along = Vector<D, double>::zero();
    along[1] = 1.0;
    if (is_first)
      particles.conservative_acceleration[0] = (-stiffness * particles.compression[0]) * along;
    for_each_index(1, SaveStepStart<D, Double>{particles.view()});
    for_each_index(1, DriftHalf<D, Double>{particles.view(), nullptr, dt});
    const Vector<D, double> v = particles.velocity[0];
    particles.damping_acceleration[0] = -damping * v;
    particles.acceleration[0] = (-stiffness * particles.compression[0]) * along + (-damping) * v;
    particles.compression_rate[0] = stiffness * v[1];
    for_each_index(1, KickAndDrift<D, Double>{particles.view(), nullptr, dt});
    for_each_index(1, FinalizeDensity<D, Double>{particles.view(), dt});
  }
};

TYPED_TEST(Verlet, SoundIsOfSecondOrder) {
  double errors[3];
  for (int k = 0; k < 3; ++k) errors[k] = Sound<TypeParam::value>(0.0).error(200 << k);
  std::printf("errors %.3e %.3e %.3e\n", errors[0], errors[1], errors[2]);
  EXPECT_NEAR(errors[0] / errors[1], 4.0, 0.4);
  EXPECT_NEAR(errors[1] / errors[2], 4.0, 0.2);
}

// The velocity loses the share g dt in each step: first order, and no growth up to g dt = 2.
TYPED_TEST(Verlet, DissipationIsOfFirstOrderAndStableUpToTwo) {
  double errors[3];
  for (int k = 0; k < 3; ++k) errors[k] = Sound<TypeParam::value>(0.3).error(200 << k);
  EXPECT_NEAR(errors[0] / errors[1], 2.0, 0.05);
  EXPECT_NEAR(errors[1] / errors[2], 2.0, 0.03);
  constexpr double end = Sound<TypeParam::value>::end;
  EXPECT_LE(Sound<TypeParam::value>(1.9 * 20 / end).error(20), 1.0);
  EXPECT_GT(Sound<TypeParam::value>(2.1 * 20 / end).error(20), 1.0);
}

// The conserved energy is (1 + O((omega dt)^2)) of the true one: its oscillation is that of one
// revolution, after a thousand revolutions as in the first.
TYPED_TEST(Verlet, EnergyOscillatesWithoutDrift) {
  Oscillators<TypeParam::value> oscillators(0.1);
  double start[3], first[3] = {}, last[3] = {};
  for (int i = 0; i < 3; ++i) start[i] = oscillators.energy(i);
  const int steps = 60000, look = 300;
  for (int n = 1; n <= steps; ++n) {
    oscillators.step();
    for (int i = 0; i < 3; ++i) {
      const double swing = std::abs(oscillators.energy(i) / start[i] - 1.0);
      if (n <= look) first[i] = std::max(first[i], swing);
      if (n > steps - look) last[i] = std::max(last[i], swing);
    }
  }
  for (int i = 0; i < 3; ++i) {
    const double size = oscillators.omega(i) * 0.1;
    EXPECT_LE(first[i], size * size);
    EXPECT_NEAR(last[i], first[i], 0.02 * first[i]);  // the sampled instants differ
  }
}

// With reversed velocities the motion is retraced.
TYPED_TEST(Verlet, IsReversible) {
  constexpr int D = TypeParam::value;
  Oscillators<D> oscillators(0.2);
  const Oscillators<D> start(0.2);
  for (int n = 0; n < 1000; ++n) oscillators.step();
  EXPECT_GT(norm(oscillators.position(0) - start.position(0)), 0.1);
  oscillators.turn_round();
  for (int n = 0; n < 1000; ++n) oscillators.step();
  for (int i = 0; i < 3; ++i)
    EXPECT_LE(norm(oscillators.position(i) - start.position(i)), 1e-11);  // 2000 roundings
}

}  // namespace
}  // namespace kerf::test
