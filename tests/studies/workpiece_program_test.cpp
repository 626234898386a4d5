// SPDX-License-Identifier: Apache-2.0
// A case of a machine and a whole workpiece from the file to the answer at its feed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "faults/program.hpp"
#include "support/temporary_folder.hpp"

namespace kerf {
namespace {

using test::Ending;
using test::Program;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

// A jet of 5 m/s, 6.1 mm wide where it meets the tofu.
constexpr const char* tofu_workpiece = R"(title = "Tofu of 20 mm"
dimension = 2
quality = "draft"

[machine]
pressure = "13 kPa"
orifice_diameter = "10 mm"
standoff = "10 mm"
spacing = "2 mm"
traverse_speed = "10 mm/s"

[workpiece]
material = "tofu"
size = ["2000 mm", "20 mm"]
)";

// A jet of 134 m/s, 0.6 mm wide, that removes what is in its way.
constexpr const char* fat_workpiece = R"(title = "Fat of 2 mm"
dimension = 2
quality = "draft"

[machine]
pressure = "9 MPa"
orifice_diameter = "1 mm"
standoff = "1 mm"
spacing = "0.1 mm"
traverse_speed = "1 m/s"

[workpiece]
material = "fat"
size = ["200 mm", "2 mm"]
minimum = ["-6 mm", "-2 mm"]
maximum = ["6 mm", "0 mm"]
levels = 0
)";

class WorkpieceProgram : public testing::Test {
 protected:
  WorkpieceProgram() { write(tofu_workpiece); }
  void write(const std::string& text) const { write_file(folder_ / "my.toml", text); }
  Ending run() const {
    return kerf(
        {"run", (folder_ / "my.toml").string(), "--force", "--out", (folder_ / "out").string()});
  }
  Ending check() const { return kerf({"check", (folder_ / "my.toml").string()}); }
  Ending limit(const std::string& of) const {
    return kerf({"limit", (folder_ / "my.toml").string(), "--of", of, "--out",
                 (folder_ / "limit").string(), "--tolerance", "0.4"});
  }
  nlohmann::json limit_answer() const {
    return nlohmann::json::parse(read_file(folder_ / "limit/limit.json"));
  }
  nlohmann::json result() const {
    return nlohmann::json::parse(read_file(folder_ / "out/result.json"));
  }
  std::string file(const char* name) const { return read_file(folder_ / "out" / name); }

  test::TemporaryFolder folder_;

 private:
  Ending kerf(const std::vector<std::string>& arguments) const {
    return Program(arguments, folder_ / "output.txt").wait();
  }
};

// Three columns across the jet exclude a symmetry plane, which an even number does not.
TEST_F(WorkpieceProgram, CheckTellsWhatIsSimulatedAndWhy) {
  const Ending ending = check();
  ASSERT_EQ(ending.exit_code, 0) << ending.output;
  EXPECT_THAT(ending.output, AllOf(HasSubstr("of the workpiece of 2 m x 20 mm are simulated"),
                                   HasSubstr("The nozzle stands still in the run"),
                                   Not(HasSubstr("symmetry plane in the axis"))));
}

TEST_F(WorkpieceProgram, TellsTheCutAtTheFeedOfAStandingNozzle) {
  write(fat_workpiece);
  const Ending ending = run();
  ASSERT_EQ(ending.exit_code, 0) << ending.output;
  const auto all = result();
  const auto& exposure = all.at("exposure");
  const double width = all.at("machine").at("width_at_workpiece"), feed = 1.0;
  // w / u; the run is far shorter, and ends soon after the jet has passed.
  EXPECT_NEAR(exposure.at("shortest"), width / feed, 1e-6 * width / feed);
  EXPECT_GE(exposure.at("longest"), exposure.at("shortest"));
  EXPECT_EQ(exposure.at("cuts"), true);
  EXPECT_LE(exposure.at("simulated"), 0.1 * exposure.at("shortest").get<double>());
  // The cut is certain up to w / t_c.
  const double after = exposure.at("simulated");
  EXPECT_NEAR(exposure.at("greatest_feed"), width / after, 1e-6 * width / after);
  EXPECT_GE(exposure.at("possible_feed"), exposure.at("greatest_feed"));
  const std::string verdict = all.at("verdict");
  EXPECT_THAT(verdict, HasSubstr("A feed of 1 m/s"));
  EXPECT_THAT(ending.output, HasSubstr(verdict));
  EXPECT_THAT(file("report.html"),
              AllOf(HasSubstr("A feed of 1 m/s"), HasSubstr("<p class=\"verdict yes\"><b>✓")));
}

