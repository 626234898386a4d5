// SPDX-License-Identifier: Apache-2.0
// The part of a workpiece that is simulated, against the rules of docs/theory/exposure.md.
#include "machine/simulated_piece.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "geometry/graded_fill.hpp"
#include "input/read.hpp"
#include "input/write_used.hpp"
#include "model/case.hpp"
#include "model/machine.hpp"
#include "output/piece_reasons.hpp"

namespace kerf {
namespace {

Jet round_jet() {
  Jet jet;
  jet.speed = 200.0;
  jet.width = 1e-3;
  jet.standoff = 2e-3;
  jet.spacing = 0.125e-3;
  return jet;
}

Machine feeding(double speed, const Point& direction = {1.0, 0.0, 0.0}) {
  Machine machine;
  machine.traverse_speed = speed;
  machine.traverse_direction = direction;
  return machine;
}

PieceRequest request_for(const Jet& jet, const Point& size) {
  PieceRequest request;
  request.jet = jet;
  request.size = size;
  request.depth = size[1];
  request.spacing = jet.spacing;
  return request;
}

// A round jet of the diameter w acts on its line for w / u.
TEST(SimulatedPiece, ExposureIsTheExtentOverTheSpeed) {
  EXPECT_DOUBLE_EQ(exposure_time(feeding(2.0), round_jet(), 3), 0.5e-3);
  EXPECT_TRUE(std::isinf(exposure_time(feeding(0.0), round_jet(), 3)));
  Jet slot = round_jet();
  slot.length = 10e-3;
  EXPECT_DOUBLE_EQ(exposure_time(feeding(2.0), slot, 3), 0.5e-3);
  EXPECT_DOUBLE_EQ(exposure_time(feeding(2.0, {0.0, 0.0, 1.0}), slot, 3), 5e-3);
  const double half = std::numbers::sqrt2 / 2.0;
  EXPECT_NEAR(exposure_time(feeding(2.0, {half, 0.0, half}), slot, 3), 0.5e-3 / half, 1e-12);
  Jet inclined = round_jet();
  inclined.angle = std::numbers::pi / 3.0;  // its section by the surface is twice as long
  EXPECT_NEAR(exposure_time(feeding(2.0), inclined, 2), 1e-3, 1e-15);
}

// The nozzle stands where w / u > (standoff + 4 h) / V.
TEST(SimulatedPiece, NozzleStandsWhereTheCutIsFaster) {
  const double thickness = 10e-3;
  const double passage = passage_time(round_jet(), thickness);
  EXPECT_NEAR(passage, 42e-3 / 200.0, 1e-15);
  const double limit = 1e-3 / passage;
  EXPECT_TRUE(may_stand(feeding(0.99 * limit), round_jet(), thickness, 3));
  EXPECT_FALSE(may_stand(feeding(1.01 * limit), round_jet(), thickness, 3));
}

TEST(SimulatedPiece, WindowEndsAtPlanesAndAtEdges) {
  const auto whole = simulated_piece(request_for(round_jet(), {1.0, 0.25e-3, 1.0}));
  EXPECT_TRUE(whole.symmetry.minimum[0] && whole.symmetry.minimum[2]);
  EXPECT_EQ(whole.workpiece.levels, 2);
  EXPECT_EQ(whole.workpiece.part.minimum[0], 0.0);
  EXPECT_EQ(whole.domain.minimum[0], 0.0);
  EXPECT_NEAR(whole.workpiece.part.maximum[0], 8.5e-3, 0.5e-3);  // whole coarsest cells
  EXPECT_EQ(whole.workpiece.part.minimum[1], -0.25e-3);
  const Faces beyond = continued_faces(whole.workpiece, whole.symmetry, 3);
  EXPECT_TRUE(beyond.maximum[0] && beyond.maximum[2]);
  EXPECT_FALSE(beyond.minimum[0] || beyond.minimum[1] || beyond.maximum[1]);

  // The piece ends beside the jet: that face is free, and there is no plane.
  Jet at_edge = round_jet();
  at_edge.position = {19e-3, 0.0, 0.0};
  const auto edge = simulated_piece(request_for(at_edge, {40e-3, 0.25e-3, 1.0}));
  EXPECT_EQ(edge.workpiece.part.maximum[0], 20e-3);
  EXPECT_FALSE(edge.symmetry.minimum[0]);
  EXPECT_FALSE(continued_faces(edge.workpiece, edge.symmetry, 3).maximum[0]);
  EXPECT_TRUE(continued_faces(edge.workpiece, edge.symmetry, 3).minimum[0]);
}

// The nozzle stays in the domain until the end, past the edges of the workpiece too, and so does
// what it pushes out below.
TEST(SimulatedPiece, DomainHoldsTheNozzleAndWhatIsPushedOut) {
  Jet jet = round_jet();
  jet.standoff = 20e-3;
  jet.angle = 0.8;
  jet.traverse = {0.0, 0.0, -150.0};
  jet.position = {3e-3, 0.0, 2e-3};
  const Point size{20e-3, 5e-3, 12e-3};
  const Box domain = simulated_piece(request_for(jet, size)).domain;
  const double way = 150.0 * passage_time(jet, size[1]);
  EXPECT_GT(way, size[2]);
  const double side = jet.standoff * std::sin(jet.angle);
  EXPECT_LT(domain.minimum[0], jet.position[0] - side);
  EXPECT_GT(domain.maximum[1], jet.standoff * std::cos(jet.angle));
  EXPECT_LT(domain.minimum[2], jet.position[2] - way);
  EXPECT_LT(domain.minimum[1], -5.0 * size[1]);
}

// The azimuth of a tilted jet is a right angle to rounding; its nozzle is on the symmetry plane.
TEST(SimulatedPiece, JetsThatLeanAlongASymmetryPlaneAreAccepted) {
  for (const char* angle : {"20 deg", "-20 deg", "5 deg"})
    for (const char* key : {"tilt_angle", "lead_angle"}) {
      const Case read = parse_case(fmt::format(R"(title = "tilt"
dimension = 3
quality = "draft"
[machine]
pressure = "100 MPa"
orifice_diameter = "0.2 mm"
standoff = "5 mm"
{} = "{}"
[workpiece]
material = "tofu"
size = ["100 mm", "2 mm", "100 mm"]
)",
                                               key, angle),
                                   "test");
      EXPECT_TRUE(read.symmetry.minimum[0] || read.symmetry.minimum[2]) << key << angle;
    }
}

// A workpiece that is narrower than the window has 10.25 coarsest cells beside the plane, which
// graded bodies exclude.
TEST(SimulatedPiece, PlanesAndLevelsGoTogetherInWholeCells) {
  auto request = request_for(round_jet(), {10.25e-3, 4e-3, 1.0});
  const auto either = simulated_piece(request);
  EXPECT_TRUE(either.workpiece.levels == 0 || !either.symmetry.any());
  request.size[0] = 10e-3;
  const auto both = simulated_piece(request);
  EXPECT_EQ(both.workpiece.levels, 2);
  EXPECT_TRUE(both.symmetry.minimum[0] && both.symmetry.minimum[2]);
  request.levels = 0;
  EXPECT_EQ(simulated_piece(request).workpiece.levels, 0);
}

// A draft simulates 32 jet widths of a workpiece that is thicker than 48; the workpiece goes on
// below them, and the run ends two widths above their end.
TEST(SimulatedPiece, DraftsOfThickWorkpiecesEndWithinThem) {
  EXPECT_DOUBLE_EQ(depth_of_draft(round_jet(), 48e-3), 48e-3);
  EXPECT_DOUBLE_EQ(depth_of_draft(round_jet(), 49e-3), 32e-3);
  Case description;
  description.jets = {round_jet()};
  auto request = request_for(round_jet(), {1.0, 100e-3, 1.0});
  const auto whole = simulated_piece(request);
  EXPECT_EQ(thickness_below(whole.workpiece), 0.0);
  description.workpiece = whole.workpiece;
  EXPECT_TRUE(std::isinf(last_front_depth(description)));
  request.depth = 32e-3;
  const auto upper = simulated_piece(request);
  EXPECT_NEAR(thickness_below(upper.workpiece), 68e-3, 1e-12);
  EXPECT_TRUE(continued_faces(upper.workpiece, upper.symmetry, 3).minimum[1]);
  EXPECT_LT(upper.domain.minimum[1], -33e-3);  // room for the water
  description.workpiece = upper.workpiece;
  EXPECT_NEAR(last_front_depth(description), 30e-3, 1e-12);
  description.jets[0].angle = std::numbers::pi / 3.0;
  EXPECT_NEAR(last_front_depth(description), 62e-3, 1e-12);
}

// Seven columns across have one in the middle; a slot at an angle to the axes is not its image.
TEST(SimulatedPiece, JetsThatPlanesWouldCutHaveNone) {
  Jet odd = round_jet();
  odd.spacing = 1e-3 / 7.0;
  EXPECT_FALSE(simulated_piece(request_for(odd, {1.0, 1e-3, 1.0})).symmetry.any());
  Jet slot = round_jet();
  slot.length = 4e-3;
  EXPECT_TRUE(simulated_piece(request_for(slot, {1.0, 1e-3, 1.0})).symmetry.minimum[0]);
  slot.azimuth = 0.5;
  EXPECT_FALSE(simulated_piece(request_for(slot, {1.0, 1e-3, 1.0})).symmetry.any());
}

TEST(SimulatedPiece, MotionAndLeanRemovePlanes) {
  Jet moving = round_jet();
  moving.traverse = {50.0, 0.0, 0.0};
  auto request = request_for(moving, {1.0, 0.25e-3, 1.0});
  const auto half = simulated_piece(request);
  EXPECT_FALSE(half.symmetry.minimum[0]);
  EXPECT_GE(half.workpiece.part.maximum[0], 12.5e-3);  // four widths of path
  request.jet = round_jet();
  request.jet.angle = 0.3;
  request.jet.azimuth = std::numbers::pi / 2.0;  // towards z
  EXPECT_FALSE(simulated_piece(request).symmetry.minimum[2]);
  request.jet = round_jet();
  request.may_mirror = false;
  const auto graded = simulated_piece(request);
  EXPECT_FALSE(graded.symmetry.any());
  EXPECT_GT(graded.workpiece.levels, 0);
  EXPECT_NEAR(graded.workpiece.part.minimum[0], -graded.workpiece.part.maximum[0], 1e-12);
}

std::string piece_case(const std::string& machine, const std::string& workpiece,
                       const std::string& rest = "") {
  return R"(title = "a real cut"
dimension = 3
quality = "draft"
[machine]
pressure = "200 MPa"
orifice_diameter = "0.15 mm"
standoff = "5 mm"
)" + machine +
         R"(
[workpiece]
material = "polyurethane-foam"
size = ["300 mm", "5 mm", "200 mm"]
)" + workpiece +
         "\n" + rest;
}

