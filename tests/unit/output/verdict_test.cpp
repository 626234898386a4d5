// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "output/result.hpp"
#include "verdict_outcomes.hpp"

namespace kerf {
namespace {

// Bodies in the way of the jet are named by their fate.
TEST(Verdict, NamesWhatIsCutThroughAndWhatIsWhole) {
  RunOutcome outcome = touched_outcome();
  outcome.description.jets.emplace_back();
  outcome.time = 0.03;
  outcome.cut.last.front_depth = 0.0123;
  outcome.description.bodies.resize(4);
  outcome.description.materials.resize(1);
  for (Body& body : outcome.description.bodies) body.material = 0;
  outcome.kerf.emplace();
  const char* names[] = {"liver", "vessel", "fat", "stone"};
  for (int n = 0; n < 4; ++n) {
    outcome.description.bodies[static_cast<std::size_t>(n)].name = names[n];
    KerfLayer layer;
    layer.body = n;
    layer.verdict.is_in_way = n < 3;
    layer.verdict.cut.through = n == 0;
    layer.shape.through_share = n == 0 ? 1.0 : 0.0;
    layer.fractured_mass = n == 2 ? 0.1 : 0.0;
    outcome.kerf->layers.push_back(layer);
  }
  outcome.cut.last.fractured_mass = 1e-6;
  outcome.cut.last.cut_depth = 0.0105;
  outcome.kerf->of<CutMargin>().unbroken = 2.5e-3;
  EXPECT_EQ(
      verdict_of(outcome),
      "The jet does not cut through within 30 ms; liver is cut through, vessel is whole, fat is "
      "cut in part; the cut is 10.5 mm and its front 12.3 mm deep, and 2.5 mm of the thickness is "
      "unbroken.");
  const auto layers = result_of(outcome).at("kerf").at("layers");
  EXPECT_EQ(layers.at(0).at("verdict"), "cut through");
  outcome.kerf->layers.front().is_covered = true;
  EXPECT_EQ(result_of(outcome).at("kerf").at("layers").at(0).at("verdict"),
            "broken under a body that is not cut through");
  EXPECT_NE(verdict_of(outcome).find("liver is broken under a body that is not cut through"),
            std::string::npos);
  outcome.kerf->layers.front().is_covered = false;
  // Under a nozzle that travels one hole is a cut, and a third of its way is not all of it.
  outcome.kerf->layers.front().shape.through_share = 0.31;
  EXPECT_EQ(result_of(outcome).at("kerf").at("layers").at(0).at("verdict"),
            "cut through on a part of the way");
  outcome.kerf->layers.front().shape.through_share = 1.0;
  EXPECT_EQ(layers.at(1).at("verdict"), "whole");
  EXPECT_EQ(layers.at(2).at("verdict"), "cut in part");
  EXPECT_EQ(layers.at(3).at("verdict"), "not under the jet");
  EXPECT_EQ(layers.at(0).at("cut_through"), true);
  EXPECT_TRUE(layers.at(1).at("cut_through_time").is_null());
  for (KerfLayer& layer : outcome.kerf->layers) {
    layer.verdict.cut = {true, true};
    layer.shape.through_share = layer.body == 1 ? 0.0 : 1.0;
  }
  outcome.cut.cut_through = outcome.cut.severed = true;
  outcome.cut.cut_through_time = 0.0221;
  outcome.cut.last.pieces = 3;
  outcome.kerf->shape.through = false;
  outcome.kerf->shape.depth = 1.5e-3;
  EXPECT_EQ(
      verdict_of(outcome),
      "The workpiece is parted after 22.1 ms by a crack below a cut of 1.5 mm; liver and fat are "
      "cut through, vessel is parted; at the end the workpiece is in 3 pieces.");
}

TEST(Verdict, TellsWhatWasPushedOutOrMissed) {
  RunOutcome outcome = touched_outcome();
  outcome.description.jets.emplace_back();
  outcome.description.materials.resize(1);
  outcome.description.bodies.resize(1);
  outcome.description.bodies[0].name = "gel";
  outcome.description.bodies[0].material = 0;
  outcome.time = 0.03;
  outcome.kerf.emplace();
  EXPECT_EQ(verdict_of(outcome),
            "The jet aims at no body that it could cut at the start; its water has met one beside "
            "its way or that moved into it.");
  outcome.balance.mass_fractured = 1.0;
  EXPECT_THAT(verdict_of(outcome), testing::EndsWith("moved into it, and solid has broken."));
  outcome.balance.impulse_water = {};
  EXPECT_EQ(verdict_of(outcome), "The jet aims at no body that it could cut.");
  outcome.balance = touched_outcome().balance;
  outcome.kerf->shape.thickness = 8e-3;
  outcome.kerf->of<CutMargin>().unbroken = 8e-3;
  outcome.cut.last.front_depth = 0.04;
  outcome.cut.last.fractured_mass = 1.0;
  outcome.cut.bodies.push_back(
      {.body = 0, .is_in_way = true, .can_break = true, .cut = {.left = true}});
  EXPECT_EQ(
      verdict_of(outcome),
      "The jet does not cut through within 30 ms; its front is 40 mm deep, and 8 mm of the "
      "thickness is unbroken; it has pushed gel out of the domain unbroken, where nothing is known "
      "of it: a larger [domain] would tell.");
}

// A jet whose water is still on its way is not said to do nothing.
TEST(Verdict, WaterOnItsWayIsTold) {
  RunOutcome outcome;
  outcome.description.jets.push_back(arriving_jet());
  outcome.description.bodies.emplace_back();
  outcome.time = 0.002;
  EXPECT_EQ(verdict_of(outcome),
            "No water has come to the workpiece within 2 ms: it would come after 3 ms.");
}

// The verdict is on the first of several jets.
TEST(Verdict, TheFirstOfSeveralJetsIsNamed) {
  RunOutcome outcome = touched_outcome();
  outcome.description.jets = {arriving_jet(), arriving_jet()};
  outcome.description.bodies.emplace_back();
  outcome.time = 0.06;
  outcome.kerf.emplace();
  outcome.kerf->shape.thickness = 8e-3;
  outcome.cut.last.front_depth = outcome.cut.last.cut_depth = 3e-3;
  outcome.cut.last.fractured_mass = 1.0;
  outcome.cut.last.fractured_fraction = 0.12;
  EXPECT_EQ(
      verdict_of(outcome),
      "The first of 2 jets does not cut through within 60 ms; the cut is 3 mm and its front 3 mm "
      "deep, and none of the thickness is unbroken: torn solid that still stands in the way of "
      "the water joins the sides. The 2 jets together have broken 12% of the "
      "workpiece; which of them broke what is not told.");
}

// A dent in which bonds have broken without a path from the face is no cut, whatever its depth.
TEST(Verdict, ADentWithBrokenBondsIsNoCut) {
  RunOutcome outcome = touched_outcome();
  outcome.description.jets.push_back(arriving_jet());
  outcome.description.bodies.emplace_back();
  outcome.description.bodies.front().spacing = 2e-3;
  outcome.description.machine.emplace().motion = NozzleMotion::standing;
  outcome.description.machine->traverse_speed = 1.0;
  outcome.description.workpiece.emplace();
  outcome.time = 0.06;
  outcome.kerf.emplace();
  outcome.kerf->shape.thickness = 8e-3;
  outcome.kerf->of<CutMargin>().unbroken = 8e-3;
  outcome.cut.last.front_depth = 0.03;  // the water beside the body
  outcome.kerf->of<Dent>().depth = 4e-3;
  outcome.balance.dissipated_fracture = 1e-6;  // of one bond
  const std::string verdict = verdict_of(outcome);
  EXPECT_THAT(
      verdict,
      testing::StartsWith("The jet cuts nothing within 60 ms; it presses a dent of 4 mm into the "
                          "workpiece; what has broken opens no path from the face, and 8 mm of the "
                          "thickness is unbroken. A feed of 1 m/s"));
  EXPECT_THAT(verdict, testing::EndsWith("a dent is not carried on to that."));
}

// The dent is what the jet has pressed, not where its water is, and a jet that does nothing is said
// to do nothing.
TEST(Verdict, TheDentIsThatOfTheSolid) {
  for (const double nothing : {0.0, 1e-6})
    EXPECT_EQ(verdict_of(whole_outcome(nothing, nothing)),
              "The jet breaks nothing within 60 ms and makes no measurable dent.");
  RunOutcome outcome = whole_outcome(1e-4, 5e-5);
  EXPECT_EQ(verdict_of(outcome),
            "The jet breaks nothing within 60 ms; it presses a dent of 100 um into the workpiece.");
  outcome.time = 1200.0;
  EXPECT_EQ(verdict_of(outcome),
            "The jet breaks nothing within 20 min 00 s; it presses a dent of 100 um into the "
            "workpiece.");
}

TEST(Verdict, AWorkpieceThatMovesIsNotDented) {
  EXPECT_EQ(verdict_of(whole_outcome(0.0, 0.0195)),
            "The jet breaks nothing within 60 ms and makes no measurable dent; the workpiece has "
            "bent or moved by 19.5 mm.");
  EXPECT_EQ(verdict_of(whole_outcome(1e-3, 0.0195)),
            "The jet breaks nothing within 60 ms; it presses a dent of 1 mm into the workpiece; "
            "the workpiece has bent or moved by 19.5 mm.");
}

// Water that exerts no force has touched nothing, wherever it is, and breaks nothing either.
TEST(Verdict, WaterThatTouchesNothingIsTold) {
  RunOutcome outcome = whole_outcome(0.0, 0.09);
  outcome.balance.impulse_water = {0.0, 1e-8, 0.0};  // of rounding
  outcome.cut.last.fractured_mass = outcome.cut.mass_left_whole = 0.1;
  EXPECT_EQ(verdict_of(outcome),
            "The water has not touched the workpiece within 60 ms; the workpiece has bent or moved "
            "by 90 mm.");
  outcome.time = 0.002;
  outcome.cut.mass_left_whole = 0.02;  // most of what has gone was torn off before it left
  outcome.cut.cut_through = true;
  EXPECT_EQ(verdict_of(outcome),
            "No water has come to the workpiece within 2 ms: it would come after 3 ms; solid has "
            "broken without it; the workpiece has bent or moved by 90 mm.");
  outcome.cut.last.pieces = 2;
  EXPECT_THAT(verdict_of(outcome), testing::EndsWith("by 90 mm; the workpiece is in 2 pieces."));
  outcome.cut.last.pieces = 1;
  outcome.cut.mass_left_whole = 0.06;
  EXPECT_THAT(verdict_of(outcome), testing::Not(testing::HasSubstr("broken")));
}

// A crack that leads past solid which is whole on the lines along the jet is told as such.
TEST(Verdict, TheCutAndTheUnbrokenThicknessDoNotContradict) {
  RunOutcome outcome = whole_outcome(0.0, 0.0);
  outcome.cut.last.fractured_mass = 1.0;
  outcome.cut.last.cut_depth = 8e-3;
  outcome.kerf->of<CutMargin>() = {-0.5, 4e-3};
  EXPECT_EQ(verdict_of(outcome),
            "The jet does not cut through within 60 ms; cracks reach 8 mm deep along an inclined "
            "path and its front 30 mm, and 4 mm of the thickness is unbroken on each line along "
            "the jet.");
  outcome.cut.last.cut_depth = 4e-3;
  outcome.kerf->of<Dent>().motion = 0.027;
  outcome.description.jets.front().width = 0.01;
  EXPECT_EQ(verdict_of(outcome),
            "The jet does not cut through within 60 ms; the cut is 4 mm and its front 30 mm deep, "
            "and 4 mm of the thickness is unbroken; the workpiece has bent or moved by 27 mm.");
  // With a void of 10 mm in it.
  outcome.cut.last.cut_depth = 14e-3;
  outcome.kerf->shape.thickness = 18e-3;
  EXPECT_THAT(verdict_of(outcome), testing::HasSubstr("; the cut is 14 mm and its front 30 mm"));
}

// Bodies that were never joined are pieces from the start, and of those beside each other the one
// that is unbroken is named.
TEST(Verdict, PiecesAndLayersAreThoseOfTheStart) {
  RunOutcome outcome = whole_outcome(0.0, 0.0);
  outcome.description.materials.resize(1);
  outcome.description.bodies.resize(2);
  outcome.cut.last.fractured_mass = 1.0;
  outcome.cut.last.cut_depth = 8e-3;
  outcome.kerf->of<CutMargin>().unbroken = 3e-3;
  for (const int body : {0, 1}) {
    outcome.description.bodies[static_cast<std::size_t>(body)].name = body == 0 ? "left" : "right";
    KerfLayer layer;
    layer.body = body;
    layer.verdict.is_in_way = true;
    layer.verdict.cut.through = body == 1;
    layer.fractured_mass = 0.5;
    layer.unbroken = body == 0 ? 3e-3 : 0.0;
    outcome.kerf->layers.push_back(layer);
  }
  EXPECT_EQ(verdict_of(outcome),
            "The jet does not cut through within 60 ms; left is cut in part, right is broken "
            "through; the cut is 8 mm and its front 30 mm deep, and 3 mm of the thickness of left "
            "is unbroken.");
  outcome.kerf->layers[0].verdict.cut.through = true;
  outcome.kerf->shape.through = true;
  outcome.cut.cut_through = true;
  outcome.cut.cut_through_time = 0.03;
  outcome.cut.initial_pieces = outcome.cut.last.pieces = 2;
  EXPECT_EQ(verdict_of(outcome),
            "The jet cuts through after 30 ms; left and right are broken through; at the end the "
            "workpiece is in 2 pieces, of 2 at the start.");
}

TEST(Verdict, APlugIsTold) {
  RunOutcome outcome = whole_outcome(0.0, 0.0);
  outcome.cut.cut_through = outcome.cut.severed = outcome.cut.punched = true;
  outcome.cut.cut_through_time = 4.4e-3;
  outcome.cut.last.pieces = 3;
  outcome.kerf->of<CutMargin>().is_whole = true;
  EXPECT_EQ(verdict_of(outcome),
            "The jet punches out a plug after 4.4 ms; at the end the workpiece is in 3 pieces.");
}

// A crack aside of the way of the jet, as of another jet, is no cut of it.
TEST(Verdict, ACrackBesideTheWayIsTold) {
  RunOutcome outcome = whole_outcome(0.0, 0.0);
  outcome.cut.last.fractured_mass = 1.0;
  outcome.cut.cut_through = outcome.cut.severed = true;
  outcome.cut.cut_through_time = 0.03;
  outcome.cut.last.pieces = 2;
  outcome.kerf->of<CutMargin>().is_whole = true;
  EXPECT_EQ(verdict_of(outcome),
            "The workpiece is parted after 30 ms by a crack beside the way of the jet, where it is "
            "whole; at the end the workpiece is in 2 pieces.");
}

}  // namespace
}  // namespace kerf
