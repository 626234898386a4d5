// SPDX-License-Identifier: Apache-2.0
// The greatest feed of a nozzle that stands in the run, from made-up runs.
#include "study/feed_by_exposure.hpp"
#include "input/read.hpp"
#include "machine/simulated_piece.hpp"
#include "model/case.hpp"
#include "study/case_maker.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "study/limit_answer.hpp"
#include "synthetic.hpp"

namespace kerf {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

constexpr const char* standing_case = R"(title = "foam"
dimension = 3
quality = "draft"
[machine]
pressure = "30 MPa"
orifice_diameter = "0.15 mm"
standoff = "3 mm"
traverse_speed = "35 m/s"
motion = "standing"
[workpiece]
material = "polyurethane-foam"
size = ["300 mm", "5 mm", "200 mm"]
)";

LimitPlan feed_plan(bool converge = false) {
  LimitQuestion question = test::limit_of("feed");
  question.converge = converge;
  return test::limit_plan_of(standing_case, question);
}

// All runs of a search stand, each for the exposure of the stated feed under its own jet: a search
// from any stated pressure makes the same runs.
TEST(FeedByExposure, EachPressureHasItsOwnExposure) {
  const auto made = [](const std::string& stated, double pressure) {
    std::string text = standing_case;
    text.replace(text.find("30 MPa\""), 6, stated);
    const LimitPlan plan = test::limit_plan_of(text, test::limit_of("pressure"));
    const Trial trial = with_end(plan, {{{{"machine.pressure", pressure}}, {}}, 0, 1.0});
    return parse_case(CaseMaker(plan.study).make(trial).text, "made.toml");
  };
  for (const double pressure : {2e6, 30e6, 200e6}) {
    const Case low = made("20 MPa", pressure), high = made("60 MPa", pressure);
    EXPECT_EQ(low.machine->motion, NozzleMotion::standing);
    EXPECT_EQ(low.time.end, high.time.end) << pressure;
    const Jet& jet = low.jets[0];
    const double exposure = exposure_time(*low.machine, jet, 3);
    const double whole = (jet.standoff + low.workpiece->size[1]) / jet.speed + exposure;
    EXPECT_GT(low.time.end,
              std::min(whole, 2.0 * passage_time(jet, low.workpiece->size[1])) - 1e-12);
  }
}

using Metrics = std::map<std::string, double>;

// Returns the answer of a search all of whose runs have these metrics.
LimitAnswer answer_of(const LimitPlan& plan, const Metrics& metrics) {
  test::SyntheticLaboratory laboratory([&](const Trial&) { return metrics; }, 1);
  LimitAnswer answer;
  answer.threshold = feed_by_exposure(plan, laboratory);
  for (const Trial& trial : laboratory.asked) {
    RunRow row;
    row.state = RunState::done;
    row.trial = trial;
    row.metrics = metrics;
    answer.runs.push_back(row);
  }
  return answer;
}

TEST(FeedByExposure, TheSpeedOfTheJetBoundsWhatIsPossible) {
  const LimitPlan plan = feed_plan();
  ASSERT_TRUE(plan.by_exposure);
  // V = sqrt(2 p / rho) less the losses of the orifice and the compression of water.
  EXPECT_NEAR(plan.jet_speed, std::sqrt(2.0 * 30e6 / 1000.0), 0.1 * plan.jet_speed);
  const LimitAnswer answer = answer_of(plan, {{"exposure.greatest_feed", 41.0},
                                              {"exposure.possible_feed", 794.0},
                                              {"exposure.cuts", 1.0}});
  EXPECT_EQ(answer.threshold->stated.low, 41.0);
  EXPECT_EQ(answer.threshold->stated.high, plan.jet_speed);
  const LimitWords words = describe_limit(plan, answer);
  EXPECT_THAT(words.finding, HasSubstr("certain up to 41 m/s, possible up to 2"));
  EXPECT_THAT(words.notes, testing::Contains(HasSubstr("bounded by the speed of the jet")));
}

