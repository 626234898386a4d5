// SPDX-License-Identifier: Apache-2.0
// The runs of a limit are those of the case with each value, and what they leave open is told.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "input/read.hpp"
#include "input/write_used.hpp"
#include "model/case.hpp"
#include "study/boundary.hpp"
#include "study/case_maker.hpp"
#include "study/limit_answer.hpp"
#include "study/metrics.hpp"
#include "study/run_table.hpp"
#include "synthetic.hpp"

namespace kerf {
namespace limit_of_own_runs {

using test::limit_of;
using test::limit_plan_of;
using test::speed_of;
using testing::Contains;
using testing::Each;
using testing::HasSubstr;
using testing::Not;

// A nozzle at rest over a [workpiece]; every choice but the quantities is that of the program.
std::string sheet_of(const std::string& pressure, const std::string& orifice,
                     const std::string& standoff) {
  return fmt::format(R"(title = "sheet"
dimension = 2
quality = "draft"
[machine]
pressure = "{}"
orifice_diameter = "{}"
standoff = "{}"
[workpiece]
material = "fat"
size = ["100 mm", "2 mm"]
)",
                     pressure, orifice, standoff);
}

// The same over a [[body]].
std::string block_of(const std::string& pressure, const std::string& orifice,
                     const std::string& standoff) {
  const std::string sheet = sheet_of(pressure, orifice, standoff);
  return sheet.substr(0, sheet.find("[workpiece]")) + R"(position = ["0 mm", "6 mm"]
[[body]]
name = "block"
material = "gelatin-10"
shape = { type = "box", minimum = ["-20 mm", "0 mm"], maximum = ["20 mm", "6 mm"] }
)";
}

Trial trial_of(const LimitPlan& plan, double value) {
  return {{{{plan.study.threshold->axis.name(), value}}, {}}, 0, 1.0};
}

// The end, the spacings, the part that is simulated and the domain are those that kerf run chooses.
TEST(LimitOfOwnRuns, EachRunIsThatOfTheCaseWithItsValue) {
  for (const auto text_of : {sheet_of, block_of}) {
    const std::string stated = text_of("5 MPa", "1 mm", "3 mm");
    for (const auto& [quantity, value, own] :
         {std::tuple{"pressure", 3e5, text_of("300000 Pa", "1 mm", "3 mm")},
          {"orifice", 1.25e-4, text_of("5 MPa", "0.000125 m", "3 mm")},
          {"orifice", 0.003, text_of("5 MPa", "0.003 m", "3 mm")},
          {"standoff", 0.048, text_of("5 MPa", "1 mm", "0.048 m")}}) {
      const LimitPlan plan = limit_plan_of(stated, limit_of(quantity));
      EXPECT_TRUE(plan.end.follows);
      Case made = parse_case(CaseMaker(plan.study).make(trial_of(plan, value)).text, "made.toml");
      const Case expected = parse_case(own, "own.toml");
      made.title = expected.title;
      EXPECT_EQ(write_used(made), write_used(expected)) << quantity << " " << value;
    }
  }
}

// The value that is written first decides nothing but where the search starts.
TEST(LimitOfOwnRuns, TheStatedValueDoesNotMatter) {
  for (const auto text_of : {sheet_of, block_of}) {
    std::vector<std::string> ids;
    for (const char* pressure : {"5 MPa", "1 MPa", "40 bar"}) {
      const LimitPlan plan = limit_plan_of(text_of(pressure, "1 mm", "3 mm"), limit_of("pressure"));
      ids.push_back(CaseMaker(plan.study).make(trial_of(plan, 3e5)).id);
    }
    EXPECT_THAT(ids, Each(ids.front()));
  }
}

TEST(LimitOfOwnRuns, AnEndThatTheCaseStatesIsThatOfAllRuns) {
  const LimitPlan plan = limit_plan_of(
      sheet_of("5 MPa", "1 mm", "3 mm") + "[time]\nend = \"1 ms\"\n", limit_of("pressure"));
  EXPECT_FALSE(plan.end.follows);
  EXPECT_THAT(plan.held, Contains("Each run lasts 1 ms."));
  for (const double value : {3e5, 5e6, 9e7})
    EXPECT_EQ(parse_case(CaseMaker(plan.study).make(trial_of(plan, value)).text, "m.toml").time.end,
              1e-3);
}

