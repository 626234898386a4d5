// SPDX-License-Identifier: Apache-2.0
// The Riemann solution between particles against formulas computed by hand, and its limits.
#include "fluid/riemann.hpp"

#include <gtest/gtest.h>

#include <random>

#include "support/reference_standard.hpp"

namespace kerf::test::riemann_test {
namespace {

using Side = RiemannSide<double>;

// Density, pressure, speed, sound speed.
Side side_of(double density, double pressure, double speed, double sound_speed) {
  return {density * sound_speed, pressure, speed, sound_speed};
}

TEST(Riemann, AgreesWithTheFormulas) {
  std::mt19937 engine(1);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (int n = 0; n < 1000; ++n) {
    const auto state = [&] {
      return RiemannState{1000.0 + 50.0 * uniform(engine), 1e5 * uniform(engine),
                          20.0 * uniform(engine), 50.0 + 20.0 * uniform(engine)};
    };
    const RiemannState l = state(), r = state();
    const StarState due = reference_star(l, r);
    const auto star = solve_riemann(side_of(l.density, l.pressure, l.speed, l.sound_speed),
                                    side_of(r.density, r.pressure, r.speed, r.sound_speed));
    // The tolerance is the rounding of sums of terms of 1e5 Pa and 20 m/s.
    EXPECT_NEAR(star.mean_pressure, due.mean, 1e-14 * 1e5);
    EXPECT_NEAR(star.dissipation, std::max(due.dissipation, 0.0), 1e-14 * 1e6);
    EXPECT_NEAR(star.speed, due.speed, 1e-14 * 20.0);
    EXPECT_GE(star.dissipation, 0.0);
  }
}

// In strong shocks the weight of the pressure difference is 1 - 20 (U_l - U_r) / c, but at least 0.
TEST(Riemann, LimiterKeepsSharpFronts) {
  const double z = 2.0 * 1000.0 * 50.0;
  const auto speed = [](double approach) {
    const Side left = side_of(1000.0, 3e4, 0.5 * approach, 50.0);
    const Side right = side_of(1000.0, 1e4, -0.5 * approach, 50.0);
    return solve_riemann(left, right, shock_smoothing(left, right)).speed;
  };
  EXPECT_NEAR(speed(1.0), 0.6 * 2e4 / z, 1e-12);
  EXPECT_NEAR(speed(2.5), 0.0, 1e-12);
  EXPECT_NEAR(speed(5.0), 0.0, 1e-12);
  EXPECT_NEAR(speed(-5.0), 2e4 / z, 1e-12);
}

// Two equal particles have the mean pressure and the mean speed of Zhang, Hu & Adams (2017).
TEST(Riemann, EqualImpedancesGiveMeans) {
  const double z = 1000.0 * 50.0;
  const auto star =
      solve_riemann(side_of(1000.0, 3e4, 2.0, 50.0), side_of(1000.0, 1e4, -1.0, 50.0));
  EXPECT_DOUBLE_EQ(star.mean_pressure, 2e4);
  EXPECT_DOUBLE_EQ(star.speed, 0.5 + 0.5 * 2e4 / z);
  EXPECT_DOUBLE_EQ(star.dissipation, 0.5 * (3.0 * 3.0 / 50.0) * z * 3.0);
}

// Between water and a much heavier and stiffer side, a wall, the speed is that of the wall and the
// pressure that of the water.
TEST(Riemann, HeavySideIsAWall) {
  const auto star = solve_riemann(side_of(1000.0, 3e4, 2.0, 50.0), side_of(1e8, 1e4, -1.0, 5e4));
  EXPECT_NEAR(star.mean_pressure, 3e4, 1e-3);
  EXPECT_NEAR(star.speed, -1.0, 1e-6);
}

TEST(Riemann, EqualStatesGiveThatState) {
  const Side side = side_of(1020.0, 3.7e4, -2.3, 50.0);
  const auto star = solve_riemann(side, side);
  EXPECT_DOUBLE_EQ(star.mean_pressure, 3.7e4);
  EXPECT_EQ(star.dissipation, 0.0);
  EXPECT_DOUBLE_EQ(star.speed, -2.3);
}

TEST(Riemann, SeparatingParticlesDissipateNothing) {
  for (double speed : {1e-6, 1.0, 1e3}) {
    const auto star =
        solve_riemann(side_of(1000.0, 1e4, -speed, 50.0), side_of(1000.0, 2e4, speed, 50.0));
    EXPECT_EQ(star.dissipation, 0.0);
    EXPECT_DOUBLE_EQ(star.mean_pressure, 1.5e4);
  }
}

// beta = 3 (U_l - U_r) / c up to U_l - U_r = c / 3, and 1 from there: rho c (U_l - U_r) / 2.
TEST(Riemann, BetaSaturatesAtOne) {
  const double c = 30.0;
  const auto dissipation = [c](double approach) {
    return solve_riemann(side_of(1000.0, 0.0, 0.5 * approach, c),
                         side_of(1000.0, 0.0, -0.5 * approach, c))
        .dissipation;
  };
  EXPECT_NEAR(dissipation(1.0), 0.5 * 0.1 * 1000.0 * c, 1e-9);
  EXPECT_NEAR(dissipation(10.0), 0.5 * 1000.0 * c * 10.0, 1e-8);
  EXPECT_NEAR(dissipation(300.0), 0.5 * 1000.0 * c * 300.0, 1e-7);
  EXPECT_NEAR(dissipation(9.9), 0.99 * 0.5 * 1000.0 * c * 9.9, 1e-8);
}

// A wall mirrors the water: the mean of both speeds is that of the wall. Water at the speed of the
// wall has only its own pressure. The weight of the water is added downwards and never subtracted.
// Density diffusion from the wall is that between two rows of the water.
TEST(Riemann, WallMirrorsTheWater) {
  const Side water = side_of(1010.0, 2e4, 3.0, 50.0);
  const auto star = solve_riemann_at_wall(water, 1.0, 100.0);
  EXPECT_DOUBLE_EQ(star.speed, 1.0 - 0.5 * 100.0 / (1010.0 * 50.0));
  EXPECT_DOUBLE_EQ(solve_riemann_at_wall(water, 1.0, 0.0).speed, 1.0);
  EXPECT_DOUBLE_EQ(star.mean_pressure, 2e4 + 50.0);
  EXPECT_DOUBLE_EQ(star.dissipation, 0.5 * (3.0 * 4.0 / 50.0) * 1010.0 * 50.0 * 4.0);
  EXPECT_DOUBLE_EQ(solve_riemann_at_wall(water, 1.0, -100.0).mean_pressure, 2e4);
  EXPECT_EQ(solve_riemann_at_wall(water, 3.0, 0.0).dissipation, 0.0);
  EXPECT_EQ(solve_riemann_at_wall(water, 5.0, 0.0).dissipation, 0.0);
}

// riemann_parts and solve_riemann are two forms of one solution where the sound speed is constant.
TEST(Riemann, VolumesGiveTheSameAsImpedances) {
  constexpr double mass = 1e-6, sound_speed = 40.0;  // kg, m/s
  std::mt19937 engine(3);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (int n = 0; n < 100; ++n) {
    const double left_volume = 1e-9 * (1.0 + 0.3 * uniform(engine)),
                 right_volume = 1e-9 * (1.0 + 0.3 * uniform(engine)),
                 left_pressure = 1e4 * uniform(engine), right_pressure = 1e4 * uniform(engine),
                 speed = sound_speed * uniform(engine);
    const auto due = solve_riemann<double>(
        {mass / left_volume * sound_speed, left_pressure, 0.0, sound_speed},
        {mass / right_volume * sound_speed, right_pressure, speed, sound_speed});
    const auto is =
        riemann_parts<double>({left_volume, left_pressure}, {right_volume, right_pressure}, speed,
                              {3.0 * mass, mass * sound_speed, 1.0 / (mass * sound_speed)});
    EXPECT_NEAR(is.pressure_force / is.volume, due.mean_pressure, 1e-13 * 1e4);
    EXPECT_NEAR(is.approach * is.dissipative_force / is.volume, due.dissipation,
                1e-13 * std::abs(due.dissipation));
    EXPECT_NEAR(left_volume * is.speed / is.volume, due.speed, 1e-13 * sound_speed);
  }
}

}  // namespace
}  // namespace kerf::test::riemann_test
