// SPDX-License-Identifier: Apache-2.0
// The water that a run holds at one time: what its jets emit, and no more than the domain holds.
#include "machine/jet_water.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "geometry/nozzle.hpp"
#include "model/case.hpp"

namespace kerf {
namespace jet_water {

// A jet of 10 m/s and 4 mm over a plate, in a domain of 0.1 m x 0.1 m.
Case over_a_plate(double end) {
  Case description;
  description.dimension = 2;
  description.domain = {{-0.05, -0.05, 0.0}, {0.05, 0.05, 0.0}};
  description.time.end = end;
  Jet jet;
  jet.speed = 10.0;
  jet.width = 4e-3;
  jet.spacing = 1e-3;
  jet.stop = 1e300;
  description.jets.push_back(jet);
  Body plate;
  plate.role = Role::rigid;
  plate.spacing = 1e-3;
  plate.shape.kind = Shape::Kind::box;
  plate.shape.box = {{-0.02, -0.004, 0.0}, {0.02, 0.0, 0.0}};
  description.bodies.push_back(plate);
  return description;
}

double most_until(const Case& description) {
  return most_jet_water(description, description.jets.front(), description.time.end);
}

constexpr double rate = 10.0 * 4e-3 / 1e-6;  // particles per second

TEST(JetWater, ShortRunsHoldWhatTheirJetsEmit) {
  EXPECT_NEAR(most_until(over_a_plate(0.01)), rate * 0.01, 1e-9);
}

// Ten flights through the diagonal of the domain, and the box of the plate.
TEST(JetWater, LongRunsHoldWhatIsOnItsWay) {
  const double passing = rate * 10.0 * 0.1 * std::sqrt(2.0) / 10.0;
  const double held = 1.1 * 40.0 * 4.0;
  for (const double end : {1.0, 10.0, 1e6})
    EXPECT_NEAR(most_until(over_a_plate(end)), passing + held, 1e-6);
}

// Where water may stay, because it falls or planes confine it, as much as fills the domain.
TEST(JetWater, NoneHoldMoreThanFillsTheDomain) {
  const double full = 1.1 * 100.0 * 100.0;
  Case falling = over_a_plate(10.0), channel = over_a_plate(10.0);
  falling.gravity[1] = -9.81;
  channel.symmetry.minimum[0] = channel.symmetry.maximum[0] = true;
  EXPECT_NEAR(most_until(falling), full, 1e-6);
  EXPECT_NEAR(most_until(channel), full, 1e-6);
  Case narrow = over_a_plate(10.0);
  narrow.domain = {{-0.02, -0.004, 0.0}, {0.02, 0.004, 0.0}};
  EXPECT_NEAR(most_until(narrow), 1.1 * 40.0 * 8.0, 1e-6);
}

// A jet that flows for a while emits no more than that, and in slugs as much as their share.
TEST(JetWater, PausesCount) {
  Case description = over_a_plate(10.0);
  description.jets.front().stop = 0.02;
  EXPECT_NEAR(most_until(description), rate * 0.02, 1e-9);
  description = over_a_plate(0.1);
  description.jets.front().duty = 0.5;
  description.jets.front().pulse_frequency = 50.0;
  EXPECT_NEAR(most_until(description), 0.5 * rate * 0.1, 1e-9);
}

// The speed on the axis of a parabola over a slot is 3/2 of the mean; particles are beside the
// axis.
TEST(JetWater, FastestWaterIsOnTheAxis) {
  Jet jet = over_a_plate(1.0).jets.front();
  EXPECT_EQ(fastest_water(jet, 2), jet.speed);
  jet.profile = "1 - r^2";
  jet.spacing = jet.width / 40.0;
  EXPECT_NEAR(fastest_water(jet, 2), 1.5 * jet.speed, 0.002 * jet.speed);
  EXPECT_NEAR(fastest_water(jet, 3), 2.0 * jet.speed, 0.01 * jet.speed);
}

}  // namespace jet_water
}  // namespace kerf