// The case that ran is the same case when it is read again.
// Where the nozzle moves in the run the spacing is that of the jet along its whole path, in either
// direction.
TEST(SimulatedPiece, IsFineAlongThePathOfTheNozzle) {
  for (const double sign : {1.0, -1.0}) {
    const Case moving = parse_case(fmt::format(R"(title = "moving"
dimension = 3
quality = "draft"
[machine]
pressure = "13 kPa"
orifice_diameter = "10 mm"
standoff = "10 mm"
traverse_speed = "1 m/s"
traverse_direction = [{}, 0, 0]
[workpiece]
material = "tofu"
size = ["300 mm", "50 mm", "200 mm"]
)",
                                               sign),
                                   "moving.toml");
    const Jet& jet = moving.jets[0];
    const Grading& grading = moving.bodies[0].grading;
    const double way = moving.time.end * std::abs(jet.traverse[0]);
    ASSERT_GT(way, 4.0 * jet.width);
    ASSERT_GT(grading.levels, 0);
    for (int n = 0; n <= 40; ++n) {
      Point below = jet.position;
      below[0] += sign * way * n / 40.0;
      below[1] = -20e-3;
      EXPECT_DOUBLE_EQ(distance_from_finest(grading, below, 3), 0.0) << sign << " " << n;
      below[2] += 0.5 * jet.width + 0.5 * grading.width;
      EXPECT_LT(distance_from_finest(grading, below, 3), 0.6 * grading.width) << sign << " " << n;
    }
    Point before = jet.position;
    before[0] -= sign * (0.5 * jet.width + 1.01 * grading.width);
    EXPECT_GT(distance_from_finest(grading, before, 3), grading.width);
  }
}

