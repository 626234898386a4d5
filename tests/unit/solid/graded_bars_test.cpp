// SPDX-License-Identifier: Apache-2.0
// Bars, beams and strips with jumps of the spacing, against uniform ones and theory.
#include <gtest/gtest.h>

#include <cstdio>
#include <numbers>

#include "fracture/crack_band.hpp"
#include "support/graded_blocks.hpp"
#include "support/notched_strip.hpp"

namespace kerf::test {
namespace {

// A bar under tension comes to rest with uniform stress.
TEST(GradedBar, CarriesOneStress) {
  const BlockChoice choice{.cells = {30, 8, 1}};
  auto medium = soft_solid(choice.spacing, 2);
  medium.bulk_modulus = 1e5 / 3.0;  // nu = 0: a bar keeps its width
  medium.shear_modulus = 0.5e5;
  const auto layout =
      graded_block<2>(choice, medium, [](const Vector<2, double>& x) { return x[0] > 30e-3; });
  SolidOnTrial<2, Double> trial(layout);
  Square<2> pull = Square<2>::Identity();
  const double strain = 1e-3;
  pull(0, 0) += strain;
  trial.map(pull);
  trial.evaluate();
  const double dt = 0.2e-3 / medium.bond_wave_speed();
  for (int n = 0; n < 3000; ++n) {
    for (std::size_t i = 0; i < trial.size(); ++i) {
      const bool end = layout.reference[i][0] < 6e-3 || layout.reference[i][0] > 54e-3;
      trial.velocity[i] = end ? Vector<2, double>::zero() : 0.98 * trial.velocity[i];
    }
    for (std::size_t i = 0; i < trial.size(); ++i) trial.position[i] += dt * trial.velocity[i];
    trial.evaluate();
    trial.kick(dt);
  }
  double worst = 0.0;
  for (std::size_t i = 0; i < trial.size(); ++i) {
    const auto x = layout.reference[i];
    if (x[0] < 12e-3 || x[0] > 48e-3 || x[1] < 5e-3 || x[1] > 11e-3) continue;
    worst = std::max(worst, std::abs(trial.gradient(i)(0, 0) / strain - 1.0));
  }
  std::printf("bar at rest: strain within %.2f%% of uniform\n", 100.0 * worst);
  EXPECT_LE(worst, 0.03);
}

// A pulse travels along a bar (nu = 0, so that P waves are bar waves) from the fine into the coarse
// half or back. `length_in_coarse`: about 4 standard deviations. Returns the reflected speed over
// that of the pulse.
double reflected(double length_in_coarse, bool from_fine) {
  const double coarse = 1e-3, long_half = 60.0 * coarse, width = length_in_coarse * coarse;
  auto medium = soft_solid(0.5 * coarse, 2);
  medium.bulk_modulus = 1e5 / 3.0;
  medium.shear_modulus = 0.5e5;
  const auto layout =
      graded_block<2>({.cells = {120, 6, 1}, .spacing = 0.5 * coarse}, medium,
                      [&](const Vector<2, double>& x) { return (x[0] > long_half) == from_fine; });
  SolidOnTrial<2, Double> trial(layout);
  const double c = medium.bond_wave_speed(), start = 0.5 * long_half, speed = 1e-3 * c;
  for (std::size_t i = 0; i < trial.size(); ++i) {
    // v = V exp(-s^2), u' = -v / c
    const double s = (layout.reference[i][0] - start) / (0.25 * width);
    trial.velocity[i][0] = speed * std::exp(-s * s);
    trial.position[i][0] -=
        speed / c * 0.25 * width * 0.5 * std::sqrt(std::numbers::pi) * (std::erf(s) - 1.0);
  }
  trial.evaluate();
  const double dt = 0.2 * 0.5 * coarse / c, time = (long_half + 0.1 * long_half) / c;
  for (double t = 0.0; t < time; t += dt) trial.step(dt);
  double back = 0.0;
  for (std::size_t i = 0; i < trial.size(); ++i)
    if (layout.reference[i][0] < long_half - width)
      back = std::max(back, std::abs(trial.velocity[i][0]) / speed);
  return back;
}
TEST(GradedBar, WavesPassTheJump) {
  for (const bool from_fine : {true, false}) {
    const double of_20 = reflected(20.0, from_fine), of_10 = reflected(10.0, from_fine);
    std::printf("reflected of a pulse 20 and 10 coarse spacings long: %.4f, %.4f\n", of_20, of_10);
    EXPECT_LE(of_20, 0.02);
    EXPECT_LE(of_10, 0.04);
  }
}

// The first bending mode of a free beam that is fine in the middle third has the frequency of the
// beam that is fine everywhere. Euler-Bernoulli theory would be wrong by the shear of such a thick
// beam.
double bending_period(bool graded) {
  const double fine = 0.5e-3, length = 72e-3;
  auto medium = soft_solid(fine, 2);
  medium.bulk_modulus = 1e5 / 3.0;
  medium.shear_modulus = 0.5e5;
  const auto layout = graded_block<2>(
      {.cells = {72, 8, 1}, .spacing = fine}, medium, [&](const Vector<2, double>& x) {
        return graded && std::abs(x[0] - 0.5 * length) > length / 6.0;
      });
  SolidOnTrial<2, Double> trial(layout);
  // The approximate first mode of a free beam has zeros at 0.224 of the length from the ends.
  const auto mode = [&](double x) {
    return std::cos(2.0 * (x / length - 0.5) * 2.365) -
           0.133 * std::cosh(2.0 * (x / length - 0.5) * 2.365);
  };
  for (std::size_t i = 0; i < trial.size(); ++i)
    trial.velocity[i][1] = 0.05 * mode(layout.reference[i][0]);
  const auto projection = [&] {
    double sum = 0.0;
    for (std::size_t i = 0; i < trial.size(); ++i)
      sum += layout.media[layout.medium_index[i]].mass *
             (trial.position[i][1] - layout.reference[i][1]) * mode(layout.reference[i][0]);
    return sum;
  };
  trial.evaluate();
  const double dt = 0.3 * fine / medium.bond_wave_speed();
  std::vector<double> zeros;
  double before = 0.0;
  for (int n = 0; zeros.size() < 2 && n < 8000; ++n) {
    trial.step(dt);
    const double now = projection();
    if (now * before < 0.0) zeros.push_back((n + before / (before - now)) * dt);
    before = now;
  }
  return zeros.size() == 2 ? 2.0 * (zeros[1] - zeros[0]) : 0.0;
}
TEST(GradedBeam, BendsLikeAUniformBeam) {
  const double uniform = bending_period(false), graded = bending_period(true);
  std::printf("bending: period %.5g s uniform, %.5g s graded\n", uniform, graded);
  // Eight coarse particles across the beam are 2% too stiff in bending
  // (docs/theory/total_lagrangian.md), over the two outer thirds, which bend least.
  EXPECT_GT(uniform, 0.0);
  EXPECT_NEAR(graded, uniform, 0.02 * uniform);
}

// A notch at half height, from the left into a strip 80 mm wide and 20 mm high.
struct NotchBeforeTheJump {
  KERF_FUNCTION bool operator()(const Vector<2, double>& a, const Vector<2, double>& b) const {
    return a[0] < 30e-3 && b[0] < 30e-3 && (a[1] < 10e-3) != (b[1] < 10e-3);
  }
};
// Returns the largest x of the middle of a broken bond, m.
double crack_tip(SolidOnTrial<2, Mixed>& trial) {
  const auto solid = trial.solid.view();
  const auto& place = trial.layout.reference;
  double tip = 0.0;
  for (Index i = 0; i < place.size(); ++i)
    for (Index k = solid.bonds.first(i); k < solid.bonds.last(i); ++k)
      if (!solid.is_intact(i, k))
        tip = std::max(tip, 0.5 * (place[i][0] + place[solid.bonds.end(i, k)][0]));
  return tip;
}
// The crack runs along a strip under increasing strain when the energy ahead of it is Gc; each
// level has its own band (fracture/crack_band.hpp). Returns the strain of the strip when the
// crack passes x = 35 mm and 55 mm. The jump is at 45 mm.
std::array<double, 2> tears(bool graded) {
  const double fine = 0.5e-3, energy = 1.4;
  auto medium = soft_solid(fine, 2);
  medium.artificial_linear = 0.5;
  auto layout = graded_block<2>({.cells = {80, 20, 1}, .spacing = fine}, medium,
                                [&](const Vector<2, double>& x) { return graded && x[0] > 45e-3; });
  for (auto& level : layout.media)
    level.failure_strain =
        failure_strain_of(energy, medium.bulk_modulus, medium.shear_modulus, level.spacing);
  SolidOnTrial<2, Mixed> trial(layout);
  trial.solid.cut(NotchBeforeTheJump{});
  const double speed = 0.02, dt = 0.2 * fine / medium.bond_wave_speed();
  std::array<double, 2> has_broken_bonds{};
  trial.evaluate();
  for (double t = 0.0; t < 1.0 && has_broken_bonds[1] == 0.0; t += dt) {
    const auto result = pull_once(trial, speed, dt);
    if (result.bonds == 0) continue;
    const double tip = crack_tip(trial);
    for (std::size_t n = 0; n < 2; ++n)
      if (has_broken_bonds[n] == 0.0 && tip > (n == 0 ? 35e-3 : 55e-3))
        has_broken_bonds[n] = 2.0 * speed * t / 16e-3;
  }
  return has_broken_bonds;
}
TEST(GradedStrip, CrackCrossesTheJump) {
  const auto uniform = tears(false), graded = tears(true);
  std::printf("strain when the crack passes 35 and 55 mm: uniform %.4f %.4f, graded %.4f %.4f\n",
              uniform[0], uniform[1], graded[0], graded[1]);
  EXPECT_GT(uniform[1], 0.0);
  // Gc is proportional to the square of the strain: the tolerance is 10% of Gc, as for uniform
  // strips.
  EXPECT_NEAR(graded[0], uniform[0], 0.02 * uniform[0]);
  EXPECT_NEAR(graded[1], uniform[1], 0.05 * uniform[1]);
}

}  // namespace
}  // namespace kerf::test
