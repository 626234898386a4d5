// SPDX-License-Identifier: Apache-2.0
// The plan, the verdicts and the table of `kerf verify`.
#include "verification/verify.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "support/flight.hpp"
#include "verification/table.hpp"

namespace kerf {
namespace {

using test::flight;

// One check of the block's speed, 3 m/s, with `judgement` as its reference.
std::string plan_text(const std::string& judgement, const std::string& more = "") {
  return R"(
title = "flight"
[[run]]
name = "plain"
[[run]]
name = "fast"
override.body = [ { name = "block", velocity = ["6 m/s", "0 m/s"] } ]
[[run]]
name = "far"
long = true
override.body = [ { name = "block", velocity = ["9 m/s", "0 m/s"] } ]
[[check]]
quantity = "speed"
signal = "body_mean"
field = "velocity"
axis = "x"
reduce = "last"
unit = "cm/s"
si_unit = "m/s"
source = "Newton"
)" + judgement +
         more;
}

Findings findings_of(const std::string& plan, bool all = false) {
  const EmbeddedText texts[] = {{"flight/case", flight}, {"flight/reference", plan}};
  const auto cases = read_verification_cases(texts, {});
  return verify(cases.at(0), all, [](const std::string&, double) {});
}

std::vector<Row> rows_of(const std::string& plan, bool all = false) {
  return findings_of(plan, all).rows;
}

TEST(Verify, PassesAndFailsByTheTolerance) {
  const auto good = rows_of(plan_text("runs = \"plain\"\nreference = \"2*150\"\ntolerance = 0.01"));
  ASSERT_EQ(good.size(), 1u);
  EXPECT_NEAR(good[0].measured, 300.0, 0.01);
  EXPECT_EQ(good[0].verdict, Verdict::pass);
  EXPECT_FALSE(has_failed(good));
  const auto bad = rows_of(plan_text("runs = \"plain\"\nreference = 310\ntolerance = 0.01"));
  EXPECT_EQ(bad[0].verdict, Verdict::fail);
  EXPECT_NEAR(*bad[0].error, 300.0 / 310.0 - 1.0, 1e-5);
  EXPECT_TRUE(has_failed(bad));
}

TEST(Verify, ChecksBounds) {
  const auto verdict = [](const std::string& bounds) {
    return rows_of(plan_text("runs = \"plain\"\n" + bounds))[0].verdict;
  };
  EXPECT_EQ(verdict("at_least = 290\nat_most = 310"), Verdict::pass);
  EXPECT_EQ(verdict("at_least = 301"), Verdict::fail);
  EXPECT_EQ(verdict("at_most = 299"), Verdict::fail);
  EXPECT_EQ(verdict(""), Verdict::reported);
}

TEST(Verify, ChecksTheFinestRunUnlessAllAreRequested) {
  const std::string reference = "runs = [\"plain\", \"fast\"]\nreference = 600\ntolerance = 0.01\n";
  const auto finest = rows_of(plan_text(reference));
  ASSERT_EQ(finest.size(), 2u);
  EXPECT_EQ(finest[0].verdict, Verdict::coarse);
  EXPECT_EQ(finest[1].verdict, Verdict::pass);
  const auto every = rows_of(plan_text(reference, "judge = \"every run\"\n"));
  EXPECT_EQ(every[0].verdict, Verdict::fail);
}

TEST(Verify, ChecksFromANamedRunOn) {
  const std::string reference = "reference = 600\ntolerance = 0.01\n";
  const std::string both = "runs = [\"plain\", \"fast\"]\n" + reference;
  const auto second = rows_of(plan_text(both, "judge = \"from fast\"\n"));
  EXPECT_EQ(second[0].verdict, Verdict::coarse);
  EXPECT_EQ(second[1].verdict, Verdict::pass);
  const auto first = rows_of(plan_text(both, "judge = \"from plain\"\n"));
  EXPECT_EQ(first[0].verdict, Verdict::fail);
  EXPECT_EQ(first[1].verdict, Verdict::pass);
  // Without a long run the short ones are too coarse.
  const auto none =
      rows_of(plan_text("runs = [\"plain\", \"far\"]\n" + reference, "judge = \"from far\"\n"));
  ASSERT_EQ(none.size(), 1u);
  EXPECT_EQ(none[0].verdict, Verdict::coarse);
}

TEST(Verify, ComparesRuns) {
  const auto rows = rows_of(
      plan_text("runs = \"fast\"\nrelative_to = \"plain\"\nreference = 2\ntolerance = 1e-4\n"));
  EXPECT_EQ(rows[0].verdict, Verdict::pass);
  EXPECT_NEAR(rows[0].measured, 2.0, 1e-4);
}

// 300 and 600 cm/s.
TEST(Verify, JudgesTheMeanOfRunsAndTellsTheirScatter) {
  const std::string both = "runs = [\"plain\", \"fast\"]\nmean = true\n";
  const auto rows = rows_of(plan_text(both + "reference = 450\ntolerance = 1e-4\n"));
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].verdict, Verdict::pass);
  EXPECT_EQ(rows[0].run, "mean of 2 runs, standard deviation 2.1e+02 cm/s");
  const auto ratio = rows_of(plan_text("runs = \"fast\"\nrelative_to = [\"plain\", \"fast\"]\n"));
  EXPECT_NEAR(ratio[0].measured, 600.0 / 450.0, 1e-4);
}

