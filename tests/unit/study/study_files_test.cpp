// SPDX-License-Identifier: Apache-2.0
// The files that a study writes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "study/run_table.hpp"
#include "study/study_answers.hpp"
#include "synthetic.hpp"

namespace kerf {
namespace {

using testing::HasSubstr;
using testing::Not;

const std::string map =
    "[vary]\n\"jet.jet.speed\" = [\"100 cm/s\", \"2 m/s\"]\n"
    "\"materials.curd.criterion\" = [\"crack_band\", \"principal_strain\"]\n";

RunRow row(const std::string& id, double speed, RunState state) {
  RunRow result;
  result.id = id;
  result.trial.setting = {{{"jet.jet.speed", speed}}, {{"materials.curd.criterion", "crack_band"}}};
  result.state = state;
  return result;
}

StudyAnswers two_runs() {
  StudyAnswers answers;
  answers.runs = {row("aa", 1.0, RunState::done), row("bb", 2.0, RunState::failed)};
  answers.runs[0].metrics = {{"kerf.depth", 0.004}, {"cut_through", 1.0}};
  answers.runs[1].error = "kerf: error: two lines,\nand a \"quote\"";
  return answers;
}

TEST(StudyFiles, TheCsvIsQuotedByRfc4180) {
  const std::string csv = study_csv(test::plan_of(map), two_runs().runs);
  EXPECT_THAT(csv, testing::StartsWith("id,state,jet.jet.speed (m/s),materials.curd.criterion,"));
  EXPECT_THAT(csv, HasSubstr("aa,done,1,crack_band,"));
  EXPECT_THAT(csv, HasSubstr(",runs/aa/report.html,\r\n"));
  EXPECT_THAT(csv, HasSubstr(",\"kerf: error: two lines,\nand a \"\"quote\"\"\"\r\n"));
}

TEST(StudyFiles, TheCsvHasTheUnitsOfItsMetrics) {
  const std::string csv = study_csv(
      test::plan_of(
          "metrics = [\"fractured_mass\", \"kerf.removal_rate\", \"kerf.splash.mass\"]\n" +
          std::string(map)),
      {});
  for (const char* heading :
       {"kerf.removed_volume (m2)", "fractured_mass (kg/m)", "kerf.removal_rate (m2/s)",
        "kerf.splash.mass (kg/m)", "kerf.specific_energy (J/m3)", "kerf.margin,"})
    EXPECT_THAT(csv, HasSubstr(heading));
}

// A setting is in the result of a run too. Neither it nor a metric has two columns.
TEST(StudyFiles, AMetricThatIsVariedHasOneColumn) {
  const EmbeddedText templates[] = {{"machine", test::machine_case}};
  const std::string base = "base = \"machine\"\n";
  const std::string more = R"([vary]
"machine.pressure" = { from = "20 kPa", to = "90 kPa" }
[search]
find = "minimum"
metric = "machine.pressure"
)";
  for (const std::string& text :
       {base + more, base + "metrics = [\"machine.pressure\", \"front_depth\"]\n" + more}) {
    const StudyPlan plan = parse_study(text, "my-study.toml", templates);
    RunRow run;
    run.state = RunState::done;
    run.trial.setting.numbers["machine.pressure"] = 5e4;
    run.metrics = {{"machine.pressure", 5e4}};
    std::set<std::string> names;
    for (const RunColumn& column : run_columns(plan, {run}))
      EXPECT_TRUE(names.insert(column.name).second) << column.name;
    EXPECT_FALSE(study_hdf5(plan, {run}).empty());
    StudyAnswers answers;
    answers.runs = {run};
    answers.optimum.emplace();
    answers.optimum->setting = run.trial.setting;
    answers.optimum->value = 5e4;
    EXPECT_THAT(answers_text(describe_answers(plan, answers)), HasSubstr("5e+04 Pa"));
  }
}

TEST(StudyFiles, TheReadableTableHasTheUnitsOfTheStudy) {
  const std::string text = study_text(test::plan_of(map), two_runs().runs);
  EXPECT_THAT(text, HasSubstr("100 cm/s"));
  EXPECT_THAT(text, HasSubstr("cut through"));
  EXPECT_THAT(text, HasSubstr("failed"));
}

TEST(StudyFiles, TheJsonHoldsKeysRunsAndBoundary) {
  const StudyPlan plan = test::plan_of(map);
  StudyAnswers answers = two_runs();
  answers.boundary = {{"jet.jet.speed", 1.0, 2.0, true, {}}};
  const auto json = nlohmann::json::parse(study_json(plan, answers));
  EXPECT_EQ(json.at("format"), 1);
  EXPECT_EQ(json.at("keys").at(0).at("unit"), "m/s");
  EXPECT_EQ(json.at("keys").at(0).at("shown_unit"), "cm/s");
  EXPECT_DOUBLE_EQ(json.at("keys").at(0).at("shown_factor"), 0.01);
  EXPECT_EQ(json.at("keys").at(1).at("kind"), "words");
  EXPECT_EQ(json.at("runs").at(0).at("setting").at("jet.jet.speed"), 1.0);
  EXPECT_EQ(json.at("runs").at(0).at("report"), "runs/aa/report.html");
  EXPECT_TRUE(json.at("runs").at(1).at("report").is_null());
  EXPECT_EQ(json.at("runs").at(1).at("state"), "failed");
  EXPECT_EQ(json.at("boundary").at(0).at("cuts_above"), true);
  EXPECT_EQ(json.count("search"), 0u);
}

TEST(StudyFiles, MissingAnswersAreNull) {
  const StudyPlan plan = test::plan_of(
      "[search]\nfind = \"least\"\nkey = \"jet.jet.speed\"\nfrom = \"1 m/s\"\nto = \"2 m/s\"\n");
  StudyAnswers answers;
  answers.threshold = ThresholdAnswer{};
  answers.threshold->problem = "it was not there";
  const auto json = nlohmann::json::parse(study_json(plan, answers));
  EXPECT_TRUE(json.at("search").at("value").is_null());
  EXPECT_EQ(json.at("search").at("problem"), "it was not there");
  EXPECT_THAT(answers_text(describe_answers(plan, answers)),
              HasSubstr("not found. it was not there"));
}

// Drafts with half the threshold do not indicate the error: the answer states so.
TEST(StudyFiles, ReportsTooCoarseDrafts) {
  const StudyPlan plan = test::plan_of(
      "[search]\nfind = \"least\"\nkey = \"jet.jet.speed\"\nfrom = \"1 m/s\"\nto = \"9 m/s\"\n");
  StudyAnswers answers;
  ThresholdAnswer answer;
  answer.bracket = answer.stated = {3.9, 4.1};
  answer.layouts = {answer.bracket};
  answer.draft = Bracket{1.9, 2.1};
  answer.resolution_change = 2.0;
  answers.threshold = answer;
  EXPECT_THAT(answers_text(describe_answers(plan, answers)), HasSubstr("are too coarse"));
  answers.threshold->draft = Bracket{3.8, 4.0};
  answers.threshold->resolution_change = 0.1;
  EXPECT_THAT(answers_text(describe_answers(plan, answers)), Not(HasSubstr("are too coarse")));
}

}  // namespace
}  // namespace kerf