// A jet of 16 m/s comes to the end of the part; it has not cut the workpiece. Its depth is carried
// on.
TEST_F(WorkpieceProgram, ThePartOfAThickWorkpieceIsNotCutThrough) {
  std::string thick = tofu_workpiece;
  const std::string thin = "\"20 mm\"]";
  thick.replace(thick.find(thin), thin.size(), "\"60 mm\"]\ndepth = \"20 mm\"");
  const std::string slow = "13 kPa";
  thick.replace(thick.find(slow), slow.size(), "130 kPa");
  write(thick);
  EXPECT_THAT(check().output, AllOf(HasSubstr("The upper 20 mm of the thickness are simulated"),
                                    HasSubstr("through the other 40 mm")));
  const Ending ending = run();
  ASSERT_EQ(ending.exit_code, 0) << ending.output;
  const auto all = result();
  EXPECT_EQ(all.at("cut_through"), false);
  EXPECT_NEAR(all.at("kerf").at("thickness"), 60e-3, 2e-3);
  EXPECT_EQ(all.at("kerf").at("through"), false);
  EXPECT_GT(all.at("kerf").at("unbroken"), 40e-3);
  EXPECT_LT(all.at("kerf").at("margin"), -0.6);
  // It ended as the front came within two widths of the lower face of the part.
  const double width = all.at("machine").at("width_at_workpiece");
  EXPECT_GE(all.at("front_depth"), 20e-3 - 2.0 * width);
  EXPECT_LT(all.at("front_depth"), 20e-3);
  const auto& exposure = all.at("exposure");
  EXPECT_GT(exposure.at("depth_high"), all.at("front_depth"));
  EXPECT_GT(exposure.at("decades"), 0.0);
  EXPECT_THAT(
      all.at("verdict").get<std::string>(),
      AllOf(HasSubstr("the end of the depth that is simulated, 20 mm"), HasSubstr("carried over")));
  // The sign of the report is that at the feed.
  const char* sign = exposure.at("cuts") == true      ? "<p class=\"verdict yes\"><b>✓"
                     : exposure.at("may_cut") == true ? "<p class=\"verdict none\"><b>?"
                                                      : "<p class=\"verdict no\"><b>✗";
  EXPECT_THAT(file("report.html"), HasSubstr(sign));
}

// Of a thick workpiece at normal quality the whole thickness is simulated; the advice is a depth.
TEST_F(WorkpieceProgram, CheckAdvisesALesserDepth) {
  write(R"(title = "Muscle of 19 mm"
dimension = 3

[machine]
pressure = "380 MPa"
orifice_diameter = "0.15 mm"
standoff = "3 mm"
traverse_speed = "10 m/min"

[workpiece]
material = "muscle"
size = ["200 mm", "19 mm", "150 mm"]
)");
  EXPECT_THAT(check().output, AllOf(HasSubstr("[workpiece] depth = \"3.75"),
                                    Not(HasSubstr("of the thickness are simulated"))));
}

// The nozzle stands in the run, so one run answers for all feeds; the least pressure is that at
// which the stated feed cuts for certain.
TEST_F(WorkpieceProgram, OneRunTellsTheGreatestFeed) {
  write(fat_workpiece);
  const Ending ending = limit("feed");
  ASSERT_EQ(ending.exit_code, 0) << ending.output;
  ASSERT_EQ(run().exit_code, 0);
  const auto exposure = result().at("exposure"), answer = limit_answer();
  EXPECT_EQ(answer.at("trials").size(), 1u);
  EXPECT_EQ(answer.at("low"), exposure.at("greatest_feed"));
  EXPECT_EQ(answer.at("high"), exposure.at("possible_feed"));
  EXPECT_THAT(ending.output,
              AllOf(HasSubstr("Greatest feed that still cuts: certain up to"),
                    HasSubstr("possible up to"), HasSubstr("The stated 1 m/s cuts.")));
}

TEST_F(WorkpieceProgram, TheLeastPressureIsThatOfTheStatedFeed) {
  std::string faster = fat_workpiece;
  const std::string feed = "\"1 m/s\"";
  write(faster.replace(faster.find(feed), feed.size(), "\"20 m/s\"\nmotion = \"standing\""));
  const Ending ending = limit("pressure");
  ASSERT_EQ(ending.exit_code, 0) << ending.output;
  const auto answer = limit_answer();
  ASSERT_EQ(answer.at("problem"), "") << ending.output;
  for (const auto& trial : answer.at("trials")) {
    const auto folder = folder_ / "limit" / trial.at("report").get<std::string>();
    const auto one = nlohmann::json::parse(read_file(folder.parent_path() / "result.json"));
    const bool cuts = one.contains("exposure") && one["exposure"]["greatest_feed"] >= 20.0;
    EXPECT_EQ(trial.at("holds"), cuts);
    EXPECT_EQ(trial.at("holds"), trial.at("value") >= answer.at("high"));
  }
}