TEST(Verify, GivesTheCurvesOfAPlot) {
  const std::string check = "runs = [\"plain\", \"fast\"]\nreference = 600\ntolerance = 0.01\n";
  EXPECT_TRUE(findings_of(plan_text(check)).curves.empty());
  const auto curves = findings_of(plan_text(check, "plot = true\n")).curves;
  ASSERT_EQ(curves.size(), 1u);
  EXPECT_EQ(curves[0].runs, (std::vector<std::string>{"plain", "fast"}));
  ASSERT_EQ(curves[0].series.size(), 2u);
  EXPECT_NEAR(curves[0].series[0].value.back(), 3.0, 1e-3);  // m/s, where the table has cm/s
  EXPECT_NEAR(curves[0].series[1].value.back(), 6.0, 1e-3);
  EXPECT_NEAR(*curves[0].reference, 6.0, 1e-12);
  EXPECT_EQ(curves[0].unit, "m/s");
}

TEST(Verify, TakesAPictureAtItsTime) {
  std::string plan = plan_text("runs = \"plain\"\n");
  EXPECT_TRUE(findings_of(plan).images.empty());
  plan.replace(plan.find("name = \"plain\""), 14, "name = \"plain\"\npicture = \"0.05 ms\"");
  const auto images = findings_of(plan).images;
  ASSERT_EQ(images.size(), 1u);
  EXPECT_EQ(images[0].run, "plain");
  EXPECT_GE(images[0].frame.time, 0.05e-3);
  EXPECT_LT(images[0].frame.time, 0.1e-3);
}

TEST(Verify, SkipsLongRunsByDefault) {
  const std::string runs = "runs = [\"plain\", \"far\"]\n";
  EXPECT_EQ(rows_of(plan_text(runs)).size(), 1u);
  EXPECT_EQ(rows_of(plan_text(runs), true).size(), 2u);
  EXPECT_TRUE(rows_of(plan_text("runs = \"far\"\n")).empty());
}

TEST(Verify, MakesTheRequestedRunsOnly) {
  const std::string plan = plan_text("runs = [\"plain\", \"far\"]\n");
  const EmbeddedText texts[] = {{"flight/case", flight}, {"flight/reference", plan}};
  auto cases = read_verification_cases(texts, {});
  EXPECT_FALSE(cases[0].keep_runs({"nobody"}));
  ASSERT_TRUE(cases[0].keep_runs({"far"}));
  const auto rows = verify(cases[0], false, [](const std::string&, double) {}).rows;
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].run, "far");
}

TEST(Verify, AFailedRunFailsItsRows) {
  std::string plan = plan_text("runs = \"plain\"\n");
  plan.replace(plan.find("name = \"plain\""), 14, "name = \"plain\"\noverride.time.end = \"-1 s\"");
  const auto rows = rows_of(plan);
  EXPECT_EQ(rows[0].verdict, Verdict::fail);
  EXPECT_NE(rows[0].problem.find("time.end"), std::string::npos) << rows[0].problem;
}

TEST(Verify, RefusesPlansWithMistakes) {
  EXPECT_THROW(rows_of(plan_text("runs = \"nobody\"\n")), std::logic_error);
  EXPECT_THROW(rows_of(plan_text("runs = \"plain\"\nreference = 3\n")), std::logic_error);
  EXPECT_THROW(rows_of(plan_text("runs = \"plain\"\ntolarance = 3\n")), std::logic_error);
  for (const char* judge : {"from far", "each", "fro"})
    EXPECT_THROW(rows_of(plan_text("runs = \"plain\"\n", fmt::format("judge = \"{}\"\n", judge))),
                 std::logic_error)
        << judge;
}

TEST(Verify, RefinementDividesSpacings) {
  PlannedRun run;
  run.name = "finer";
  run.case_text = std::string(flight);
  run.refinement = 2.0;
  EXPECT_DOUBLE_EQ(run.description().bodies[0].spacing, 0.001);
}

// The speeds of the three runs are 3, 6 and 9 m/s.
TEST(Verify, AnExponentIsJudgedInPlaceOfItsRuns) {
  const auto rows =
      rows_of(plan_text("runs = [\"plain\", \"fast\", \"far\"]\nexponent_over = [1, 4, 9]\n"
                        "reference = 0.5\ntolerance = 0.03"),
              true);
  ASSERT_EQ(rows.size(), 1u);
  // The speeds go with the square roots of 1, 4 and 9.
  EXPECT_NEAR(rows[0].measured, 0.5, 1e-4);
  EXPECT_EQ(rows[0].unit, "1");
  EXPECT_EQ(rows[0].run, "exponent over 3 runs");
  EXPECT_EQ(rows[0].verdict, Verdict::pass);
}

