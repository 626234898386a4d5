// SPDX-License-Identifier: Apache-2.0
// Runs in which solid at rest sleeps (standard/sleep.hpp), against the same runs in which all of it
// is computed. Without a jet they are the same to the last bit.
#include <algorithm>
#include <cmath>
#include <ostream>

#include "engine/device.hpp"
#include "support/farthest.hpp"
#include "support/small_cases.hpp"

namespace kerf::test {
namespace {

// Returns how many particles sleep.
std::ptrdiff_t asleep(const Simulation& simulation) {
  const Archive archive = saved(simulation);
  const auto field = archive.arrays.find("particles/asleep");
  if (field == archive.arrays.end()) return 0;
  const auto& flags = std::get<std::vector<std::uint8_t>>(field->second);
  return std::count(flags.begin(), flags.end(), std::uint8_t(1));
}

std::unique_ptr<Simulation> with_sleep(Case c, bool sleep) {
  c.numerics.sleep = sleep;
  return make_simulation(c);
}

double apart(const Simulation& a, const Simulation& b) {
  return std::max(farthest(
                      a.frame(), b.frame(), [](const Frame& f) -> auto& { return f.position; }),
                  farthest(
                      a.frame(), b.frame(), [](const Frame& f) -> auto& { return f.velocity; }));
}

// A bar at rest and a striker that hits its end; where the bar may break, that breaks it.
Case struck_bar(int dimension, PrecisionKind precision, double failure_strain) {
  Case c = empty_case(dimension, precision);
  c.formulation = Formulation::standard;
  c.smoothing_ratio = 1.3;
  c.materials[0].failure_strain = failure_strain;
  c.materials[0].artificial_linear = c.materials[0].artificial_quadratic = 0.5;
  const double z = dimension == 3 ? 2e-3 : 0.0;
  c.bodies = {body("bar", Role::elastic, box({0.0, -2e-3, -z}, {0.04, 2e-3, z}), 1e-3),
              body("striker", Role::elastic, box({-6e-3, -2e-3, -z}, {-1e-3, 2e-3, z}), 1e-3)};
  c.bodies[1].velocity = {"2", "0.1", "0"};
  return c;
}

struct BarCase {
  int dimension;
  bool mirrored;
  bool nearly_incompressible;
  double failure_strain;

