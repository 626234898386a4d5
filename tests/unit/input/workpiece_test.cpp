// SPDX-License-Identifier: Apache-2.0
// What a case with a [workpiece] refuses, and what it says.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "core/error.hpp"
#include "input/read.hpp"
#include "model/case.hpp"

namespace kerf {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

// A jet 0.6 mm wide over fat.
std::string fat_case(const std::string& machine, const std::string& workpiece) {
  return R"(title = "fat"
dimension = 2
quality = "draft"
[machine]
pressure = "5 MPa"
orifice_diameter = "1 mm"
standoff = "1 mm"
)" + machine +
         R"(
[workpiece]
material = "fat"
)" + workpiece;
}

std::string refusal_of(const std::string& text, const ReadEffort& effort = quick_look) {
  try {
    parse_case(text, "fat.toml", effort);
  } catch (const UserError& error) {
    return error.what();
  }
  return "";
}

std::string slit_case(const std::string& orifice, const std::string& standoff = "3 mm") {
  return "title = \"slit\"\ndimension = 3\nquality = \"draft\"\n[machine]\n"
         "pressure = \"30 MPa\"\norifice_diameter = \"0.1 mm\"\ntraverse_speed = \"1 m/s\"\n"
         "standoff = \"" +
         standoff + "\"\n" + orifice +
         "[workpiece]\nmaterial = \"fat\"\nsize = [\"300 mm\", \"1 mm\", \"200 mm\"]\n";
}

// A sheet of water may be twice as long as the workpiece; a longer one is blamed on its own keys.
TEST(Workpiece, ASheetBesideTheWorkpieceIsRefused) {
  const std::string slit = "orifice_type = \"slit\"\norifice_length = ";
  EXPECT_THAT(refusal_of(slit_case(slit + "\"10 m\"\n")),
              AllOf(HasSubstr("machine.orifice_length = \"10 m\""), HasSubstr("0.2 m"),
                    Not(HasSubstr("symmetry"))));
  for (const std::string length : {"10 mm", "399 mm", "399.01 mm", "399.02 mm"})
    EXPECT_EQ(refusal_of(slit_case(slit + "\"" + length + "\"\n")), "") << length;
  const std::string fan =
      "orifice_type = \"fan\"\norifice_length = \"1 mm\"\nfan_angle = \"170 deg\"\n";
  EXPECT_THAT(refusal_of(slit_case(fan, "30 mm")),
              AllOf(HasSubstr("machine.fan_angle"), Not(HasSubstr("[domain]"))));
  EXPECT_EQ(refusal_of(slit_case(fan, "10 mm")), "");
}

// A jet starts where its standoff says; no position is written.
TEST(Workpiece, AStandoffThatIsTooShortForTheAngleIsNamed) {
  const std::string text = fat_case("lead_angle = \"80 deg\"\n", "size = [\"200 mm\", \"8 mm\"]\n");
  EXPECT_THAT(refusal_of(text), AllOf(HasSubstr("machine.standoff = \"1 mm\""),
                                      HasSubstr("Allowed: at least"), Not(HasSubstr("position"))));
  std::string longer = text;
  longer.replace(longer.find("standoff = \"1 mm\""), 17, "standoff = \"9 mm\"");
  EXPECT_EQ(refusal_of(longer), "");
}

// The run of a part ends where the front is two jet widths above its end.
TEST(Workpiece, APartIsDeeperThanItsRunLeavesOut) {
  const std::string size = "size = [\"200 mm\", \"8 mm\"]\n";
  for (const std::string depth : {"0.05 mm", "1 mm", "1.2 mm", "1.8 mm"}) {
    EXPECT_THAT(refusal_of(fat_case("", size + "depth = \"" + depth + "\"\n")),
                AllOf(HasSubstr("workpiece.depth = \"" + depth + "\""),
                      HasSubstr("three widths of the jet, or the thickness")));
    EXPECT_THAT(refusal_of(fat_case("", size + "minimum = [\"-6 mm\", \"-" + depth +
                                            "\"]\nmaximum = [\"6 mm\", \"0 mm\"]\n")),
                HasSubstr("workpiece.minimum"));
  }
  EXPECT_EQ(refusal_of(fat_case("", size + "depth = \"2 mm\"\n")), "");
  // A thin sheet is simulated as a whole.
  const std::string thin = "size = [\"200 mm\", \"0.5 mm\"]\n";
  EXPECT_THAT(refusal_of(fat_case("", thin + "depth = \"0.4 mm\"\n")),
              HasSubstr("Allowed: the thickness"));
  EXPECT_EQ(refusal_of(fat_case("", thin)), "");
}

TEST(Workpiece, TheNozzleAimsAtItsUpperFace) {
  const std::string size = "size = [\"200 mm\", \"4 mm\"]\n";
  EXPECT_THAT(refusal_of(fat_case("position = [\"0 mm\", \"-0.9 mm\"]", size)),
              AllOf(HasSubstr("machine.position"), HasSubstr("the upper face")));
  EXPECT_EQ(refusal_of(fat_case("position = [\"3 mm\", \"0 mm\"]", size)), "");
}

TEST(Workpiece, AFrameWithoutAFeedIsRefusedForThatAlone) {
  EXPECT_THAT(refusal_of(fat_case("", "size = [\"200 mm\", \"4 mm\"]\nframe = \"travelling\"\n")),
              AllOf(HasSubstr("machine.traverse_speed"), Not(HasSubstr("nan"))));
}

// A look at a case accepts what a run refuses, but nothing that cannot be counted.
TEST(Workpiece, WhatCannotBeCountedIsRefused) {
  const std::string size = "size = [\"200 mm\", \"4 mm\"]\n";
  const std::string fine = fat_case("spacing = \"0.1 um\"", size);
  EXPECT_EQ(refusal_of(fine), "");
  EXPECT_THAT(refusal_of(fine, {5e8, 1e5}), HasSubstr("Allowed: at most 5e+08 particles"));
  EXPECT_THAT(refusal_of(fat_case("spacing = \"1 fm\"", size)),
              HasSubstr("Allowed: at most 5e+08 particles"));
}

// A number is shown as it was written.
TEST(Workpiece, AWholeNumberWithAPointIsShownWithIt) {
  std::string text = fat_case("", "size = [\"200 mm\", \"4 mm\"]\n");
  text.replace(text.find("= 2"), 3, "= 2.0");
  EXPECT_THAT(refusal_of(text), HasSubstr("dimension = 2.0: this is not what the key holds"));
}

// Particles that cannot be counted are blamed on a key that the case states.
TEST(Workpiece, AHugeOneIsBlamedOnItsSize) {
  const std::string huge = "size = [\"10 km\", \"10 km\"]\nlevels = 0\n";
  EXPECT_THAT(refusal_of(fat_case("", huge), ReadEffort{}),
              AllOf(HasSubstr("workpiece.size"), HasSubstr("particles"),
                    Not(HasSubstr("workpiece.spacing"))));
  EXPECT_THAT(refusal_of(fat_case("", huge + "spacing = \"0.1 mm\"\n"), ReadEffort{}),
              HasSubstr("workpiece.spacing = \"0.1 mm\""));
}

}  // namespace
}  // namespace kerf
