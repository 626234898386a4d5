// SPDX-License-Identifier: Apache-2.0
// The flags on a nozzle that is faster than its jet, and on a jet that gravity stretches.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "machine/machine_jet.hpp"
#include "model/case.hpp"
#include "output/falling_jet_flag.hpp"
#include "output/fast_nozzle_flag.hpp"

namespace kerf::test::jet_speed_flags_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

// A jet of 1 m/s straight down, 10 mm wide, from 10 mm above the origin to the end of the domain
// 50 mm below its exit.
Case falling_case() {
  Case description;
  description.dimension = 2;
  description.formulation = Formulation::standard;
  description.domain = {{-0.1, -0.04, 0.0}, {0.1, 0.1, 0.0}};
  Jet& jet = description.jets.emplace_back();
  jet.name = "water";
  jet.speed = 1.0;
  jet.width = 10e-3;
  jet.standoff = 10e-3;
  return description;
}

TEST(FastNozzle, TellsBothSpeedsOfAJet) {
  Case description = falling_case();
  EXPECT_FALSE(fast_nozzle_flag(description));
  description.jets.front().traverse = {0.99, 0.0, 0.0};
  EXPECT_FALSE(fast_nozzle_flag(description));
  description.jets.front().traverse = {-1.01, 0.0, 0.0};
  ASSERT_TRUE(fast_nozzle_flag(description));
  EXPECT_THAT(fast_nozzle(description).value_or(""),
              AllOf(HasSubstr("jet[1].traverse: the nozzle travels at 1.01 m/s"),
                    HasSubstr("jet[1].speed = 1 m/s")));
}

TEST(FastNozzle, TellsThatMilliIsNotMega) {
  Case description = falling_case();
  description.jets.front().name = machine_jet_name;
  Machine& machine = description.machine.emplace();
  machine.pressure = 30e-3;
  machine.traverse_speed = 2.0;
  EXPECT_THAT(fast_nozzle(description).value_or(""),
              AllOf(HasSubstr("machine.traverse_speed = 2 m/s"),
                    HasSubstr("machine.pressure is 1 m/s"), HasSubstr("mPa is millipascal")));
  machine.pressure = 30e6;
  EXPECT_THAT(fast_nozzle(description).value_or(""),
              AllOf(HasSubstr("machine.traverse_speed"), Not(HasSubstr("millipascal"))));
  machine.traverse_speed = 0.5;
  EXPECT_FALSE(fast_nozzle(description));
}

// Torricelli: a narrowing of `share` over the way h has V0 / V = 1 - share, V^2 = V0^2 + 2 g h.
TEST(FallingJet, WarnsOfMoreThanTwoPerCent) {
  const double way = 50e-3;
  for (const double share : {0.019, 0.021, 0.4}) {
    Case description = falling_case();
    const double gravity = (std::pow(1.0 - share, -2.0) - 1.0) / (2.0 * way);
    description.gravity = {0.0, -gravity, 0.0};
    EXPECT_NEAR(narrowing_by_gravity(description, description.jets.front()), share, 1e-9);
    EXPECT_EQ(falling_jet_flag(description).has_value(), share > 0.02) << share;
    description.gravity = {gravity, 0.0, 0.0};  // across the jet
    EXPECT_NEAR(narrowing_by_gravity(description, description.jets.front()), 0.0, 1e-9);
    description.gravity = {0.0, gravity, 0.0};  // against it
    EXPECT_EQ(narrowing_by_gravity(description, description.jets.front()), 0.0);
  }
}

TEST(FallingJet, EndsAtTheFirstBodyInItsWay) {
  Case description = falling_case();
  description.gravity = {0.0, -9.81, 0.0};
  const auto fall = [](double way) { return 1.0 - 1.0 / std::sqrt(1.0 + 2.0 * 9.81 * way); };
  EXPECT_NEAR(narrowing_by_gravity(description, description.jets.front()), fall(50e-3), 1e-9);
  Body& plate = description.bodies.emplace_back();
  plate.role = Role::rigid;
  plate.spacing = 1e-3;
  plate.shape.kind = Shape::Kind::box;
  plate.shape.box = {{-50e-3, -20e-3, 0.0}, {50e-3, 8e-3, 0.0}};
  EXPECT_NEAR(narrowing_by_gravity(description, description.jets.front()), fall(2e-3), 1e-6);
  EXPECT_FALSE(falling_jet_flag(description));  // 1.9%
}

}  // namespace
}  // namespace kerf::test::jet_speed_flags_test
