// SPDX-License-Identifier: Apache-2.0
// Free vibration of bars and plates against theory, and conservation of energy.
#include <gtest/gtest.h>

#include <functional>
#include <numbers>

#include "support/solid_blocks.hpp"

namespace kerf::test {
namespace {

template <class Chosen>
class Vibration : public testing::Test {};
TYPED_TEST_SUITE(Vibration, TwoKinds);
template <class Chosen>
class PlaneVibration : public testing::Test {};
TYPED_TEST_SUITE(PlaneVibration, PlaneOnly);

struct Motion {
  double period = 0.0;  // s
  double drift = 0.0;   // largest relative change of the total energy
};

// Starts the solid with velocities `shape` and follows its projection on the shape for two periods:
// the period is twice the time between the first and second zero crossing, by interpolation.
template <int D, class P>
Motion vibrate(SolidOnTrial<D, P>& trial,
               const std::function<Vector<D, double>(const Vector<D, double>&)>& shape, double dt) {
  std::vector<Vector<D, double>> mode;
  for (const auto& x : trial.layout.reference) mode.push_back(shape(x));
  for (std::size_t i = 0; i < trial.size(); ++i)
    trial.velocity[i] = Vector<D, typename P::Real>::from(mode[i]);
  const auto projection = [&] {
    double sum = 0.0;
    for (std::size_t i = 0; i < trial.size(); ++i)
      sum += dot(mode[i], Vector<D, double>::from(trial.velocity[i]));
    return sum;
  };
  trial.evaluate();
  const double start = trial.kinetic_energy() + trial.solid.energy().total();
  Motion motion;
  std::vector<double> zeros;
  double before = projection();
  for (int n = 0; zeros.size() < 3 && n < 100000; ++n) {
    trial.step(dt);
    const double now = projection();
    if (now * before < 0.0) zeros.push_back((n + before / (before - now)) * dt);
    before = now;
    if (n % 10 == 0) {
      const double energy = trial.kinetic_energy() + trial.solid.energy().total();
      motion.drift = std::max(motion.drift, std::abs(energy - start) / start);
    }
  }
  motion.period = zeros.size() == 3 ? zeros[2] - zeros[0] : 0.0;
  return motion;
}

// The first longitudinal mode of a free bar with nu = 0 has the period 2 L / sqrt(E / rho), without
// any effect of the width. Velocities of 1e-3 of the wave speed keep it linear.
TYPED_TEST(Vibration, LongitudinalPeriodOfABar) {
  constexpr int D = TypeParam::D;
  const double length = 0.02, e = 1e5;
  std::vector<double> errors;
  for (int cells : D == 2 ? std::vector{12, 24, 48} : std::vector{10, 20, 30}) {
    const double spacing = length / cells;
    auto medium = soft_solid(spacing, D);
    medium.bulk_modulus = e / 3.0;
    medium.shear_modulus = e / 2.0;
    SolidOnTrial<D, typename TypeParam::P> trial(
        block<D>({.cells = {cells, cells / 3, 4}, .spacing = spacing}, medium));
    const double c = std::sqrt(e / medium.density);
    const auto shape = [&](const Vector<D, double>& x) {
      auto v = Vector<D, double>::zero();
      v[0] = 1e-3 * c * std::cos(std::numbers::pi * x[0] / length);
      return v;
    };
    const Motion motion = vibrate<D>(trial, shape, 0.25 * spacing / c);
    const double expected = 2.0 * length / c;
    errors.push_back(motion.period / expected - 1.0);
    this->RecordProperty(
        "ppm_" + std::to_string(cells),
        std::to_string(1e6 * errors.back()) + " drift_ppm " + std::to_string(1e6 * motion.drift));
    // Kick-drift-kick conserves the energy to (omega dt)^2 / 8 of itself.
    const double phase = 2.0 * std::numbers::pi * 0.25 * spacing / (2.0 * length);
    EXPECT_LE(motion.drift, phase * phase / 4.0 + 1e-5);
  }
  for (double error : errors) EXPECT_LE(std::abs(error), 0.02);
  EXPECT_LE(std::abs(errors[2]), 0.5 * std::abs(errors[0]));
}

// A slender free plate with nu = 0.3 in plane strain: sqrt(E / (1 - nu^2) / rho), lowered by the
// inertia of the lateral motion, (nu' pi w / L)^2 / 24 with nu' = nu / (1 - nu), after Love.
TYPED_TEST(PlaneVibration, PlateInPlaneStrain) {
  const double length = 0.04;
  const int cells = 60;
  const double spacing = length / cells, width = 6 * spacing;
  auto medium = soft_solid(spacing, 2);
  SolidOnTrial<2, typename TypeParam::P> trial(
      block<2>({.cells = {cells, 6, 1}, .spacing = spacing}, medium));
  const double nu = 0.3, c = std::sqrt(1e5 / (1.0 - nu * nu) / medium.density);
  const auto shape = [&](const Vector<2, double>& x) {
    auto v = Vector<2, double>::zero();
    v[0] = 1e-3 * c * std::cos(std::numbers::pi * x[0] / length);
    return v;
  };
  const Motion motion = vibrate<2>(trial, shape, 0.2 * spacing / c);
  const double lateral = nu / (1.0 - nu) * std::numbers::pi * width / length;
  const double expected = 2.0 * length / c * (1.0 + lateral * lateral / 24.0);
  this->RecordProperty("ppm", std::to_string(1e6 * (motion.period / expected - 1.0)));
  EXPECT_NEAR(motion.period, expected, 0.02 * expected);
}

}  // namespace
}  // namespace kerf::test