// A spacing that is written stays, and with it a thin jet has few particles across. What is derived
// allows that down to one.
TEST(LimitOfOwnRuns, ASpacingThatTheCaseStatesIsThatOfAllRuns) {
  std::string text = sheet_of("5 MPa", "1 mm", "3 mm") + "spacing = \"0.1 mm\"\n";
  text.insert(text.find("[workpiece]"), "spacing = \"0.1 mm\"\n");
  const LimitPlan plan = limit_plan_of(text, limit_of("orifice"));
  for (double value = 1e-3; value > 2e-4; value *= 0.5)
    EXPECT_EQ(CaseMaker(plan.study).make(trial_of(plan, value)).spacing, 1e-4) << value;
}

RunRow run_of(double speed, const std::map<std::string, double>& metrics) {
  RunRow row;
  row.state = RunState::done;
  row.trial.setting.numbers["jet.jet.speed"] = speed;
  row.metrics = metrics;
  return row;
}

const std::string still_cutting(still_cutting_metric), not_reached(not_reached_metric);

TEST(LimitOfOwnRuns, TellsTheRunsThatWereStillCutting) {
  for (const char* find : {"least", "greatest"}) {
    LimitQuestion question = limit_of("jet_speed");
    question.find = find;
    const LimitPlan plan = limit_plan_of(test::small_case, question);
    LimitAnswer answer;
    answer.runs = {run_of(2.0, {{"cut_through", 0.0}}),
                   run_of(3.0, {{"cut_through", 0.0}, {still_cutting, 1.0}}),
                   run_of(4.0, {{"cut_through", 0.0}, {still_cutting, 1.0}}),
                   run_of(5.0, {{"cut_through", 1.0}})};
    EXPECT_EQ(trial_verdict(plan, answer.runs[0]), "does not cut");
    EXPECT_EQ(trial_verdict(plan, answer.runs[1]), "undecided");
    EXPECT_EQ(trial_verdict(plan, answer.runs[3]), "cuts");
    const bool least = plan.study.threshold->least;
    EXPECT_THAT(
        describe_limit(plan, answer).notes,
        Contains(testing::AllOf(HasSubstr("2 runs are undecided"),
                                HasSubstr(least ? "may lower the limit" : "may raise the limit"))));
    const auto json = limit_json(plan, answer);
    EXPECT_EQ(json.at("undecided"), 2);
    EXPECT_EQ(json.at("trials").at(0).at("undecided"), false);
    EXPECT_EQ(json.at("trials").at(1).at("undecided"), true);
    EXPECT_EQ(json.at("trials").at(1).at("holds"), false);
    answer.runs.resize(1);
    EXPECT_THAT(describe_limit(plan, answer).notes, Not(Contains(HasSubstr("undecided"))));
  }
}

// A study tells them too, but for runs whose time is the exposure of the stated feed.
TEST(LimitOfOwnRuns, StudiesTellTheRunsThatWereStillCutting) {
  const RunRow open = run_of(3.0, {{"cut_through", 0.0}, {still_cutting, 1.0}});
  EXPECT_EQ(verdict_of(open), RunVerdict::undecided);
  EXPECT_EQ(verdict_of(run_of(3.0, {{"cut_through", 0.0}})), RunVerdict::not_cut_through);
  EXPECT_EQ(verdict_of(run_of(3.0, {{"cut_through", 1.0}})), RunVerdict::cut_through);
  EXPECT_EQ(
      verdict_of(run_of(3.0, {{"cut_through", 0.0}, {"exposure.cuts", 0.0}, {still_cutting, 1.0}})),
      RunVerdict::not_cut_through);
  EXPECT_THAT(too_soon_sentence({}, {open, run_of(2.0, {{"cut_through", 0.0}})}),
              HasSubstr("1 run is undecided"));
  EXPECT_EQ(too_soon_sentence({}, {run_of(2.0, {{"cut_through", 0.0}})}), "");
}

// The water comes from 3 m/s on, and cuts from 3.9 m/s on, or at no speed that was tried.
TEST(LimitOfOwnRuns, ARunThatNoWaterReachesDecidesNothing) {
  const LimitPlan plan = limit_plan_of(test::small_case, limit_of("jet_speed"));
  for (const double arrives : {3.0, 4.5, 200.0}) {
    test::SyntheticLaboratory laboratory(
        [&](const Trial& trial) {
          const double speed = speed_of(trial);
          std::map<std::string, double> metrics{{"cut_through", speed >= 3.9}};
          if (speed < arrives) metrics[not_reached] = 1.0;
          return metrics;
        },
        1);
    const ThresholdAnswer found = find_threshold(*plan.study.threshold, {}, laboratory);
    EXPECT_THAT(found.problem, HasSubstr("No water has come to the workpiece within the run"));
    EXPECT_THAT(found.problem,
                HasSubstr(arrives > 5.0 ? "jet.jet.speed = 5 m/s" : "jet.jet.speed = 2.5 m/s"));
    EXPECT_FALSE(found.holds_everywhere.has_value());
    EXPECT_TRUE(found.layouts.empty());
    EXPECT_EQ(found.runs, static_cast<int>(laboratory.asked.size()));
  }
}

