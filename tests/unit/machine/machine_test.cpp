// SPDX-License-Identifier: Apache-2.0
// The jet of a machine against tables and closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "analysis/jet_axis.hpp"
#include "input/material_library.hpp"
#include "machine/characteristic_speed.hpp"
#include "machine/contraction.hpp"
#include "machine/jet_breakup.hpp"
#include "machine/jet_speed.hpp"
#include "machine/machine_jet.hpp"
#include "model/case.hpp"

namespace kerf {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

Machine plain_machine() {
  Machine machine;
  machine.pressure = 3e6;
  machine.orifice_diameter = 0.12e-3;
  machine.velocity_coefficient = 0.98;
  machine.discharge_coefficient = 0.98 * standard_contraction(machine);
  machine.coherent_length = 1.0;
  machine.standoff = 10e-3;
  machine.spacing = 1e-5;
  return machine;
}
Material water() {
  Material material;
  material.density = 1000.0;
  return material;
}

// Speeds of water of 1000 kg/m^3 with the compression of Hashish (1989), by numerical integration
// of dP / rho in the source of this table.
TEST(Machine, PressureGivesTheSpeedsOfTheTable) {
  const double table[][2] = {{1.25e6, 50}, {3e6, 77},    {10e6, 141},  {30e6, 244},  {70e6, 371},
                             {100e6, 443}, {200e6, 621}, {300e6, 755}, {400e6, 866}, {600e6, 1048}};
  for (const auto& [pressure, speed] : table)
    EXPECT_NEAR(jet_speed(pressure, 1000.0), speed, std::max(0.005 * speed, 0.5)) << pressure;
}

TEST(Machine, SpeedIsBernoullisIntegral) {
  for (const double pressure : {1e5, 3e6, 50e6, 400e6}) {
    const int steps = 20'000;
    double sum = 0.0;
    for (int i = 0; i < steps; ++i) {
      const double p = pressure * (i + 0.5) / steps;
      sum += pressure / steps /
             (998.0 * std::pow(1.0 + p / compression_pressure, compression_exponent));
    }
    EXPECT_NEAR(jet_speed(pressure, 998.0), std::sqrt(2.0 * sum), 1e-7 * std::sqrt(2.0 * sum));
    EXPECT_NEAR(pump_pressure(jet_speed(pressure, 998.0), 998.0), pressure, 1e-9 * pressure);
  }
  EXPECT_NEAR(jet_speed(1.0, 1000.0), std::sqrt(2e-3), 1e-9);  // without compression
}

TEST(Machine, CompressionAgreesWithTheSoundSpeed) {
  EXPECT_NEAR(std::sqrt(compression_pressure / (compression_exponent * 998.2)),
              real_water_sound_speed, 0.002 * real_water_sound_speed);
}

// The contraction of Kirchhoff's slit, Borda's mouthpiece and the table of von Mises (1917) between
// them.
TEST(Machine, ContractionOfAFunnel) {
  EXPECT_NEAR(contraction(90 * degree), std::numbers::pi / (std::numbers::pi + 2.0), 1e-12);
  EXPECT_NEAR(contraction(180 * degree), 0.5, 1e-12);
  EXPECT_NEAR(contraction(45 * degree), 0.746, 0.001);
  EXPECT_NEAR(contraction(135 * degree), 0.537, 0.001);
  EXPECT_NEAR(contraction(0.01 * degree), 1.0, 1e-3);
}

// von Mises's table of slits in the end of a channel, whose widths are in the ratio given.
TEST(Contraction, IsLessInANarrowVessel) {
  EXPECT_NEAR(contraction(90 * degree, 0.1), 0.612, 0.0005);
  EXPECT_NEAR(contraction(90 * degree, 0.3), 0.622, 0.0005);
  EXPECT_NEAR(contraction(90 * degree, 0.5), 0.644, 0.0005);
  EXPECT_NEAR(contraction(45 * degree, 1e-4), contraction(45 * degree), 1e-9);
  EXPECT_NEAR(contraction(90 * degree, 0.999), 1.0, 0.05);
}

// Beside a long mouthpiece water is at rest under the full pressure V^2 / 2 (density 1). The
// momentum along a channel of width 1, with U = s C_c V, is then
//   (V^2 - U^2) / 2 - (1 - s) V^2 / 2 = s C_c V^2 - U^2,   or   s C_c^2 - 2 C_c + 1 = 0.
TEST(Contraction, OfBordasMouthpieceInAChannelObeysMomentum) {
  for (const double s : {0.2, 0.5}) {
    const double expected = (1.0 - std::sqrt(1.0 - s)) / s;
    EXPECT_NEAR(contraction(180 * degree, s), expected, 1e-6);
  }
}

TEST(Machine, FlowRatePowerAndSizeOfAJet) {
  Machine machine = plain_machine();
  const auto numbers = machine_numbers(machine, water(), 3);
  const double ideal = jet_speed(3e6, 1000.0);
  const double hole = std::numbers::pi / 4.0 * 0.12e-3 * 0.12e-3;
  EXPECT_NEAR(numbers.speed, 0.98 * ideal, 1e-9);
  EXPECT_NEAR(numbers.flow_rate, machine.discharge_coefficient * hole * ideal, 1e-18);
  EXPECT_NEAR(numbers.power, 0.5 * 1000.0 * numbers.flow_rate * numbers.speed * numbers.speed,
              1e-9 * numbers.power);
  EXPECT_NEAR(numbers.stagnation_pressure, 0.98 * 0.98 * 3e6, 0.001 * 3e6);
  const double slope = 1.975;  // of water: the default of materials.hugoniot_slope
  EXPECT_NEAR(numbers.hammer_pressure, 1000.0 * (1481.0 + slope * numbers.speed) * numbers.speed,
              1.0);
  const Jet jet = machine_jet(machine, water(), 3);
  EXPECT_NEAR(jet.width, 0.12e-3 * std::sqrt(0.611), 0.0005 * jet.width);
  EXPECT_EQ(jet.duty, 1.0);
  EXPECT_LE(jet.standoff, 2.0 * jet.width);
}

// Mass flow and momentum flux at the workpiece equal those at the orifice at any standoff, of round
// jets and of those of a 2D case.
TEST(Machine, StandoffKeepsMassAndMomentum) {
  for (const int dimension : {2, 3})
    for (const double standoff : {1e-3, 10e-3, 40e-3}) {
      Machine machine = plain_machine();
      machine.coherent_length = 5e-3;
      machine.standoff = standoff;
      const auto numbers = machine_numbers(machine, water(), dimension);
      const Jet jet = machine_jet(machine, water(), dimension);
      EXPECT_NEAR(nozzle_area(jet, dimension) * jet.speed * jet.duty, numbers.flow_rate,
                  1e-9 * numbers.flow_rate);
      EXPECT_EQ(jet.pulse_frequency > 0.0, standoff > 5e-3);
    }
  // Rajaratnam & Albers (1998): 2% after 200 diameters.
  EXPECT_NEAR(jet_after({1.0, 100.0}, 200.0, coherent_diameters).water_share, 0.02, 1e-12);
}

TEST(Machine, FansKeepTheirFlowRate) {
  Machine machine = plain_machine();
  machine.orifice_type = OrificeType::fan;
  machine.orifice_length = 1e-3;
  machine.fan_angle = 30 * degree;
  machine.standoff = 20e-3;
  const auto numbers = machine_numbers(machine, water(), 3);
  const Jet jet = machine_jet(machine, water(), 3);
  EXPECT_NEAR(jet.length, 1e-3 + 2.0 * 20e-3 * std::tan(15 * degree), 1e-15);
  EXPECT_NEAR(nozzle_area(jet, 3) * jet.speed, numbers.flow_rate, 1e-9 * numbers.flow_rate);
}

// The lower edge of a jet meets the face before its axis does: it starts above the face at any
// angle that machines may have, as far as the standoff allows. Upright jets keep their two
// diameters.
TEST(Machine, GrazingJetsStartAboveTheFace) {
  for (const int dimension : {2, 3})
    for (const double lead : {0.0, 60.0, 78.0, 80.0}) {
      Machine machine = plain_machine();
      machine.standoff = 0.1;
      machine.lead_angle = lead * degree;
      if (dimension == 3) machine.tilt_angle = lead * degree;
      const Jet jet = machine_jet(machine, water(), dimension);
      const double lowest =
          jet.standoff * std::cos(jet.angle) - 0.5 * jet.width * std::sin(jet.angle);
      EXPECT_GT(lowest, 0.99 * jet.width * std::cos(jet.angle)) << lead;
      if (lead == 0.0) {
        EXPECT_NEAR(jet.standoff, 2.0 * jet.width, 1e-12);
      }
      machine.standoff = jet.width;
      EXPECT_LE(machine_jet(machine, water(), dimension).standoff, machine.standoff);
    }
}

TEST(Machine, LeadAngleHasEitherSignIn2D) {
  for (const double lead : {20.0, -20.0})
    for (const double forward : {1.0, -1.0}) {
      Machine machine = plain_machine();
      machine.lead_angle = lead * degree;
      machine.traverse_direction = {forward, 0.0, 0.0};
      const JetAxis axis(machine_jet(machine, water(), 2), 2);
      EXPECT_NEAR(axis.along[0], forward * std::sin(lead * degree), 1e-12);
      EXPECT_NEAR(axis.along[1], -std::cos(lead * degree), 1e-12);
    }
}

// The angles are those between the vertical and the projections of the jet.
TEST(Machine, LeadAndTiltArePositiveAlongAndRightOfTheTraverse) {
  Machine machine = plain_machine();
  machine.lead_angle = 20 * degree;
  machine.tilt_angle = 10 * degree;
  for (const double turn : {0.0, 35.0, 90.0, 200.0}) {
    machine.traverse_direction = {std::cos(turn * degree), 0.0, std::sin(turn * degree)};
    const JetAxis axis(machine_jet(machine, water(), 3), 3);
    const Point& forward = machine.traverse_direction;
    const Point right{-forward[2], 0.0, forward[0]};  // forward x up
    const auto along = [&](const Point& p) {
      return axis.along[0] * p[0] + axis.along[1] * p[1] + axis.along[2] * p[2];
    };
    EXPECT_NEAR(std::atan2(along(forward), -axis.along[1]), 20 * degree, 1e-12);
    EXPECT_NEAR(std::atan2(along(right), -axis.along[1]), 10 * degree, 1e-12);
  }
}

TEST(Machine, OrificeIsASlitIn2D) {
  const Machine machine = plain_machine();
  const auto numbers = machine_numbers(machine, water(), 2);
  EXPECT_NEAR(numbers.diameter, 0.12e-3 * 0.611, 0.0005 * numbers.diameter);
  EXPECT_NEAR(numbers.flow_rate, numbers.diameter * numbers.speed, 1e-15);
}

}  // namespace
}  // namespace kerf