// The cut is observed at times of its own: rows that are far apart made it later and its feed
// uncertain.
TEST_F(WorkpieceProgram, TheRowsOfOutputDoNotChangeTheAnswer) {
  write(fat_workpiece);
  ASSERT_EQ(run().exit_code, 0);
  const auto all = result();
  write(fat_workpiece + std::string("[output]\nseries_interval = \"30 us\"\n"));
  ASSERT_EQ(run().exit_code, 0);
  const auto coarse = result();
  for (const char* name :
       {"cut_through_time", "steps", "end_time", "exposure", "front_speed", "kerf", "validity"})
    EXPECT_EQ(all.at(name), coarse.at(name)) << name;
}

// The jet presses the tofu ahead and aside before it tears: a nozzle that moves may leave it whole.
TEST_F(WorkpieceProgram, NoFeedIsCertainOfWhatGivesWay) {
  ASSERT_EQ(run().exit_code, 0);
  const auto all = result();
  EXPECT_EQ(all.at("cut_through"), true);
  EXPECT_EQ(all.at("gave_way"), true);
  EXPECT_EQ(all.at("exposure").at("cuts"), false);
  EXPECT_THAT(all.at("verdict").get<std::string>(), HasSubstr("so no feed is certain"));
}

// The blow parts the granite before its water has gone in: the feed is that of the water, which
// comes through later, and none is certain. It was "certain up to -665.4 m/s".
TEST_F(WorkpieceProgram, ACrackAheadOfTheWaterTellsNoCertainFeed) {
  write(R"(title = "Granite of 1 mm"
dimension = 2
quality = "draft"

[machine]
pressure = "200 MPa"
orifice_diameter = "0.4 mm"
standoff = "3 mm"
spacing = "60 um"
traverse_speed = "100 mm/s"

[workpiece]
material = "granite"
size = ["20 mm", "1 mm"]
)");
  ASSERT_EQ(run().exit_code, 0);
  const auto all = result();
  ASSERT_EQ(all.at("cracked_ahead"), true);
  EXPECT_LT(all.at("front_share_at_cut"), 0.1);
  EXPECT_GT(all.at("water_through_time"), all.at("cut_through_time"));
  const auto& exposure = all.at("exposure");
  EXPECT_GT(exposure.at("simulated"), 0.0);
  EXPECT_LT(exposure.at("simulated"), all.at("water_through_time"));
  EXPECT_EQ(exposure.at("greatest_feed"), 0.0);
  EXPECT_EQ(exposure.at("cuts"), false);
  const double speed = all.at("machine").at("jet_speed");
  EXPECT_GT(exposure.at("possible_feed"), 0.0);
  EXPECT_LT(exposure.at("possible_feed"), 0.2 * speed);
  EXPECT_THAT(all.at("verdict").get<std::string>(),
              AllOf(HasSubstr("by a crack ahead of the water, which is through after"),
                    HasSubstr("so no feed is certain"), Not(HasSubstr("cuts through"))));
  const Ending ending = limit("feed");
  EXPECT_THAT(ending.output, AllOf(HasSubstr("certain at no feed, possible up to"),
                                   HasSubstr("A crack parted the workpiece ahead of the water")));
  EXPECT_EQ(limit_answer().at("high"), exposure.at("possible_feed"));
}

// A jet that only presses a dent cuts at no feed, however long the nozzle would stand.
TEST_F(WorkpieceProgram, ADentIsNotCarriedToACut) {
  std::string text = tofu_workpiece;
  text.replace(text.find("13 kPa"), 6, "2 kPa");
  write(text);
  ASSERT_EQ(run().exit_code, 0);
  EXPECT_FALSE(result().contains("exposure"));
  EXPECT_THAT(result().at("verdict").get<std::string>(),
              AllOf(HasSubstr("breaks nothing"), HasSubstr("a dent is not carried on"),
                    Not(HasSubstr("cuts through"))));
  EXPECT_THAT(file("report.html"), HasSubstr("<p class=\"verdict no\"><b>✗"));
  const Ending ending = limit("feed");
  EXPECT_THAT(ending.output, HasSubstr("tells no feed"));
}

TEST_F(WorkpieceProgram, RefusesADepthBeyondTheWorkpiece) {
  write(std::string(tofu_workpiece) + "depth = \"30 mm\"\n");
  EXPECT_THAT(check().output, AllOf(HasSubstr("more than the thickness"), HasSubstr("0.02 m")));
  write(std::string(tofu_workpiece) +
        "depth = \"10 mm\"\nminimum = [\"-90 mm\", \"-15 mm\"]\nmaximum = [\"90 mm\", \"0 "
        "mm\"]\n");
  EXPECT_THAT(check().output, AllOf(HasSubstr("not that of the corner"), HasSubstr("0.015 m")));
}

}  // namespace
}  // namespace kerf