TEST(FeedByExposure, WhatIsCarriedOnIsNotCertain) {
  const LimitPlan plan = feed_plan(true);
  const Metrics carried{{"exposure.greatest_feed", 41.0}, {"exposure.possible_feed", 80.0},
                        {"exposure.cuts", 1.0},           {"exposure.exponent", 0.9},
                        {"kerf.margin", -0.77},           {"cut_through", 0.0}};
  const LimitWords words = describe_limit(plan, answer_of(plan, carried));
  EXPECT_THAT(words.finding, AllOf(HasSubstr("expected up to 41 m/s, possible up to 80 m/s"),
                                   Not(HasSubstr("certain"))));
  EXPECT_THAT(words.notes, testing::Contains(HasSubstr("ended with 23% of the thickness broken")));
  EXPECT_THAT(words.notes, testing::Contains("The stated 35 m/s is expected to cut."));
}

TEST(FeedByExposure, NoFeedIsCertainOfWhatHoldsAtRestOnly) {
  const LimitPlan plan = feed_plan();
  const char* reasons[] = {"cracked_ahead", "gave_way"};
  const char* notes[] = {"A crack parted the workpiece ahead", "The workpiece gave way: the jet"};
  for (const std::size_t n : {0u, 1u}) {
    Metrics metrics{{"exposure.greatest_feed", 0.0},
                    {"exposure.possible_feed", 80.0},
                    {"exposure.cuts", 0.0},
                    {"cracked_ahead", 0.0},
                    {"gave_way", 0.0},
                    {"cut_through", 1.0}};
    metrics[reasons[n]] = 1.0;
    metrics["exposure.may_cut"] = n == 0 ? 1.0 : 0.0;
    const LimitAnswer answer = answer_of(plan, metrics);
    EXPECT_EQ(trial_verdict(plan, answer.runs.front()), n == 0 ? "may cut" : "does not cut");
    const LimitWords words = describe_limit(plan, answer);
    EXPECT_THAT(words.finding, HasSubstr("certain at no feed, possible up to 80 m/s"));
    EXPECT_THAT(words.notes, testing::Contains(HasSubstr(notes[n])));
    EXPECT_THAT(words.notes, Not(testing::Contains(HasSubstr(notes[1 - n]))));
    EXPECT_THAT(words.notes, Not(testing::Contains(HasSubstr("the cut is certain"))));
  }
}

TEST(FeedByExposure, NoFeedIsCertainThatARunDenies) {
  const LimitPlan plan = feed_plan();
  const LimitAnswer answer = answer_of(
      plan,
      {{"exposure.greatest_feed", 41.0}, {"exposure.possible_feed", 80.0}, {"exposure.cuts", 0.0}});
  EXPECT_EQ(answer.threshold->stated.low, 0.0);
  const LimitWords words = describe_limit(plan, answer);
  EXPECT_THAT(words.finding, HasSubstr("certain at no feed, possible up to 80 m/s"));
  EXPECT_THAT(words.notes[0], HasSubstr("The stated 35 m/s may cut"));
}

// A pressure is sought at which the stated feed is certain to cut: that it is not tells nothing of
// whether it cuts.
TEST(FeedByExposure, WhatIsNotCertainIsNotDenied) {
  const LimitPlan plan = test::limit_plan_of(standing_case, test::limit_of("standoff"));
  RunRow row;
  row.state = RunState::done;
  row.trial.setting.numbers["machine.standoff"] = 3e-3;
  row.metrics = {
      {"exposure.cuts", 0.0}, {"exposure.may_cut", 1.0}, {"exposure.greatest_feed", 0.0}};
  EXPECT_EQ(trial_verdict(plan, row), "may cut");
  EXPECT_THAT(trial_line(plan, 1, row), Not(HasSubstr("-100")));
  row.metrics["exposure.may_cut"] = 0.0;
  EXPECT_EQ(trial_verdict(plan, row), "does not cut");
  LimitAnswer answer;
  answer.threshold.emplace();
  answer.threshold->problem = "none";
  answer.threshold->holds_everywhere = false;
  const LimitWords words = describe_limit(plan, answer);
  EXPECT_THAT(words.question, HasSubstr("for certain (exposure.greatest_feed >= 35 m/s)"));
  EXPECT_THAT(words.finding, AllOf(HasSubstr("certain at no standoff tried, from 3 mm down to"),
                                   Not(HasSubstr("does not cut"))));
}

}  // namespace
}  // namespace kerf
