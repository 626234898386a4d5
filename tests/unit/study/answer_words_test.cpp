// SPDX-License-Identifier: Apache-2.0
// What terminal, study.json and page say of an optimum and of a calibration across a jump.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "study/study_answers.hpp"
#include "synthetic.hpp"

namespace kerf {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

Setting at_speed(double speed) {
  Setting setting;
  setting.numbers["jet.jet.speed"] = speed;
  return setting;
}

TEST(AnswerWords, AnOptimumNamesItsNeighboursTheRangeAndOtherOptima) {
  const StudyPlan plan = test::plan_of(
      "[vary]\n\"jet.jet.speed\" = { from = \"2 m/s\", to = \"10 m/s\" }\n[search]\n"
      "find = \"minimum\"\nmetric = \"kerf.specific_energy\"\n");
  StudyAnswers answers;
  OptimumAnswer optimum;
  optimum.setting = at_speed(4.0);
  optimum.value = 1000.0;
  optimum.low = 950.0;
  optimum.high = 1050.0;
  optimum.neighbours = {{3.5, 4.25}};
  answers.optimum = optimum;
  const std::string single = answers_text(describe_answers(plan, answers));
  EXPECT_THAT(single, AllOf(HasSubstr("Minimum of kerf.specific_energy"),
                            HasSubstr("between 950 J/m3 and 1050 J/m3"),
                            HasSubstr("jet.jet.speed between 3.5 m/s and 4.25 m/s"),
                            HasSubstr("searched was jet.jet.speed from 2 m/s to 10 m/s"),
                            HasSubstr("a lower value between the runs is not excluded")));
  answers.optimum->others = {{at_speed(8.5), 1020.0, plan.refinement}};
  const auto described = describe_answers(plan, answers);
  EXPECT_THAT(answers_text(described),
              AllOf(HasSubstr("Local minimum of kerf.specific_energy"), Not(HasSubstr("Minimum")),
                    HasSubstr("another local minimum of the runs: 1020 J/m3 at jet.jet.speed")));
  const auto& json = described.front().members;
  EXPECT_EQ(json.at("local"), true);
  EXPECT_EQ(json.at("neighbours").at("jet.jet.speed").at("low"), 3.5);
  EXPECT_EQ(json.at("ranges").at("jet.jet.speed").at("high"), 10.0);
  EXPECT_EQ(json.at("others").at(0).at("value"), 1020.0);
}

TEST(AnswerWords, AnOptimumThatWasNotFoundHasNoValue) {
  const StudyPlan plan = test::plan_of(
      "[vary]\n\"jet.jet.speed\" = { from = \"2 m/s\", to = \"10 m/s\" }\n[search]\n"
      "find = \"minimum\"\nmetric = \"kerf.specific_energy\"\n");
  StudyAnswers answers;
  answers.optimum.emplace().problem = "cut-through held in none of 3 runs. Widen the ranges";
  answers.optimum->value = answers.optimum->low = answers.optimum->high = std::nan("");
  answers.optimum->setting = at_speed(4.0);
  const auto described = describe_answers(plan, answers);
  EXPECT_THAT(
      answers_text(described),
      AllOf(HasSubstr("with cut-through: not found. cut-through held in none of 3 runs"),
            HasSubstr("searched was jet.jet.speed from 2 m/s to 10 m/s\n"), Not(HasSubstr("nan"))));
  EXPECT_THAT(described.front().members.dump(), HasSubstr("\"value\":null"));
}

TEST(AnswerWords, AJumpIsNamed) {
  const StudyPlan plan = test::plan_of(
      "[calibrate]\nkey = \"materials.curd.fracture_energy\"\nfrom = \"1 J/m2\"\n"
      "to = \"100 J/m2\"\nmetric = \"kerf.depth\"\nmeasured = \"2 mm\"\nuncertainty = \"0.1 mm\"\n"
      "at.\"jet.jet.speed\" = \"5 m/s\"\n");
  StudyAnswers answers;
  CalibrationAnswer calibration;
  calibration.value = 6.0;
  calibration.low = 5.9;
  calibration.high = 6.1;
  answers.calibration = calibration;
  EXPECT_EQ(describe_answers(plan, answers).front().members.at("jump"), nullptr);
  answers.calibration->jump = MetricJump{5.9, 6.1, 0.0, 0.004};
  const auto described = describe_answers(plan, answers);
  EXPECT_THAT(answers_text(described),
              HasSubstr("kerf.depth jumps from 0 mm at 5.9 J/m2 to 4 mm at 6.1 J/m2 across the "
                        "measured 2 mm"));
  EXPECT_EQ(described.front().members.at("jump").at("at_high"), 0.004);
}

TEST(AnswerWords, AnIntervalThatIsOpenAtAnEndIsABound) {
  const StudyPlan plan = test::plan_of(
      "[calibrate]\nkey = \"materials.curd.fracture_energy\"\nfrom = \"1 J/m2\"\n"
      "to = \"100 J/m2\"\nmetric = \"kerf.depth\"\nmeasured = \"2 mm\"\nuncertainty = \"0.1 mm\"\n"
      "at.\"jet.jet.speed\" = \"5 m/s\"\n");
  CalibrationAnswer calibration;
  calibration.value = 6.0;
  calibration.low = 5.0;
  calibration.high = 100.0;
  StudyAnswers answers;
  const auto text = [&](bool below, bool above) {
    calibration.is_open_below = below;
    calibration.is_open_above = above;
    answers.calibration = calibration;
    return answers_text(describe_answers(plan, answers));
  };
  EXPECT_THAT(text(false, false), HasSubstr(": 6 J/m2, between 5 J/m2 and 100 J/m2"));
  EXPECT_THAT(text(false, true), HasSubstr(": at least 5 J/m2, determined only from below"));
  EXPECT_THAT(text(true, false), HasSubstr(": at most 100 J/m2, determined only from above"));
  EXPECT_THAT(text(true, true), HasSubstr(": not determined"));
  EXPECT_EQ(describe_answers(plan, answers).front().members.at("open_above"), true);
}

}  // namespace
}  // namespace kerf
