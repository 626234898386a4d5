// SPDX-License-Identifier: Apache-2.0
// The pace of a pilot run: it is there in time, counts the steps of the estimate as far as it has
// not seen others, and is not taken of a run that was too small.
#include "app/measured_pace.hpp"

#include <gmock/gmock.h>

#include <chrono>

#include "input/read.hpp"
#include "model/case.hpp"

namespace kerf::test::measured_pace_test {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;
using testing::Not;

// A round jet of 30 MPa through a foam, as in the first example of README.md.
Case foam(const std::string& quality, const std::string& machine = "traverse_speed = \"1 m/s\"\n") {
  return parse_case("title = \"foam\"\ndimension = 3\nquality = \"" + quality +
                        "\"\n[machine]\npressure = \"30 MPa\"\norifice_diameter = \"0.15 mm\"\n"
                        "standoff = \"3 mm\"\n" +
                        machine +
                        "[workpiece]\nmaterial = \"polyurethane-foam\"\n"
                        "size = [\"300 mm\", \"5 mm\", \"200 mm\"]\n",
                    "foam.toml", quick_look);
}

double seconds_since(WallClock::time_point start) {
  return std::chrono::duration<double>(WallClock::now() - start).count();
}

// A thread that gets little of a core reaches no limit of its own time.
TEST(MeasuredPace, EndsByTheTimeOfDay) {
  const Case description = foam("draft");
  const DerivedNumbers numbers = derive(description);
  PilotLimits limits;
  const auto start = WallClock::now();
  limits.processor = 1e9;
  limits.until = start + 500ms;
  const Pace pace = measured_pace(description, numbers, 1, limits);
  EXPECT_LT(seconds_since(start), 5.0) << pace.source;
  EXPECT_THAT(pace.source, Not(HasSubstr("over 100%")));
}

// What came before takes away from what may follow, so that both and the pilot run take 5 s.
TEST(MeasuredPace, LeavesAsMuchTimeForTheRestAsWasTakenBefore) {
  const auto now = WallClock::now();
  const auto left = [&](std::chrono::milliseconds before) {
    return std::chrono::duration<double>(limits_of_answer(now - before).until - now).count();
  };
  EXPECT_LT(left(0ms), 4.2);
  EXPECT_GE(limits_of_answer(now - 1000ms).slower, 1.0);
  EXPECT_LT(left(1000ms), left(0ms) - 1.9);
  EXPECT_LT(left(3000ms), 0.0);
}

TEST(MeasuredPace, WithoutTimeIsTheTypicalOneAndSaysSo) {
  const Case description = foam("draft");
  const DerivedNumbers numbers = derive(description);
  PilotLimits limits;
  limits.until = WallClock::now();
  const auto start = WallClock::now();
  const Pace pace = measured_pace(description, numbers, 2, limits),
             typical = typical_pace(description, 2);
  EXPECT_LT(seconds_since(start), 1.0);
  EXPECT_EQ(pace.particle_step, typical.particle_step);
  EXPECT_EQ(run_cost(numbers, pace).steps, run_cost(numbers, typical).steps);
  EXPECT_THAT(pace.source, HasSubstr("too busy"));
}

TEST(MeasuredPace, AFewParticlesOrStepsTellNothing) {
  PilotResult run;
  run.particles = 5.0;
  run.steps = 1e4;
  EXPECT_FALSE(is_telling(run, 1e5));
  EXPECT_TRUE(is_telling(run, 5.0));  // of a case that has no more
  run.particles = 500.0;
  EXPECT_TRUE(is_telling(run, 1e5));
  run.steps = 20.0;
  EXPECT_FALSE(is_telling(run, 1e5));
}

// The whole run: its steps. Nothing of it: no more than half way, as a ratio, from the estimate.
TEST(MeasuredPace, CountsTheStepsThatItHasSeen) {
  PilotResult run;
  run.steps = 400.0;
  run.expected_steps = 100.0;
  run.share = 1.0;
  EXPECT_NEAR(step_factor(run), 4.0, 1e-12);
  run.share = 0.0;
  EXPECT_NEAR(step_factor(run), 2.0, 1e-12);
  run.steps = run.expected_steps;
  run.share = 0.3;
  EXPECT_NEAR(step_factor(run), 1.0, 1e-12);
}

// A path of 150 mm at 1 m/s has 3e7 steps: its pilot has particles enough, and a part of the time.
TEST(MeasuredPace, PilotsOfLongRunsKeepTheirParticles) {
  const Case description = parse_case(
      "title = \"long\"\ndimension = 2\nquality = \"draft\"\n[machine]\npressure = \"30 MPa\"\n"
      "orifice_diameter = \"0.1 mm\"\nstandoff = \"3 mm\"\ntraverse_speed = \"1 m/s\"\n"
      "[workpiece]\nmaterial = \"fat\"\nsize = [\"300 mm\", \"1 mm\"]\nframe = \"travelling\"\n",
      "long.toml", quick_look);
  const DerivedNumbers numbers = derive(description);
  ASSERT_GT(numbers.steps, 1e7);
  EXPECT_GT(derive(pilot_case(description, numbers)).particles_initial, 400u);
  const Pace pace = measured_pace(description, numbers, 1);
  EXPECT_THAT(pace.source, HasSubstr("pilot run"));
  EXPECT_THAT(pace.source, Not(HasSubstr("over 0%")));
}

// The water moves along with its nozzle: its steps shorten with the speed of both.
TEST(MeasuredPace, StepsCountTheSpeedOfTheNozzle) {
  const DerivedNumbers slow = derive(foam("draft", "traverse_speed = \"100 m/s\"\n")),
                       fast = derive(foam("draft", "traverse_speed = \"10 km/s\"\n"));
  // The limit is h / (c + V), with c from 1481 m/s on.
  EXPECT_GT(slow.time_step / fast.time_step, 3.0);
  EXPECT_LT(slow.time_step / fast.time_step, 10e3 / 1481.0 + 1.0);
}

}  // namespace
}  // namespace kerf::test::measured_pace_test