TEST(LimitOfOwnRuns, ARunThatNoWaterReachesHasAStateOfItsOwn) {
  const LimitPlan plan = limit_plan_of(test::small_case, limit_of("jet_speed"));
  const RunRow row = run_of(2.0, {{"cut_through", 0.0}, {"kerf.margin", -1.0}, {not_reached, 1.0}});
  EXPECT_EQ(verdict_of(row), RunVerdict::not_reached);
  EXPECT_EQ(trial_verdict(plan, row), "not reached");
  LimitAnswer answer;
  answer.runs = {row, run_of(5.0, {{"cut_through", 1.0}})};
  EXPECT_EQ(bracket_of(plan, answer.runs, {{}, 0, 1.0}), std::nullopt);
  EXPECT_TRUE(cut_boundary({plan.study.threshold->axis}, answer.runs).empty());
  const auto trial = limit_json(plan, answer).at("trials").at(0);
  EXPECT_EQ(trial.at("not_reached"), true);
  EXPECT_TRUE(trial.at("holds").is_null());
  EXPECT_TRUE(trial.at("margin").is_null());
  answer.runs[0].metrics.erase(not_reached);
  EXPECT_TRUE(bracket_of(plan, answer.runs, {{}, 0, 1.0}).has_value());
  EXPECT_EQ(cut_boundary({plan.study.threshold->axis}, answer.runs).size(), 1u);
}

TEST(LimitOfOwnRuns, WarnsOfFewParticlesAcrossTheJet) {
  const LimitPlan plan = limit_plan_of(test::small_case, limit_of("jet_width"));
  const auto row = [](double width, double across) {
    RunRow run = run_of(0.0, {{"cut_through", 0.0}, {"jet_resolution", across}});
    run.trial.setting.numbers = {{"jet.jet.width", width}};
    return run;
  };
  EXPECT_EQ(thin_jet_sentence(plan, {row(4e-3, 8.0), row(2.5e-3, 5.0)}), "");
  EXPECT_THAT(thin_jet_sentence(plan, {row(4e-3, 8.0), row(2e-3, 4.0), row(1e-3, 2.0)}),
              HasSubstr("Fewer than 5 particles lie across the jet at 2 mm (4), 1 mm (2)"));
}

TEST(LimitOfOwnRuns, SaysInPlainDigitsHowFarTheStatedValueIs) {
  const LimitPlan plan = limit_plan_of(test::small_case, limit_of("jet_speed"));
  LimitAnswer answer;
  for (const auto& [limit, words] : {std::pair{4.0, "The stated 5 m/s is 25% above the limit."},
                                     {0.4, "The stated 5 m/s is 12.5 times the limit."},
                                     {0.01, "The stated 5 m/s is 500 times the limit."},
                                     {0.0004, "The stated 5 m/s is 12500 times the limit."},
                                     {8.0, "The stated 5 m/s is 37.5% below the limit."}}) {
    answer.threshold.emplace();
    answer.threshold->bracket = answer.threshold->stated = {limit, limit};
    answer.threshold->layouts = {answer.threshold->bracket};
    EXPECT_THAT(describe_limit(plan, answer).notes, Contains(words));
  }
}

TEST(LimitOfOwnRuns, FlagsOfARunAreAmongItsMetrics) {
  const std::string flag = R"({{"validity": [{{"name": "mach"}}, {{"name": "{}"}}]}})";
  const Metrics cutting = read_metrics(fmt::format(fmt::runtime(flag), "still_cutting"));
  EXPECT_TRUE(was_still_cutting(cutting));
  EXPECT_FALSE(is_not_reached(cutting));
  const Metrics dry = read_metrics(fmt::format(fmt::runtime(flag), "not_reached"));
  EXPECT_TRUE(is_not_reached(dry));
  EXPECT_EQ(dry.size(), 1u);
}

}  // namespace limit_of_own_runs
}  // namespace kerf