  friend std::ostream& operator<<(std::ostream& out, const BarCase& of) {
    return out << of.dimension << "D" << (of.mirrored ? ", mirrored" : "")
               << (of.nearly_incompressible ? ", nearly incompressible" : "") << ", failure strain "
               << of.failure_strain;
  }
};

class StruckBar : public testing::TestWithParam<BarCase> {};

TEST_P(StruckBar, MovesToTheLastBitAsIfNoneHadSlept) {
  const auto [dimension, mirrored, nearly_incompressible, failure_strain] = GetParam();
  Case c = struck_bar(dimension, PrecisionKind::mixed, failure_strain);
  if (nearly_incompressible) c.materials[0].poisson_ratio = 0.49;
  if (mirrored) {
    c.bodies[1].velocity = {"2", "0", "0"};
    c.domain.minimum[1] = 0.0;
    c.symmetry.minimum[1] = true;
  }
  const auto all = with_sleep(c, false), some = with_sleep(c, true);
  take_steps(*some, 2);
  take_steps(*all, 2);
  const auto at_first = asleep(*some);
  EXPECT_GT(at_first, static_cast<std::ptrdiff_t>(some->particles() / 2));
  EXPECT_EQ(asleep(*all), 0);
  int partly = 0;  // how often a part of what slept at first has woken
  for (int n = 0; n < 100; ++n) {
    take_steps(*some, 2);
    take_steps(*all, 2);
    partly += asleep(*some) > 0 && asleep(*some) < at_first ? 1 : 0;
    ASSERT_EQ(apart(*some, *all), 0.0) << n;
    ASSERT_EQ(some->balance().energy_total(), all->balance().energy_total()) << n;
  }
  EXPECT_GE(partly, 3);
}

INSTANTIATE_TEST_SUITE_P(Bars, StruckBar,
                         testing::Values(BarCase{2, false, false, 0.0},
                                         BarCase{2, false, false, 0.02},
                                         BarCase{2, true, false, 0.0}, BarCase{2, false, true, 0.0},
                                         BarCase{3, false, false, 0.0},
                                         BarCase{3, true, true, 0.0}));

// With a jet the two runs differ by the order of the waking speed, 2^-24 of that of the jet.
TEST(Sleep, AJetMovesABlockAsIfNoneHadSlept) {
  for (const int dimension : {2, 3}) {
    Case c = standard_jet_on_block(dimension, PrecisionKind::double_precision);
    c.materials[0].failure_strain = 0.0;
    c.gravity = {0.0, 0.0, 0.0};
    const auto all = with_sleep(c, false), some = with_sleep(c, true);
    take_steps(*some, 2);
    EXPECT_GT(asleep(*some), 0);
    const auto flying = asleep(*some);
    const double end = 1e-3;  // 0.4 ms of flight
    while (some->time() < end) some->advance();
    while (all->time() < end) all->advance();
    EXPECT_LT(asleep(*some), flying);
    EXPECT_LE(apart(*some, *all), 10.0 * std::ldexp(5.0, -24)) << dimension;  // m/s
    EXPECT_NEAR(some->balance().impulse_water[1], all->balance().impulse_water[1],
                1e-6 * std::abs(all->balance().impulse_water[1]));
    EXPECT_LE(std::abs(some->balance().energy_drift()), 2e-3);
  }
}

// A body beside a bar, whose prescribed motion begins after the bar has fallen asleep.
class LateDriver : public testing::TestWithParam<Role> {};

TEST_P(LateDriver, MovesABarAsIfItHadNotSlept) {
  for (const double speed : {0.1, 5.0}) {
    Case c = struck_bar(2, PrecisionKind::mixed, 0.0);
    c.bodies[1] = body("driver", GetParam(), box({-6e-3, -2e-3, 0.0}, {0.0, 2e-3, 0.0}), 1e-3);
    c.bodies[1].displacement = {std::to_string(speed) + "*max(t - 2e-4, 0)", "0", "0"};
    const auto all = with_sleep(c, false), some = with_sleep(c, true);
    take_steps(*some, 2);
    EXPECT_GT(asleep(*some), 0);
    while (all->time() < 4e-4) all->advance();
    while (some->time() < 4e-4) some->advance();
    EXPECT_GT(all->balance().kinetic, 0.0);
    ASSERT_EQ(apart(*some, *all), 0.0) << speed;
    EXPECT_EQ(some->balance().energy_total(), all->balance().energy_total()) << speed;
  }
}

INSTANTIATE_TEST_SUITE_P(Drivers, LateDriver, testing::Values(Role::rigid, Role::elastic),
                         [](const auto& of) {
                           return std::string(of.param == Role::rigid ? "Rigid" : "Elastic");
                         });

TEST(Sleep, SolidUnderGravityDoesNotSleep) {
  Case c = struck_bar(2, PrecisionKind::mixed, 0.0);
  c.gravity = {0.0, -9.81, 0.0};
  const auto falling = with_sleep(c, true);
  take_steps(*falling, 80);
  EXPECT_EQ(asleep(*falling), 0);
}

// Those that sleep at a restart sleep on.
TEST(Sleep, ARestartContinuesBitForBit) {
  const Case c = struck_bar(2, PrecisionKind::mixed, 0.02);
  const auto through = with_sleep(c, true), first = with_sleep(c, true);
  take_steps(*first, 21);
  const auto resumed = with_sleep(c, true);
  resumed->restore(saved(*first));
  EXPECT_GT(asleep(*resumed), 0);
  EXPECT_EQ(asleep(*resumed), asleep(*first));
  take_steps(*resumed, 100);
  take_steps(*through, 121);
  EXPECT_EQ(asleep(*resumed), asleep(*through));
  EXPECT_EQ(apart(*resumed, *through), 0.0);
}

}  // namespace
}  // namespace kerf::test
