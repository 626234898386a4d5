// SPDX-License-Identifier: Apache-2.0
// The stress of a body in rigid motion: the Jaumann rate must rotate it. The motion is imposed on
// every particle at both stages of the step; the engine computes the rest.
#include <gtest/gtest.h>

#include <numbers>

#include "shinohara2004/midpoint.hpp"
#include "support/loaded.hpp"
#include "support/mixture.hpp"
#include "time/save_step_start.hpp"

namespace kerf::test {
namespace {

constexpr double spacing = 2e-3;            // m
constexpr double interior = 1.1 * spacing;  // m: interior particles have all neighbours
constexpr double radius = 4.2 * spacing;    // m, of the disc or ball
constexpr double rim_speed = 5.0;           // m/s

// A disc or ball of tofu under uniform stress, centred on the origin.
ReferenceState stressed_ball(int dimension) {
  ReferenceState state;
  state.dimension = dimension;
  state.media = {mixture_solid(spacing, dimension, 0)};
  state.media[0].failure_strain = 0.0;
  Matrix3 shear;
  shear << 900.0, 500.0, 0.0, 500.0, -700.0, 0.0, 0.0, 0.0, -200.0;
  if (dimension == 3) {
    shear(0, 2) = shear(2, 0) = 300.0;
    shear(1, 2) = shear(2, 1) = -400.0;
  }
  for (int k = 0; k < (dimension == 3 ? 729 : 81); ++k) {
    ReferenceParticle particle;
    particle.position =
        spacing * Vector3(k % 9 - 4, k / 9 % 9 - 4, dimension == 3 ? k / 81 - 4 : 0);
    particle.shear = shear;
    if (particle.position.norm() < radius) state.particles.push_back(particle);
  }
  return state;
}

// The velocity gradient that the stress follows.
enum class Gradient { of_the_engine, exact };

struct Outcome {
  double tensor = 0.0;     // worst |s - R s_0 R^T| / |s_0| over the interior
  double magnitude = 0.0;  // worst | |s| - |s_0| | / |s_0|, an error of the invariants
  double compression = 0.0;
  std::size_t steps = 0;
};

template <int D>
class Turning {
 public:
  Turning() : state_(stressed_ball(D)), loaded_(state_, {-0.02, 0.02, 1e-3}) {
    const auto& solid = state_.media[0];
    // The default step of the engine: C h / (c + |v| + 1.2 A c_0), C = 0.25.
    const double least =
        0.25 * solid.smoothing_length /
        (std::sqrt((solid.bulk_modulus + 4.0 / 3.0 * solid.shear_modulus) / solid.density) +
         rim_speed + 1.2 * solid.artificial_linear * solid.sound_speed);
    axis_ = D == 3 ? Vector3(1.0, 2.0, -2.0) / 3.0 : Vector3(0.0, 0.0, 1.0);
    rate_ = rim_speed / radius;
    turn_ = 2.0 * std::numbers::pi / rate_;
    steps_ = static_cast<std::size_t>(std::ceil(turn_ / least));
    place_ = loaded_.places();
    to_device(std::vector<PrescribedMotion<D>>(1), prescribed_motions_);
  }

  Outcome one_turn(Gradient gradient) {
    const double dt = turn_ / static_cast<double>(steps_);
    for (std::size_t n = 0; n < steps_; ++n) {
      const double t = static_cast<double>(n) * dt;
      move_to(t);
      if (n % 16 == 0) loaded_.rebuild();
      place_ = loaded_.places();
      evaluate(gradient);
      const auto count = loaded_.particles.size();
      for_each_index(count, SaveStepStart<D, Double>{loaded_.particles.view()});
      advance(0.5 * dt);
      move_to(t + 0.5 * dt);
      evaluate(gradient);
      advance(dt);
    }
    return outcome();
  }

 private:
  void move_to(double t) {
    const Matrix3 turned = Eigen::AngleAxisd(rate_ * t, axis_).toRotationMatrix();
    place_ = loaded_.places();
    for (std::size_t i = 0; i < place_.size(); ++i) {
      const Vector3 x = turned * state_.particles[i].position;
      const Vector3 v = rate_ * axis_.cross(x);
      loaded_.particles.position[place_[i]] = Vector<D, double>::from(x);
      loaded_.particles.velocity[place_[i]] = Vector<D, double>::from(v);
    }
  }
  void evaluate(Gradient gradient) {
    rates_.evaluate(loaded_.particles, loaded_.list.view());
    if (gradient == Gradient::of_the_engine) return;
    Matrix<D, double> turning = Matrix<D, double>::zero();
    const Matrix3 cross =
        (Matrix3() << 0.0, -axis_[2], axis_[1], axis_[2], 0.0, -axis_[0], -axis_[1], axis_[0], 0.0)
            .finished();
    for (int a = 0; a < D; ++a)
      for (int b = 0; b < D; ++b) turning(a, b) = rate_ * cross(a, b);
    thrust::fill(loaded_.particles.velocity_gradient.begin(),
                 loaded_.particles.velocity_gradient.end(), turning);
    thrust::fill(loaded_.particles.spin.begin(), loaded_.particles.spin.end(),
                 SkewTensor<D, double>::part_of(turning));
  }
  void advance(double dt) {
    for_each_index(
        loaded_.particles.size(),
        AdvanceFromStart<D, Double>{loaded_.particles.view(), pointer(prescribed_motions_), dt});
  }