TEST(SimulatedPiece, UsedCaseIsTheSameCase) {
  for (const char* feed : {"1 m/s", "200 m/s", "0 m/s"}) {
    const Case first = parse_case(piece_case(fmt::format("traverse_speed = \"{}\"", feed), ""),
                                  "my.toml", quick_look);
    EXPECT_EQ(first.machine->motion,
              std::string(feed) == "1 m/s" ? NozzleMotion::standing : NozzleMotion::travelling);
    const Case again = parse_case(write_used(first), "used.toml", quick_look);
    EXPECT_EQ(first, again) << feed;
    EXPECT_EQ(first.bodies.front().name, workpiece_name);
    EXPECT_GE(piece_reasons(first).size(), 2u);
  }
}

TEST(SimulatedPiece, NoDepthIsPromisedAtTheFeedOfAPulsedJet) {
  for (const bool is_pulsed : {false, true}) {
    const std::string machine = std::string("traverse_speed = \"1 m/s\"\nmotion = \"standing\"") +
                                (is_pulsed ? "\npulse_frequency = \"50 kHz\"\nduty = 0.3" : "");
    const auto reason =
        piece_reasons(parse_case(piece_case(machine, ""), "my.toml", quick_look)).back();
    EXPECT_EQ(reason.find("to which the depth is carried") == std::string::npos, is_pulsed);
    EXPECT_EQ(reason.find("leave gaps") != std::string::npos, is_pulsed);
  }
}

TEST(SimulatedPiece, EveryChoiceCanBeSet) {
  const Case chosen = parse_case(
      piece_case("traverse_speed = \"1 m/s\"\nmotion = \"travelling\"",
                 "minimum = [\"-1 mm\", \"-5 mm\", \"-1 mm\"]\n"
                 "maximum = [\"2 mm\", \"0 mm\", \"1 mm\"]\nlevels = 1\nspacing = \"40 um\"\n"
                 "grading_width = \"0.2 mm\"",
                 "[time]\nend = \"10 us\"\nafter_cut = \"1 us\"\n"),
      "my.toml", quick_look);
  EXPECT_EQ(chosen.bodies.front().shape.box.maximum[0], 2e-3);
  EXPECT_EQ(chosen.bodies.front().grading.levels, 1);
  EXPECT_EQ(chosen.bodies.front().spacing, 40e-6);
  EXPECT_EQ(chosen.jets.back().traverse[0], 1.0);
  EXPECT_EQ(chosen.time.after_cut, 1e-6);
  EXPECT_FALSE(chosen.symmetry.any());
}

}  // namespace
}  // namespace kerf
