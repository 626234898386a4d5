// SPDX-License-Identifier: Apache-2.0
// Forces against the gradient of the stored energy, and against general laws of forces.
#include <gtest/gtest.h>

#include "support/solid_blocks.hpp"

namespace kerf::test {
namespace {

// Two materials in one piece, jittered, with some bonds cut, so that the layout has no symmetry.
template <int D>
SolidLayout<D> mixed_block(double jitter = 0.2) {
  auto layout = block<D>({.cells = {6, 6, 5}, .jitter = jitter, .seed = 7});
  auto stiff = soft_solid(1e-3, D);
  stiff.elasticity = ElasticLaw::st_venant_kirchhoff;
  stiff.density = 2000.0;
  stiff.bulk_modulus = 4e5;
  stiff.shear_modulus = 1.5e5;
  stiff.smoothing_length = 1.4e-3;
  stiff.hourglass = 0.8;
  layout.media.push_back(stiff);
  for (std::size_t i = 0; i < layout.reference.size(); ++i)
    layout.medium_index[i] = layout.reference[i][0] > 3e-3 ? 1 : 0;
  return layout;
}

template <int D>
struct AcrossNotch {
  KERF_FUNCTION bool operator()(const Vector<D, double>& a, const Vector<D, double>& b) const {
    return a[0] < 1.6e-3 && b[0] < 1.6e-3 && (a[1] < 3e-3) != (b[1] < 3e-3);
  }
};

template <int D, class P>
SolidOnTrial<D, P> deformed() {
  SolidOnTrial<D, P> trial(mixed_block<D>());
  trial.solid.cut(AcrossNotch<D>{});
  trial.map(some_map<D>());
  trial.displace_randomly(0.1e-3, 8);
  return trial;
}

template <class Chosen>
class SolidForce : public testing::Test {};
TYPED_TEST_SUITE(SolidForce, TwoKinds);
template <class Chosen>
class SolidForceGradient : public testing::Test {};
TYPED_TEST_SUITE(SolidForceGradient, DoubleOnly);

// m a = - d(stored energy)/dx on every particle, for the elastic and the hourglass part together.
TYPED_TEST(SolidForceGradient, ForceIsTheGradientOfTheStoredEnergy) {
  constexpr int D = TypeParam::D;
  auto trial = deformed<D, Double>();
  trial.evaluate();
  EXPECT_GT(trial.solid.energy().hourglass, 1e-3 * trial.solid.energy().elastic);
  std::vector<Vector<D, double>> force;
  double largest = 0.0;
  for (std::size_t i = 0; i < trial.size(); ++i) {
    force.push_back(trial.force(i));
    largest = std::max(largest, norm(force[i]));
  }
  const double step = 1e-8;  // m: 1e-5 of the spacing, error 1e-10 + rounding 1e-16 / 1e-5 of all
  const auto energy_at = [&](std::size_t i, int a, double shift) {
    trial.position[i][a] += shift;
    trial.deform();
    trial.position[i][a] -= shift;
    return trial.solid.energy().total();
  };
  double worst = 0.0;
  for (std::size_t i = 0; i < trial.size(); i += D == 2 ? 1 : 7)
    for (int a = 0; a < D; ++a) {
      const double slope = (energy_at(i, a, step) - energy_at(i, a, -step)) / (2.0 * step);
      worst = std::max(worst, std::abs(force[i][a] + slope));
    }
  EXPECT_LE(worst, 1e-7 * largest);
}

// Without and with viscosity the forces satisfy action and reaction and have no total torque.
TYPED_TEST(SolidForce, SumsAndTorquesVanish) {
  constexpr int D = TypeParam::D;
  for (bool viscous : {false, true}) {
    auto layout = mixed_block<D>();
    if (viscous)
      for (auto& medium : layout.media)
        medium.artificial_linear = medium.artificial_quadratic = 1.0;
    SolidOnTrial<D, typename TypeParam::P> trial(layout);
    trial.map(some_map<D>());
    trial.displace_randomly(0.1e-3, 8);
    std::mt19937 engine(3);
    std::uniform_real_distribution<double> uniform(-3.0, 3.0);
    for (auto& v : trial.velocity)
      for (int a = 0; a < D; ++a) v[a] = static_cast<typename TypeParam::Real>(uniform(engine));
    trial.evaluate();
    auto sum = Vector<D, double>::zero();
    Square<D> torque = Square<D>::Zero();
    double scale = 0.0, arm = 0.0, recorded = 0.0;
    for (std::size_t i = 0; i < trial.size(); ++i) {
      const auto f = trial.force(i);
      const auto& x = trial.position[i];
      sum += f;
      scale += norm(f);
      arm += norm(f) * norm(x);
      torque += as_column(x) * as_column(f).transpose() - as_column(f) * as_column(x).transpose();
      recorded += trial.solid.fields().viscous_power[i];
    }
    // Pairs cancel to the last bit; the remainder is the rounding of the sum of each particle.
    EXPECT_LE(norm(sum), TypeParam::rounding * scale);
    EXPECT_LE(torque.cwiseAbs().maxCoeff(), 10.0 * TypeParam::rounding * arm);
    EXPECT_EQ(recorded > 0.0, viscous);
  }
}

// The viscosity dissipates the power that it records, and resists approach only.
TYPED_TEST(SolidForce, ViscousPowerIsRecorded) {
  constexpr int D = TypeParam::D;
  using Trial = SolidOnTrial<D, typename TypeParam::P>;
  auto layout = mixed_block<D>();
  Trial plain(layout);
  for (auto& medium : layout.media) {
    medium.artificial_linear = 0.7;
    medium.artificial_quadratic = 1.3;
  }
  Trial viscous(layout);
  for (double sign : {-1.0, 1.0}) {
    for (Trial* trial : {&plain, &viscous}) {
      trial->map(some_map<D>());
      for (std::size_t i = 0; i < trial->size(); ++i)
        trial->velocity[i] =
            Vector<D, typename TypeParam::Real>::from(sign * 2000.0 * trial->position[i]);
      trial->evaluate();
    }
    double difference = 0.0, scale = 0.0, recorded = 0.0;
    for (std::size_t i = 0; i < plain.size(); ++i) {
      const auto v = Vector<D, double>::from(viscous.velocity[i]);
      difference += dot(viscous.force(i) - plain.force(i), v);
      scale += norm(v) * (norm(viscous.force(i)) + norm(plain.force(i)));
      recorded += viscous.solid.fields().viscous_power[i];
    }
    EXPECT_NEAR(-difference, recorded, 10.0 * TypeParam::rounding * scale);
    EXPECT_EQ(recorded > 0.0, sign < 0.0);
  }
}

// One approaching pair, computed by hand: q
// W'
// V_i V_j.
TYPED_TEST(SolidForceGradient, ViscousForceOfAWeakDeformation) {
  constexpr int D = TypeParam::D;
  auto medium = soft_solid(1e-3, D);
  medium.artificial_linear = 0.7;
  medium.artificial_quadratic = 1.3;
  SolidOnTrial<D, Double> trial(block<D>({.cells = {7, 7, 7}}, medium));
  const double v = 0.02;  // m/s, of one particle in the middle, along x
  const std::size_t middle = D == 2 ? 24 : 171;
  trial.velocity[middle][0] = v;
  trial.evaluate();
  double expected = 0.0;
  for (std::size_t j = 0; j < trial.size(); ++j) {
    if (j == middle) continue;
    const auto line = trial.position[j] - trial.position[middle];
    const double length = norm(line), speed = v * line[0] / length;
    if (!(speed > 0.0)) continue;
    const double h = medium.smoothing_length, theta = h * speed / length;
    const double q =
        medium.density * (0.7 * medium.bond_wave_speed() * theta + 1.3 * theta * theta);
    const double q_slope = -WendlandC2<D>::derivative(length, h) * q;
    expected -= medium.reference_volume() * medium.reference_volume() * q_slope * line[0] / length;
  }
  EXPECT_NEAR(trial.force(middle)[0], expected, 1e-12 * std::abs(expected));
}

// A bar is stretched uniformly along its length and confined laterally: the closed form of the
// neo-Hookean law is
//   sigma_xx = G lambda^(-5/3) (2/3)(lambda^2 - 1) + K/2 (lambda - 1/lambda).
TYPED_TEST(SolidForce, StretchedBar) {
  constexpr int D = TypeParam::D;
  using Real = typename TypeParam::Real;
  SolidOnTrial<D, typename TypeParam::P> trial(block<D>({.cells = {12, 6, 5}, .jitter = 0.2}));
  const auto& medium = trial.layout.media[0];
  for (double stretch : {0.5, 0.9, 1.001, 1.3, 2.0}) {
    Square<D> map = Square<D>::Identity();
    map(0, 0) = stretch;
    trial.map(map);
    trial.deform();
    const double g = medium.shear_modulus, k = medium.bulk_modulus, l = stretch;
    const double axial =
        g * std::pow(l, -5.0 / 3.0) * 2.0 / 3.0 * (l * l - 1.0) + 0.5 * k * (l - 1.0 / l);
    const double across =
        -g * std::pow(l, -5.0 / 3.0) * (l * l - 1.0) / 3.0 + 0.5 * k * (l - 1.0 / l);
    const double scale =
        30.0 * TypeParam::rounding * medium.young_modulus() * std::max(1.0, 1.0 / (l * l));
    for (std::size_t i = 0; i < trial.size(); ++i) {
      const auto stress = cauchy(Medium<Real>::from(medium), trial.gradient(i));
      ASSERT_NEAR(stress(0, 0), axial, scale);
      ASSERT_NEAR(stress(1, 1), across, scale);
      ASSERT_NEAR(stress(2, 2), across, scale);
      ASSERT_NEAR(stress(0, 1), 0.0, scale);
    }
  }
}

}  // namespace
}  // namespace kerf::test
