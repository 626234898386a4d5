// SPDX-License-Identifier: Apache-2.0
// The pump of a nozzle against Bernoulli's equation, the exact solution of its delay, and exact
// times of flow.
#include "geometry/pump_limit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "geometry/nozzle.hpp"
#include "model/case.hpp"

namespace kerf {
namespace {

constexpr double density = 998.0;

Jet jet_of_pump() {
  Jet jet;
  jet.speed = 7.0;
  jet.width = 4e-3;
  jet.spacing = 0.5e-3;
  jet.stop = std::numeric_limits<double>::infinity();
  jet.feed = Feed::pressure;
  return jet;
}

// Under a constant pressure p + rho V^2 / 2 is the head of the pump once the water has come to its
// steady speed: after n delays the rest is exp(-n V / V_0), and 2 / n of V_0 under the head itself.
TEST(PumpLimit, KeepsTheTotalHead) {
  const double head = 0.5 * density * 49.0;
  for (const double share : {0.0, 1e-4, 0.1, 0.5, 0.9}) {
    PumpLimit pump(head, 1e-3);
    for (int n = 1; n <= 12000; ++n) pump.respond(n * 1e-5, 1e-5, share * head);
    const double speed = 7.0 * pump.speed_share();
    EXPECT_NEAR(share * head + 0.5 * density * speed * speed, head, 1e-12 * head);
    EXPECT_NEAR(pump.pressure(), share * head, 1e-12 * head);
  }
  PumpLimit stopped(head, 1e-3);
  for (int n = 1; n <= 12000; ++n) stopped.respond(n * 1e-5, 1e-5, head);
  EXPECT_NEAR(stopped.speed_share(), 2.0 / 122.0, 1e-3 * 2.0 / 122.0);
}

// Noise leaves the mean total head alone at any speed: the mean pressure and the speed balance
// though each blow is as great as the head.
TEST(PumpLimit, KeepsTheTotalHeadUnderNoise) {
  std::mt19937 engine(4);
  std::normal_distribution<double> noise(0.0, 1.0);
  for (const double share : {0.3, 0.6, 0.9}) {
    PumpLimit pump(1.0, 1e-3);
    double felt = 0.0, dynamic = 0.0;
    const int count = 400000;
    for (int n = 1; n <= count; ++n) {
      const double pressure = share + noise(engine);
      pump.respond(n * 1e-5, 1e-5, pressure);
      felt += pressure / count;
      dynamic += pump.speed_share() * pump.speed_share() / count;
    }
    EXPECT_NEAR(felt + dynamic, 1.0, 0.01) << share;
  }
}

// du/dt = (c^2 - u^2) / (2 T) with c^2 = 1 - P and u = 1 at the start has the solution
// u = c (1 + c t) / (c + t), t = tanh(c t' / 2 T), to first order in the step.
TEST(PumpLimit, FollowsWithItsInertia) {
  for (const double share : {0.3, 0.75}) {
    PumpLimit pump(1e4, 2e-3);
    const double c = std::sqrt(1.0 - share);
    for (int n = 1; n <= 4000; ++n) {
      pump.respond(n * 1e-6, 1e-6, share * 1e4);
      const double t = std::tanh(0.5 * c * n * 1e-6 / 2e-3);
      EXPECT_NEAR(pump.speed_share(), c * (1.0 + c * t) / (c + t), 1e-3);
    }
  }
}

// It neither exceeds the free speed nor flows back, whatever pulls and pushes.
TEST(PumpLimit, StaysBetweenRestAndTheFreeSpeed) {
  std::mt19937 engine(4);
  std::normal_distribution<double> blow(0.0, 30.0);
  PumpLimit pump(1.0, 1e-3);
  double open = 0.0, flow = 0.0;
  for (int n = 0; n < 20000; ++n) {
    const double dt = 1e-5 * (1 + n % 3);
    const double before = pump.flow_time(open), share = pump.speed_share();
    open += dt;
    flow += share * dt;
    EXPECT_NEAR(pump.flow_time(open) - before, share * dt, 1e-12);
    pump.respond(open, dt, blow(engine));
    EXPECT_GE(pump.speed_share(), 0.0);
    EXPECT_LE(pump.speed_share(), 1.0);
    EXPECT_LE(pump.pressure(), 1.0);
  }
  EXPECT_NEAR(pump.flow_time(open), flow, 1e-10 * open);
  PumpLimit drained(1.0, 1e-3);
  for (int n = 1; n < 1000; ++n) drained.respond(n * 1e-5, 1e-5, -0.5);
  EXPECT_EQ(drained.speed_share(), 1.0);
  EXPECT_EQ(drained.flow_time(0.01), 0.01);
}

// Noise of no mean leaves the speed of a free jet alone: with a tenth of the head from step to
// step, and 100 steps per delay, u scatters by 0.05 / sqrt(200), and V falls behind by 0.4 of that
// on average (a half-normal distribution).
TEST(PumpLimit, NoiseHardlySlowsAFreeJet) {
  std::mt19937 engine(4);
  std::normal_distribution<double> noise(0.0, 0.1);
  PumpLimit pump(1.0, 1e-3);
  for (int n = 1; n <= 100000; ++n) pump.respond(n * 1e-5, 1e-5, noise(engine));
  EXPECT_NEAR(pump.flow_time(1.0), 1.0, 2e-3);
}

// The mass that comes in is rho times the integral, over time and section, of the speed that the
// pressure leaves each column, in whole layers a spacing apart, and what was held back makes up the
// rest.
TEST(PumpLimit, TheNozzleEmitsWhatFlows) {
  Jet jet = jet_of_pump();
  jet.profile = "1 - 0.6*r^2";
  jet.start = 2e-4;
  for (const int dimension : {2, 3}) {
    Nozzle nozzle(jet, density, dimension), resumed = nozzle;
    const auto inside = nozzle.standing_water();
    const double area = nozzle_area(jet, dimension), head = 0.5 * density * 49.0;
    const double of_column = area / static_cast<double>(nozzle.columns());
    EXPECT_NEAR(nozzle.column_area(), of_column, 1e-12 * of_column);
    double mass = 0.0, time = 0.0, emitted = 0.0;
    for (int n = 0; n < 5000; ++n) {
      const double dt = 3e-6 * (1 + n % 4);
      resumed = Nozzle(jet, density, dimension);
      resumed.restore(nozzle.emitted());
      resumed.restore_pump(nozzle.pump_state());
      const auto water = nozzle.emit(time), again = resumed.emit(time);
      ASSERT_EQ(water.size(), again.size());
      for (std::size_t k = 0; k < water.size(); ++k)
        EXPECT_EQ(water[k].position, again[k].position);
      emitted += nozzle.particle_mass() * static_cast<double>(water.size());
      const double open = nozzle.open_time(time + dt) - nozzle.open_time(time);
      std::vector<double> pressure;
      for (std::size_t k = 0; k < nozzle.columns(); ++k) {
        ASSERT_EQ(inside[k].column, k);
        mass += density * of_column * inside[k].speed * nozzle.pump(k).speed_share() * open;
        const double phase = 0.2 * static_cast<double>(k);
        pressure.push_back(head * (0.5 - 0.5 * std::cos(time / 1e-3 + phase)));
      }
      time += dt;
      nozzle.respond(time, dt, pressure);
      EXPECT_NEAR(nozzle.mass_due(time), mass, 1e-10 * density * area * 7.0 * time);
    }
    const double layer = nozzle.particle_mass() * static_cast<double>(nozzle.columns());
    EXPECT_NEAR(nozzle.mass_emitted(), emitted, 1e-12 * emitted);
    EXPECT_GE(mass - emitted, -1e-9 * mass);
    EXPECT_LT(mass - emitted, 1.5 * layer);
    const double whole = density * area * 7.0 * nozzle.open_time(time);
    EXPECT_NEAR(nozzle.mass_due(time) + nozzle.mass_held_back(time), whole, 1e-12 * whole);
    EXPECT_LT(mass, 0.9 * whole);
  }
}

// Each column has the head of its own free speed: all of them stand still under that of the
// fastest, and a column without speed stays so.
TEST(PumpLimit, EachColumnHasTheHeadOfItsSpeed) {
  Jet jet = jet_of_pump();
  jet.profile = "max(0, 1 - 1.3*r)";
  Nozzle nozzle(jet, density, 2);
  const auto inside = nozzle.standing_water();
  const std::vector<double> pressure(nozzle.columns(), 2e4);
  const double dt = 1e-6;
  for (int n = 1; n <= 40000; ++n) nozzle.respond(n * dt, dt, pressure);
  for (std::size_t k = 0; k < nozzle.columns(); ++k) {
    const double head = 0.5 * density * inside[k].speed * inside[k].speed;
    const double speed = inside[k].speed * nozzle.pump(k).speed_share();
    EXPECT_NEAR(0.5 * density * speed * speed, std::max(0.0, head - 2e4), 1e-9 * head);
    EXPECT_TRUE(std::isfinite(nozzle.travelled(k, 40000 * dt)));
  }
  EXPECT_EQ(inside.front().speed, 0.0);
}

}  // namespace
}  // namespace kerf
