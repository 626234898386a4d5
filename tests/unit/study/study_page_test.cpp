// SPDX-License-Identifier: Apache-2.0
// The page of a study: its data, and its content without the script.
#include "study/study_page.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "output/files.hpp"
#include "report/viewer_files.hpp"
#include "study/axis_label.hpp"
#include "synthetic.hpp"

namespace kerf {
namespace {

using Json = nlohmann::ordered_json;
using testing::HasSubstr;
using testing::Not;

const std::string speeds_and_widths =
    "[vary]\n\"jet.jet.speed\" = { from = \"1 m/s\", to = \"5 m/s\", count = 5 }\n"
    "\"jet.jet.width\" = [\"4 mm\", \"6 mm\"]\n"
    "[model]\nform = \"threshold_linear\"\ndrive = \"jet.jet.speed\"\n";

RunRow finished_run(const std::string& id, double speed, double width, double depth) {
  RunRow result;
  result.id = id;
  result.trial.setting.numbers = {{"jet.jet.speed", speed}, {"jet.jet.width", width}};
  result.state = RunState::done;
  result.metrics = {{"cut_through", depth >= 0.006 ? 1.0 : 0.0},
                    {"kerf.depth", depth},
                    {"kerf.removed_volume", 1e-5},
                    {"dimension", 2.0}};
  return result;
}

StudyAnswers answers_of(const StudyPlan& plan) {
  StudyAnswers answers;
  for (int i = 0; i < 5; ++i)
    answers.runs.push_back(
        finished_run(fmt::format("run{}", i), 1.0 + i, 0.004, 0.002 * (i + 0.1 * (i % 2))));
  answers.runs.push_back(finished_run("bad", 5.0, 0.006, 0.0));
  answers.runs.back().state = RunState::failed;
  answers.runs.back().metrics.clear();
  answers.runs.back().error = "</script><b>broken</b>";
  answers.model = ReducedModel(*plan.model, model_data(*plan.model, 1.0, answers.runs));
  return answers;
}

TEST(StudyPage, HoldsStudyJsonAndTheUnitsOfEveryMetric) {
  const StudyPlan plan = test::plan_of(speeds_and_widths);
  const StudyAnswers answers = answers_of(plan);
  const Json data = study_page_data(plan, answers, StudyState::running);
  EXPECT_EQ(data.at("study"), Json::parse(study_json(plan, answers)));
  EXPECT_EQ(data.at("state"), "running");
  EXPECT_THAT(data.at("written").get<std::string>(), testing::EndsWith(" UTC"));
  EXPECT_EQ(data.at("units").at("kerf.depth"), "m");
  EXPECT_EQ(data.at("units").at("kerf.removed_volume"), "m2");
  EXPECT_EQ(data.at("units").at("cut_through"), "");
  EXPECT_EQ(data.at("labels").at("kerf.depth"), "depth of the kerf");
}

// Labels, units and explanations of settings are those of the schema.
TEST(StudyPage, NamesSettingsByTheSchema) {
  const StudyPlan plan = test::plan_of(speeds_and_widths);
  const Json data = study_page_data(plan, answers_of(plan), StudyState::ended);
  const Key& speed = *find_key("jet", "speed", {});
  EXPECT_EQ(data.at("labels").at("jet.jet.speed"), "speed");
  EXPECT_EQ(data.at("help").at("jet.jet.speed"), std::string(speed.sentence) + ".");
  for (const Json& key : data.at("study").at("keys")) {
    EXPECT_TRUE(data.at("labels").contains(key.at("key")));
    EXPECT_GT(data.at("help").at(key.at("key").get<std::string>()).get<std::string>().size(), 5u);
  }
  EXPECT_EQ(data.at("units").at("spacing"), find_key("body", "spacing", {})->unit);
}

TEST(StudyPage, TellsKeysOfOneNameApart) {
  const toml::table written = toml::parse(
      "dimension = 2\n[[jet]]\nname = \"upper\"\n[[jet]]\nname = \"lower_jet\"\n[[body]]\n"
      "name = \"block\"\nshape = { type = \"box\", maximum = [\"1 m\", \"2 m\"] }\n");
  const auto axis = [&](const char* path) {
    Axis made;
    made.path = find_key_path(path, written);
    EXPECT_EQ(made.path.problem, "");
    return made;
  };
  const std::vector<Axis> axes{axis("jet.upper.width"), axis("jet.lower_jet.width"),
                               axis("jet.upper.pulse_frequency"),
                               axis("body.block.shape.maximum.1")};
  EXPECT_EQ(axis_label(axes[0], axes), "width of jet upper");
  EXPECT_EQ(axis_label(axes[1], axes), "width of jet lower jet");
  EXPECT_EQ(axis_label(axes[2], axes), "pulse frequency");
  EXPECT_EQ(axis_label(axes[3], axes), "maximum y");
}

TEST(StudyPage, HoldsTheModelOverTheRangeOfItsData) {
  const StudyPlan plan = test::plan_of(speeds_and_widths);
  const StudyAnswers answers = answers_of(plan);
  ASSERT_EQ(answers.model->problem(), "");
  const Json points = study_page_data(plan, answers, StudyState::ended).at("model_points");
  ASSERT_GE(points.size(), 2u);
  const ModelRange range = answers.model->ranges().at("jet.jet.speed");
  EXPECT_DOUBLE_EQ(points.front().at("at").at("jet.jet.speed"), range.low);
  EXPECT_DOUBLE_EQ(points.back().at("at").at("jet.jet.speed"), range.high);
  for (const Json& point : points) {
    const double speed = point.at("at").at("jet.jet.speed");
    EXPECT_EQ(point.at("along"), "jet.jet.speed");
    EXPECT_DOUBLE_EQ(point.at("value"), answers.model->predict({{"jet.jet.speed", speed}}).value);
    EXPECT_LE(point.at("low").get<double>(), point.at("value").get<double>());
    EXPECT_GE(point.at("high").get<double>(), point.at("value").get<double>());
  }
}

TEST(StudyPage, HasNoExternalResourcesAndEscapesMessages) {
  const StudyPlan plan = test::plan_of(speeds_and_widths);
  const std::string page = study_page(plan, answers_of(plan), StudyState::ended);
  EXPECT_THAT(page, Not(HasSubstr("</script><b>")));
  EXPECT_THAT(page, HasSubstr("&lt;/script&gt;&lt;b&gt;broken"));
  for (const char* address : {"src=\"", "<link", "@import"})
    EXPECT_THAT(page, Not(HasSubstr(address)));
  EXPECT_EQ(page.find("kerf-study-data") != std::string::npos,
            !viewer_text("study_script").empty());
}

TEST(StudyPage, WithoutItsScriptHasAMapAndATable) {
  const StudyPlan plan = test::plan_of(speeds_and_widths);
  const auto runs = answers_of(plan).runs;
  const std::string drawn = static_map(plan, runs);
  EXPECT_THAT(drawn, HasSubstr("<a href=\"runs/run4/report.html\">"));
  EXPECT_THAT(drawn, HasSubstr("<title>failed</title>"));
  EXPECT_THAT(drawn, HasSubstr(">speed in m/s</text>"));
  EXPECT_THAT(drawn, HasSubstr(">width in mm</text>"));
  const std::string table = static_table(plan, runs);
  EXPECT_THAT(table, HasSubstr("not cut through</th><td>1 m/s</td><td>4 mm</td>"));
  EXPECT_THAT(table, HasSubstr("<a href=\"runs/run0/report.html\">report</a>"));
  const StudyPlan alone = test::plan_of("[vary]\n\"jet.jet.speed\" = [\"1 m/s\", \"2 m/s\"]\n");
  EXPECT_EQ(static_map(alone, runs), "");
}

TEST(StudyPage, IsRewrittenAfterRuns) {
  const StudyPlan plan = test::plan_of(speeds_and_widths);
  const auto folder = std::filesystem::path(testing::TempDir()) / "kerf_study_page";
  std::filesystem::create_directories(folder);
  StudyPageFile file(plan, folder);
  int asked = 0;
  const auto answers = [&] {
    ++asked;
    return answers_of(plan);
  };
  file.follow(0, 6, answers);  // at the start
  EXPECT_EQ(asked, 1);
  const std::string page = read_file(folder / "study.html");
  EXPECT_THAT(page, HasSubstr("runs/run0/report.html"));
  EXPECT_THAT(page, HasSubstr(answers_of(plan).model->formula()));  // also during the runs
  file.follow(0, 6, answers);                                       // no new runs
  file.follow(1, 6, answers);                                       // too soon
  EXPECT_EQ(asked, 1);
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace kerf
