// SPDX-License-Identifier: Apache-2.0
// Position Verlet on harmonic oscillators: second order, and an energy that oscillates without
// drift. Water also has its density.
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

// The force depends on the velocity, and the rate of the density too: at the middle of a step both
// are known from the last step only. x = e^(-g t) cos(w t), d rho/dt = v / 10.
TYPED_TEST(Verlet, VelocityDependentForcesAreOfSecondOrder) {
  constexpr int D = TypeParam::value;
  constexpr double g = 0.3, w = 1.1, end = 5.0;
  double errors[4];
  for (int k = 0; k < 4; ++k) {
    const int steps = 100 << k;
    const double dt = end / steps;
    std::vector<Medium<double>> media(1);
    media[0].phase = Phase::water;
    media[0].density = 1.0;
    Particles<D, Double> particles;
    to_device(media, particles.media);
    particles.resize(1);
    auto x = Vector<D, double>::zero(), v = x;
    x[1] = 1.0;
    v[1] = -g;
    particles.position[0] = x;
    particles.velocity[0] = v;
    particles.kernel_sum[0] = 0.0;
    for (int n = 0; n < steps; ++n) {
      for_each_index(1, SaveStepStart<D, Double>{particles.view()});
      for_each_index(1, DriftHalf<D, Double>{particles.view(), nullptr, dt});
      x = particles.position[0];
      v = particles.velocity[0];
      particles.acceleration[0] = -(g * g + w * w) * x + (-2.0 * g) * v;
      particles.compression_rate[0] = 0.1 * v[1];
      for_each_index(1, KickAndDrift<D, Double>{particles.view(), nullptr, dt});
      for_each_index(1, FinalizeDensity<D, Double>{particles.view(), dt});
    }
    x = particles.position[0];
    const double due = std::exp(-g * end) * std::cos(w * end);
    const double compression = particles.compression[0];
    errors[k] = std::max(std::abs(x[1] - due), std::abs(compression - 0.1 * (due - 1.0)));
  }
  std::printf("errors %.3e %.3e %.3e %.3e\n", errors[0], errors[1], errors[2], errors[3]);
  EXPECT_NEAR(errors[1] / errors[2], 4.0, 0.4);
  EXPECT_NEAR(errors[2] / errors[3], 4.0, 0.2);
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