TEST(Verify, AnExponentNeedsAllOfItsRuns) {
  const auto plan = plan_text(
      "runs = [\"plain\", \"fast\", \"far\"]\nexponent_over = [1, 4, 9]\n"
      "reference = 0.5\ntolerance = 0.03");
  EXPECT_TRUE(rows_of(plan).empty());
}

TEST(Verify, AnExponentHasANumberForEachRun) {
  EXPECT_THROW(rows_of(plan_text("runs = [\"plain\", \"fast\"]\nexponent_over = [1, 2, 3]")),
               std::logic_error);
}

TEST(Verify, TheScatterOfAMeasurementWidensItsTolerance) {
  const auto verdict_with = [](const std::string& scatter) {
    return rows_of(plan_text("runs = \"plain\"\nreference = 280\ntolerance = 0.01" + scatter))
        .at(0)
        .verdict;
  };
  EXPECT_EQ(verdict_with(""), Verdict::fail);
  EXPECT_EQ(verdict_with("\nscatter = 19.9"), Verdict::fail);
  EXPECT_EQ(verdict_with("\nscatter = 20.1"), Verdict::pass);
}

TEST(Verify, TheIntervalSpansTheValuesOfItsRuns) {
  const auto rows =
      rows_of(plan_text("runs = \"fast\"\ninterval = [\"plain\", \"far\"]\nat_most = 650"), true);
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_NEAR(rows[0].measured, 600.0, 0.01);
  EXPECT_NEAR(rows[0].low.value(), 300.0, 0.01);
  EXPECT_NEAR(rows[0].high.value(), 900.0, 0.01);
  EXPECT_EQ(rows[0].verdict, Verdict::pass);
}

// The section of the page of experiments of a plan with one check.
std::string experiment_section(const std::string& judgement) {
  const std::string plan = plan_text(judgement);
  const EmbeddedText texts[] = {{"flight/case", flight}, {"flight/reference", plan}};
  const VerificationCase entry = read_verification_cases(texts, {}).at(0);
  return to_markdown(entry, findings_of(plan), TableKind::experiments, "");
}

TEST(VerifyTable, ExperimentsTellWhatWasCalibrated) {
  EXPECT_THAT(
      experiment_section("runs = \"plain\"\nreference = 290\ntolerance = 0.01\nscatter = 15\n"
                         "calibrated = true"),
      testing::HasSubstr("| plain | 290 ± 15 cm/s | 300 cm/s | +3% | 1% | calibrated | pass |"));
}

TEST(VerifyTable, ExperimentsTellTheRangeAndWhatIsOnlyReported) {
  EXPECT_THAT(experiment_section("runs = \"plain\"\ninterval = \"fast\"\nat_least = 250"),
              testing::HasSubstr("| plain | >= 250 cm/s | 300 (300 to 600) cm/s | - | - |"));
  EXPECT_THAT(experiment_section("runs = \"plain\""),
              testing::HasSubstr("| plain | - | 300 cm/s | - | - |"));
}

TEST(VerifyTable, JsonHasTheRow) {
  const auto rows = rows_of(plan_text("runs = \"plain\"\nreference = 300\ntolerance = 0.01"));
  const auto json = nlohmann::json::parse(to_json(rows));
  EXPECT_TRUE(json["passed"].get<bool>());
  EXPECT_EQ(json["rows"][0]["case"], "flight");
  EXPECT_EQ(json["rows"][0]["verdict"], "pass");
  EXPECT_NEAR(json["rows"][0]["measured"].get<double>(), 300.0, 0.01);
  EXPECT_TRUE(json["rows"][0]["at_least"].is_null());
}

TEST(VerifyTable, ThePageSaysWhereARowHolds) {
  const std::string plan = plan_text("runs = \"plain\"\nreference = 300\ntolerance = 0.01");
  const EmbeddedText texts[] = {{"flight/case", flight}, {"flight/reference", plan}};
  const VerificationCase entry = read_verification_cases(texts, {}).at(0);
  Findings findings = findings_of(plan);
  const auto row_of = [&] { return to_markdown(entry, findings, TableKind::theory, ""); };
  EXPECT_THAT(row_of(), testing::HasSubstr("| pass | written |"));
  EXPECT_THAT(row_of(), testing::Not(testing::HasSubstr("Elsewhere")));
  findings.elsewhere["flight"] = "mirrored";
  findings.rows[0].holds_in.push_back("mirrored");
  EXPECT_THAT(row_of(), testing::HasSubstr("| pass | written, elsewhere |"));
  EXPECT_THAT(row_of(), testing::HasSubstr("Elsewhere: mirrored.\n"));
  findings.rows[0].placement = "mirrored";
  findings.rows[0].verdict = Verdict::fail;
  findings.rows[0].holds_in = {};
  EXPECT_THAT(row_of(), testing::HasSubstr("cm/s (elsewhere) |"));
  EXPECT_THAT(row_of(), testing::HasSubstr("| FAIL | nowhere |"));
  findings.rows[0].verdict = Verdict::reported;
  EXPECT_THAT(row_of(), testing::HasSubstr("| reported | - |"));
}

}  // namespace
}  // namespace kerf
