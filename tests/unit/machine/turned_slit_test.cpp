// SPDX-License-Identifier: Apache-2.0
// The sheet of a slit or a fan turns with the traverse of its machine: its long side is at right
// angles to the traverse and to the jet, whatever the angles of the jet are.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "geometry/jet_direction.hpp"
#include "geometry/nozzle.hpp"
#include "geometry/point_vectors.hpp"
#include "input/read.hpp"
#include "machine/machine_jet.hpp"
#include "machine/simulated_piece.hpp"
#include "model/case.hpp"
#include "output/piece_reasons.hpp"

namespace kerf {
namespace turned_slit {

constexpr double degree = std::numbers::pi / 180.0;

struct Angles {
  double lead, tilt;  // degrees
};
const Angles several_angles[] = {{0.0, 0.0},  {0.0, 0.001}, {0.001, 0.0}, {20.0, 0.0},
                                 {0.0, 20.0}, {0.0, -20.0}, {15.0, 25.0}, {-40.0, 60.0}};
const double several_turns[] = {0.0, 45.0, 90.0, 200.0};

Machine slit(double turn, const Angles& angles) {
  Machine machine;
  machine.orifice_type = OrificeType::slit;
  machine.pressure = 1e6;
  machine.orifice_diameter = 1e-3;
  machine.orifice_length = 4e-3;
  machine.velocity_coefficient = 0.98;
  machine.discharge_coefficient = 0.6;
  machine.coherent_length = 1.0;
  machine.standoff = 0.1;
  machine.spacing = 0.1e-3;
  machine.traverse_speed = 1.0;
  machine.traverse_direction = {std::cos(turn * degree), 0.0, std::sin(turn * degree)};
  machine.lead_angle = angles.lead * degree;
  machine.tilt_angle = angles.tilt * degree;
  return machine;
}

Jet jet_of(const Machine& machine) {
  Material water;
  water.density = 1000.0;
  return machine_jet(machine, water, 3);
}

std::vector<InletParticle> water_of(const Machine& machine) {
  return Nozzle(jet_of(machine), 1000.0, 3).standing_water();
}

// Returns a point turned about the vertical by an angle, degrees, from x towards z.
Point turned(const Point& x, double turn) {
  const double c = std::cos(turn * degree), s = std::sin(turn * degree);
  return {c * x[0] - s * x[2], x[1], s * x[0] + c * x[2]};
}

TEST(TurnedSlit, LongSideIsAtRightAnglesToTheTraverseAndTheJet) {
  for (const Angles& angles : several_angles)
    for (const double turn : several_turns) {
      const Machine machine = slit(turn, angles);
      const JetAxes axes = axes_of(jet_of(machine));
      EXPECT_NEAR(dot(axes.sideways, machine.traverse_direction), 0.0, 1e-12);
      EXPECT_NEAR(dot(axes.sideways, axes.along), 0.0, 1e-12);
      EXPECT_NEAR(dot(axes.sideways, axes.sideways), 1.0, 1e-12);
      EXPECT_NEAR(dot(axes.across, axes.across), 1.0, 1e-12);
      EXPECT_NEAR(dot(axes.across, axes.along), 0.0, 1e-12);
      EXPECT_NEAR(dot(cross(axes.along, axes.across), axes.sideways), 1.0, 1e-12);
    }
}

// Returns the largest distance along an axis between water and its counterpart, turned first, m.
double largest_distance(const std::vector<InletParticle>& one,
                        const std::vector<InletParticle>& other, double turn) {
  if (one.size() != other.size()) return 1.0;
  double largest = 0.0;
  for (std::size_t i = 0; i < one.size(); ++i) {
    const Point apart = sum(turned(one[i].position, turn), -1.0, other[i].position);
    for (const double component : apart) largest = std::max(largest, std::abs(component));
  }
  return largest;
}

TEST(TurnedSlit, WaterAndExposureTurnWithTheTraverse) {
  for (const Angles& angles : several_angles) {
    const Machine straight = slit(0.0, angles);
    const auto first = water_of(straight);
    const double exposure = exposure_time(straight, jet_of(straight), 3);
    for (const double turn : several_turns) {
      const Machine machine = slit(turn, angles);
      EXPECT_LT(largest_distance(first, water_of(machine), turn), 1e-14) << turn;
      EXPECT_NEAR(exposure_time(machine, jet_of(machine), 3), exposure, 1e-12 * exposure);
    }
  }
}

// An angle of a hundred-thousandth moves no particle by more than that of its distance.
TEST(TurnedSlit, TinyAnglesMoveTheWaterByLittle) {
  for (const double turn : several_turns)
    for (const Angles& angles : {Angles{0.0, 0.001}, Angles{0.001, 0.0}, Angles{-0.001, 0.001}})
      EXPECT_LT(
          largest_distance(water_of(slit(turn, {0.0, 0.0})), water_of(slit(turn, angles)), 0.0),
          2.5e-5 * 5e-3);
}

// The section of a jet that leans by an angle ahead is longer by 1 / cos; a tilt does not matter.
TEST(TurnedSlit, ExposureIsThatOfTheWidth) {
  for (const double turn : several_turns) {
    const auto exposure = [&](const Angles& angles) {
      const Machine machine = slit(turn, angles);
      return exposure_time(machine, jet_of(machine), 3);
    };
    const double width = 0.6 / 0.98 * 1e-3;
    EXPECT_NEAR(exposure({0.0, 0.0}), width, 1e-12);
    EXPECT_NEAR(exposure({0.0, 30.0}), width, 1e-12);
    EXPECT_NEAR(exposure({0.0, 0.001}), width, 1e-12);
    EXPECT_NEAR(exposure({30.0, 0.0}), width / std::cos(30.0 * degree), 1e-12);
  }
}

// A round jet acts on every point of a path for the same time, wherever that leads.
TEST(TurnedSlit, ExposureOfARoundJetTurns) {
  for (const double turn : several_turns) {
    Machine machine = slit(turn, {0.0, 20.0});
    machine.orifice_type = OrificeType::sharp;
    const Jet jet = jet_of(machine);
    EXPECT_NEAR(exposure_time(machine, jet, 3), jet.width, 1e-12);
  }
}

// The lower end of a long sheet that is tilted does not leave its nozzle inside the workpiece.
TEST(TurnedSlit, TiltedSheetBeginsAboveTheWorkpiece) {
  Machine machine = slit(45.0, {0.0, 40.0});
  machine.orifice_length = 20e-3;
  for (const InletParticle& particle : water_of(machine)) EXPECT_GT(particle.position[1], 0.0);
}

Case piece_under(const std::string& machine) {
  return parse_case(
      "title = \"slit\"\ndimension = 3\nquality = \"draft\"\n[machine]\npressure = \"1 MPa\"\n"
      "orifice_type = \"slit\"\norifice_diameter = \"1 mm\"\norifice_length = \"4 mm\"\n"
      "standoff = \"3 mm\"\ntraverse_speed = \"1 m/s\"\n" +
          machine + "[workpiece]\nmaterial = \"fat\"\nsize = [\"40 mm\", \"1 mm\", \"40 mm\"]\n",
      "my.toml");
}

TEST(TurnedSlit, PartTurnsWithTheTraverse) {
  for (const char* angle : {"", "tilt_angle = \"0.001 deg\"\n", "lead_angle = \"20 deg\"\n"}) {
    const Case one = piece_under(std::string("traverse_direction = [1, 0, 0]\n") + angle);
    const Case other = piece_under(std::string("traverse_direction = [0, 0, 1]\n") + angle);
    const auto side = [](const Box& box, std::size_t a) { return box.maximum[a] - box.minimum[a]; };
    const Box &part = one.workpiece->part, &turned_part = other.workpiece->part;
    for (const std::size_t a : {std::size_t{0}, std::size_t{2}}) {
      EXPECT_NEAR(side(part, a), side(turned_part, 2 - a), 1e-12) << angle;
      EXPECT_NEAR(side(one.domain, a), side(other.domain, 2 - a), 1e-12) << angle;
      EXPECT_EQ(one.symmetry.minimum[a], other.symmetry.minimum[2 - a]) << angle;
    }
    EXPECT_LT(side(part, 0), side(part, 2));
    EXPECT_NEAR(one.time.end, other.time.end, 1e-9 * one.time.end);
    EXPECT_EQ(piece_reasons(one).back(), piece_reasons(other).back());
  }
}

// The part of a jet that leans by next to nothing has at most another coarsest cell at each end.
TEST(TurnedSlit, TinyAnglesKeepThePart) {
  const Case upright = piece_under("");
  const double cell = std::ldexp(upright.workpiece->spacing, upright.workpiece->levels);
  for (const char* angle : {"tilt_angle = \"0.001 deg\"\n", "lead_angle = \"0.001 deg\"\n"}) {
    const Case leaning = piece_under(angle);
    for (const std::size_t a : {std::size_t{0}, std::size_t{2}})
      EXPECT_NEAR(leaning.workpiece->part.maximum[a], upright.workpiece->part.maximum[a],
                  1.001 * cell);
    EXPECT_NEAR(leaning.time.end, upright.time.end, 1e-5 * upright.time.end);
  }
}

}  // namespace turned_slit
}  // namespace kerf