  // After one turn the body is at its initial position, so its stress must be the initial one.
  Outcome outcome() const {
    Outcome worst;
    worst.steps = steps_;
    const Matrix3 before = state_.particles[0].shear;
    for (std::size_t i = 0; i < place_.size(); ++i) {
      if (state_.particles[i].position.norm() > interior) continue;
      const SymmetricTensor<D, double> s = loaded_.particles.shear[place_[i]];
      const Matrix3 after = as_eigen(s);
      worst.tensor = std::max(worst.tensor, (after - before).norm() / before.norm());
      worst.magnitude = std::max(worst.magnitude, std::abs(after.norm() / before.norm() - 1.0));
      worst.compression =
          std::max(worst.compression, std::abs(double(loaded_.particles.compression[place_[i]])));
    }
    return worst;
  }

  ReferenceState state_;
  Loaded<D, Double> loaded_;
  Rates<D, Double> rates_{Vector<D, double>::zero()};
  Array<PrescribedMotion<D>> prescribed_motions_;
  Vector3 axis_;
  double rate_ = 0.0, turn_ = 0.0;
  std::size_t steps_ = 0;
  std::vector<std::size_t> place_;
};

template <class Dimension>
class RigidRotation : public testing::Test {
 protected:
  static constexpr int D = Dimension::value;
  // All tests share one turn.
  static const Outcome& turned_by_the_engine() {
    static const Outcome outcome = Turning<D>().one_turn(Gradient::of_the_engine);
    return outcome;
  }
  static void print(const char* what, const Outcome& outcome) {
    std::printf("%dD, %s: |ds|/|s| = %.3e, magnitude %.3e, %zu steps\n", D, what, outcome.tensor,
                outcome.magnitude, outcome.steps);
  }
};
using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(RigidRotation, Dimensions);

// Tests the time stepping alone, with the exact gradient of the motion.
TYPED_TEST(RigidRotation, TimeSteppingKeepsTheStress) {
  const Outcome outcome = Turning<TestFixture::D>().one_turn(Gradient::exact);
  TestFixture::print("exact gradient", outcome);
  EXPECT_LT(outcome.tensor, 1e-3);
  EXPECT_LT(outcome.compression, 1e-12);
}

// Tests the invariants of the stress, on which fracture and energy depend, for any gradient. The
// midpoint rule increases the amplitude of a rotation by an angle a per step by a^4/8; a tensor
// rotates by twice the angle of its body.
TYPED_TEST(RigidRotation, InvariantsAreKept) {
  const Outcome& outcome = TestFixture::turned_by_the_engine();
  const auto steps = static_cast<double>(outcome.steps);
  EXPECT_LT(outcome.magnitude, 1.1 * std::pow(4.0 * std::numbers::pi / steps, 4) / 8.0 * steps);
  EXPECT_LT(outcome.compression, 1e-12);
}

// Tests the tensor itself in the axes of the body.
TYPED_TEST(RigidRotation, StressTurnsWithTheBody) {
  const Outcome& outcome = TestFixture::turned_by_the_engine();
  TestFixture::print("gradient of the engine", outcome);
  EXPECT_LT(outcome.tensor, 0.01);
}

// A body with prescribed motion keeps its stress up to rounding.
TYPED_TEST(RigidRotation, TranslationKeepsTheStress) {
  constexpr int dimension = TestFixture::D;
  ReferenceState state = stressed_ball(dimension);
  for (auto& particle : state.particles)
    particle.velocity = {3.0, -2.0, dimension == 3 ? 1.0 : 0.0};
  Loaded<dimension, Double> loaded(state, {-0.02, 0.02, 1e-3});
  const Rates<dimension, Double> rates(Vector<dimension, double>::zero());
  Array<PrescribedMotion<dimension>> drives(1);
  const auto count = loaded.particles.size();
  rates.evaluate(loaded.particles, loaded.list.view());
  for_each_index(count, SaveStepStart<dimension, Double>{loaded.particles.view()});
  for_each_index(
      count, AdvanceFromStart<dimension, Double>{loaded.particles.view(), pointer(drives), 1e-5});
  for (std::size_t i : loaded.places()) {
    const SymmetricTensor<dimension, double> s = loaded.particles.shear[i];
    EXPECT_EQ((as_eigen(s) - state.particles[0].shear).norm(), 0.0);
    EXPECT_EQ(double(loaded.particles.compression[i]), 0.0);
  }
}

}  // namespace
}  // namespace kerf::test
