// SPDX-License-Identifier: Apache-2.0
// The limits of a nozzle that moves in the runs: of all of its way, and of a way that is long
// enough.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "input/read.hpp"
#include "model/case.hpp"
#include "study/case_maker.hpp"
#include "study/limit_answer.hpp"
#include "study/metrics.hpp"
#include "synthetic.hpp"

namespace kerf {
namespace {

using testing::Contains;
using testing::HasSubstr;

LimitPlan plan_of_way(const std::string& text, const std::string& quantity) {
  return test::limit_plan_of(text, test::limit_of(quantity));
}

// A nozzle that moves has cut with its first hole, whatever quantity is searched.
TEST(LimitOfWay, AsksForAllTheWayOfANozzleThatTravels) {
  for (const char* quantity : {"feed", "pressure", "orifice", "standoff"}) {
    const LimitPlan plan = plan_of_way(test::machine_case, quantity);
    EXPECT_EQ(plan.study.threshold->condition.text(), "kerf.through_share >= 0.95") << quantity;
    EXPECT_THAT(describe_limit(plan, {}).question, HasSubstr("(kerf.through_share >= 0.95)"));
    EXPECT_THAT(plan.held, Contains(HasSubstr("cut-through alone is reached with the first hole")));
    RunRow row;
    row.state = RunState::done;
    row.metrics = {{"cut_through", 1.0}, {"kerf.through_share", 0.03}};
    EXPECT_EQ(trial_verdict(plan, row), "cuts in part");
    row.metrics["cut_through"] = 0.0;
    EXPECT_EQ(trial_verdict(plan, row), "does not cut");
  }
  EXPECT_EQ(plan_of_way(test::small_case, "jet_speed").study.threshold->condition.text(),
            "cut-through");
}

constexpr const char* travelling_sheet = R"(title = "sheet"
dimension = 2
quality = "draft"
[machine]
pressure = "8 MPa"
orifice_diameter = "0.5 mm"
standoff = "3 mm"
traverse_speed = "50 m/s"
[workpiece]
material = "fat"
size = ["20 mm", "1 mm"]
)";

// Where the case states no end, each feed has that of a run of its own, in which water that the
// nozzle has left behind comes through.
TEST(LimitOfWay, EachFeedHasTheEndThatItNeeds) {
  const LimitPlan plan = plan_of_way(travelling_sheet, "feed");
  EXPECT_TRUE(plan.end.follows);
  const CaseMaker maker(plan.study);
  for (const double feed : {50.0, 70.0, 100.0}) {
    std::string own = travelling_sheet;
    own.replace(own.find("50 m/s"), 6, fmt::format("{} m/s", feed));
    const Trial trial = with_end(plan, {{{{"machine.traverse_speed", feed}}, {}}, 0, 1.0});
    EXPECT_EQ(parse_case(maker.make(trial).text, "made.toml").time.end,
              parse_case(own, "own.toml").time.end)
        << feed;
  }
}

// A nozzle that travels against an axis has the feeds of its mirror image, and moves as stated.
TEST(LimitOfWay, IsTheSameInEitherDirection) {
  const auto with = [](const char* feed) {
    std::string text = test::small_case;
    text.replace(text.find("end = \"2 ms\""), 12, "end = \"8 ms\"");
    return text + "traverse = [\"" + feed + "\", \"0 m/s\"]\n";
  };
  const LimitPlan right = plan_of_way(with("0.5 m/s"), "feed");
  const LimitPlan left = plan_of_way(with("-0.5 m/s"), "feed");
  EXPECT_EQ(left.stated, 0.5);
  EXPECT_EQ(left.stated, right.stated);
  EXPECT_EQ(left.end.path, right.end.path);
  EXPECT_EQ(left.study.threshold->axis.values, right.study.threshold->axis.values);
  const CaseMaker maker_left(left.study), maker_right(right.study);
  const std::string key = "jet.jet.traverse.0";
  for (const double feed : {0.25, 0.5, 1.0}) {
    const Trial trial = with_end(left, {{{{key, feed}}, {}}, 0, 1.0});
    const Case made = parse_case(maker_left.make(trial).text, "left.toml");
    const Case mirrored = parse_case(maker_right.make(trial).text, "right.toml");
    EXPECT_DOUBLE_EQ(made.jets.front().traverse[0], -feed);
    EXPECT_DOUBLE_EQ(mirrored.jets.front().traverse[0], feed);
    EXPECT_EQ(made.time.end, mirrored.time.end);
    EXPECT_THAT(made.title, HasSubstr(fmt::format("traverse.0 = {:g} m/s", -feed)));
  }
}

// The way of 1.5 mm is shorter than three times a lag of 0.6 mm, and longer than that of 0.4 mm.
TEST(LimitOfWay, SaysWhereTheWayIsTooShort) {
  const LimitPlan plan = plan_of_way(test::machine_case, "feed");
  for (const double lag : {0.4e-3, 0.6e-3}) {
    RunRow row;
    row.state = RunState::done;
    row.trial.setting.numbers["machine.traverse_speed"] = 3.0;
    row.metrics = {{"end_time", plan.end.start + 0.5e-3}, {"kerf.lag", lag}};
    EXPECT_EQ(short_way_sentence(plan, {row}).empty(), lag < 0.5e-3);
  }
}

// Solid that left the domain whole may have been cut or not: what rests on it is undecided.
TEST(LimitOfWay, RestsNotOnSolidThatLeftTheDomain) {
  const LimitPlan plan = plan_of_way(test::machine_case, "feed");
  const ThresholdGoal& goal = *plan.study.threshold;
  RunRow row;
  row.state = RunState::done;
  row.trial.setting.numbers["machine.traverse_speed"] = 4.0;
  row.metrics = {{"cut_through", 1.0}, {"dimension", 2.0}, {"kerf.through_share", 1.0}};
  const auto expect = [&](const char* verdict, bool holds) {
    EXPECT_EQ(trial_verdict(plan, row), verdict);
    EXPECT_EQ(goal.condition.holds(row.metrics), holds);
    EXPECT_EQ(goal.condition.margin(row.metrics) >= 0.0, holds);
    EXPECT_EQ(left_whole_sentence(plan, {row}).empty(), trial_verdict(plan, row) != "undecided");
  };
  expect("cuts", true);
  row.metrics["validity.left_whole"] = 0.36;  // which the share does not count
  expect("cuts", true);
  row.metrics["kerf.through_share"] = 0.6;
  expect("undecided", false);
  EXPECT_THAT(left_whole_sentence(plan, {row}),
              testing::AllOf(HasSubstr("4 m/s (36%)"), HasSubstr("wider [domain]"),
                             HasSubstr("may raise the limit")));
  EXPECT_EQ(undecided_sentence(plan, {row}), "");
  LimitAnswer answer;
  answer.runs = {row};
  answer.threshold.emplace().problem = "it holds nowhere";
  answer.threshold->holds_everywhere = false;
  EXPECT_EQ(describe_limit(plan, answer).finding, "undecided at every feed tried");
  row.metrics["validity.left_whole"] = 0.04;  // the share is not enough with it
  expect("cuts in part", false);
  row.metrics["validity.left_whole"] = 0.46;
  row.metrics["dimension"] = 3.0;  // where it may have lain beside the path
  expect("cuts in part", false);
}

TEST(LimitOfWay, TakesTheShareThatLeftFromTheResult) {
  const Metrics metrics = read_metrics(
      R"({"dimension": 2, "validity": [{"name": "left_whole", "state": "warning", "value": 0.36}]})");
  EXPECT_EQ(left_whole(metrics), 0.36);
  EXPECT_EQ(left_whole(read_metrics(R"({"validity": []})")), 0.0);
}

}  // namespace
}  // namespace kerf
