// SPDX-License-Identifier: Apache-2.0
// The limit of a case: its plan, its bracket from a stated value outwards, and its interval.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>

#include "core/error.hpp"
#include "input/read.hpp"
#include "model/case.hpp"
#include "study/case_maker.hpp"
#include "study/limit_answer.hpp"
#include "study/limit_runs.hpp"
#include "study/read_condition.hpp"
#include "study/study_runs.hpp"
#include "support/temporary_folder.hpp"
#include "synthetic.hpp"

namespace kerf {
namespace {

using test::limit_of;
using test::limit_plan_of;
using test::speed_of;
using testing::AllOf;
using testing::HasSubstr;

std::string limit_refusal(const std::string& text, const LimitQuestion& question) {
  try {
    limit_plan_of(text, question);
  } catch (const UserError& error) {
    return error.what();
  }
  return "";
}

// A made-up response: the jet cuts from a speed on, after which the margin grows as 1 - v_0 / v.
test::SyntheticLaboratory limit_cutter(double threshold, int side_by_side) {
  return {[=](const Trial& trial) {
            const double speed = speed_of(trial);
            return std::map<std::string, double>{{"cut_through", speed >= threshold},
                                                 {"kerf.margin", 1.0 - threshold / speed}};
          },
          side_by_side};
}

// From 5 m/s outwards by factors of 2, k steps for a threshold a factor 2^k away, then a bisection
// of a bracket whose ends differ by a factor of 2.
TEST(Limit, IsFoundFromTheStatedValueOutwards) {
  const LimitPlan plan = limit_plan_of(test::small_case, limit_of("jet_speed"));
  const ThresholdGoal& goal = *plan.study.threshold;
  EXPECT_TRUE(goal.least);
  EXPECT_DOUBLE_EQ(*goal.start, 5.0);
  EXPECT_DOUBLE_EQ(goal.axis.values.front(), 5.0 / 32.0);
  EXPECT_DOUBLE_EQ(goal.axis.values.back(), 160.0);
  for (double threshold = 0.17; threshold < 155.0; threshold *= 1.13) {
    auto laboratory = limit_cutter(threshold, 1);
    const ThresholdAnswer answer = find_threshold(goal, {}, laboratory);
    ASSERT_EQ(answer.problem, "") << threshold;
    EXPECT_DOUBLE_EQ(speed_of(laboratory.asked.front()), 5.0);
    EXPECT_LT(answer.bracket.low, threshold);
    EXPECT_GE(answer.bracket.high, threshold);
    EXPECT_LE(answer.bracket.half_width(), 0.05 * answer.bracket.middle());
    const double steps = std::ceil(std::abs(std::log2(threshold / 5.0)) + 1e-12);
    const double halvings = std::ceil(std::log2(std::log(2.0) / std::log(1.05 / 0.95)));
    EXPECT_LE(answer.runs, 1 + std::max(1.0, steps) + halvings) << threshold;
  }
}

TEST(Limit, SaysWhereThereIsNone) {
  const LimitPlan plan = limit_plan_of(test::small_case, limit_of("jet_speed"));
  for (const double threshold : {0.01, 1000.0}) {
    auto laboratory = limit_cutter(threshold, 1);
    LimitAnswer answer;
    answer.threshold = find_threshold(*plan.study.threshold, {}, laboratory);
    ASSERT_TRUE(answer.threshold->holds_everywhere.has_value());
    EXPECT_EQ(*answer.threshold->holds_everywhere, threshold < 1.0);
    EXPECT_EQ(answer.threshold->runs, 6) << "5 m/s and five factors of 2";
    const std::string finding = describe_limit(plan, answer).finding;
    if (threshold < 1.0)
      EXPECT_THAT(finding, AllOf(HasSubstr("The jet cuts at every jet_speed down to 0.1562 m/s"),
                                 HasSubstr("Lower --from")));
    else
      EXPECT_THAT(finding, AllOf(HasSubstr("does not cut at any jet_speed up to 160 m/s, 32 "
                                           "times the stated 5 m/s"),
                                 HasSubstr("Raise --to")));
  }
}

// All runs of a feed are one task: the nozzle travels the path of the case.
TEST(Limit, KeepsThePathOfANozzleThatTravels) {
  const LimitPlan plan = limit_plan_of(test::machine_case, limit_of("feed"));
  const ThresholdGoal& goal = *plan.study.threshold;
  EXPECT_FALSE(goal.least);
  EXPECT_EQ(goal.condition.text(), "kerf.through_share >= 0.95");
  // The dwell of 1 ms is longer than the flight of the jet.
  EXPECT_NEAR(plan.end.path, 2.0 * 8e-3, 1e-12);
  const CaseMaker maker(plan.study);
  for (const double feed : {0.5, 2.0, 7.0}) {
    const Trial trial = with_end(plan, {{{{"machine.traverse_speed", feed}}, {}}, 0, 1.0});
    const Case made = parse_case(maker.make(trial).text, "made.toml");
    EXPECT_DOUBLE_EQ(made.jets.front().traverse[0], feed);
    EXPECT_NEAR(feed * (made.time.end - made.jets.front().dwell), 16e-3, 1e-9);
  }
}

TEST(Limit, RefusesWhatTheCaseDoesNotHave) {
  EXPECT_THAT(limit_refusal(test::small_case, limit_of("pressure")),
              AllOf(HasSubstr("my.toml: --of pressure"), HasSubstr("Allowed: feed, jet_speed"),
                    HasSubstr("[machine]")));
  EXPECT_THAT(limit_refusal(test::small_case, limit_of("standoff")), HasSubstr("no such limit"));
  EXPECT_THAT(limit_refusal(test::small_case, limit_of("feed")),
              AllOf(HasSubstr("(0, 0, 0) m/s"), HasSubstr("traverse = [\"10 mm/s\"")));
  EXPECT_THAT(limit_refusal(test::machine_case, limit_of("jet_speed")),
              AllOf(HasSubstr("Allowed: feed, pressure"), HasSubstr("Ask for the pressure")));
  EXPECT_THAT(limit_refusal(test::machine_case, limit_of("presure")),
              HasSubstr("Did you mean \"pressure\"?"));
  EXPECT_THAT(limit_refusal(test::machine_case, limit_of("body.block.spacing")),
              HasSubstr("states no body.block.spacing"));
  EXPECT_THAT(limit_refusal(test::machine_case, limit_of("machine.dwell")),
              HasSubstr("Add --find least or --find greatest"));
  EXPECT_THAT(limit_refusal(test::machine_case, limit_of("materials.curd.youngs_modulus")),
              HasSubstr("the case states no materials.curd.youngs_modulus"));
  const std::string unused = "[materials.gel]\nbase = \"liver\"\nfailure_strain = 0.3\n";
  EXPECT_THAT(
      limit_refusal(test::machine_case + unused, limit_of("materials.gel.failure_strain")),
      AllOf(HasSubstr("no body and no jet has the material \"gel\", so the key changes nothing"),
            HasSubstr("used are \"curd\", \"water\"")));
}

TEST(Limit, RefusesADepthBeyondTheThickness) {
  const std::string foam =
      read_file(std::string(KERF_SOURCE_DIR) + "/cases/cuts/foam-30mpa-1mps.toml");  // 5 mm thick
  LimitQuestion question = limit_of("feed");
  question.where = "kerf.depth >= 6 mm";
  EXPECT_THAT(limit_refusal(foam, question),
              AllOf(HasSubstr("kerf.depth >= 6 mm"), HasSubstr("Allowed: at most 5 mm")));
  question.where = "kerf.depth >= 4 mm";
  EXPECT_EQ(limit_plan_of(foam, question).study.threshold->condition.bound, 4e-3);
}

TEST(Limit, RefusesRangesAndConditions) {
  LimitQuestion question = limit_of("pressure");
  question.from = "3";
  EXPECT_THAT(limit_refusal(test::machine_case, question),
              AllOf(HasSubstr("--from \"3\": a unit is missing"), HasSubstr("machine.pressure")));
  question.from = "90 kPa";
  question.to = "30 kPa";
  EXPECT_THAT(limit_refusal(test::machine_case, question), HasSubstr("Correct --from or --to"));
  question.from = question.to = "";
  for (const auto& [where, words] :
       {std::pair{"kerf.dept >= 3 mm", "there is no metric \"kerf.dept\""},
        {"kerf.depth > 3 mm", "METRIC >= VALUE"},
        {"kerf.depth >= 3", "a unit is missing"},
        {"kerf.margin >= a", "this is no number"}}) {
    question.where = where;
    EXPECT_THAT(limit_refusal(test::machine_case, question), HasSubstr(words)) << where;
  }
  EXPECT_DOUBLE_EQ(read_where("kerf.depth <= 5 mm", 2).bound, 0.005);
  EXPECT_FALSE(read_where("kerf.depth <= 5 mm", 2).at_least);
}

TEST(Limit, AKeyOfAMaterialHasAGreatestValue) {
  const LimitPlan plan =
      limit_plan_of(test::machine_case, limit_of("materials.curd.failure_strain"));
  EXPECT_FALSE(plan.study.threshold->least);
  EXPECT_DOUBLE_EQ(plan.stated, 0.05);
}

// With v(d) = v_0 + c d a second spacing finds v_0, and layouts extend the bracket.
TEST(Limit, NamesTheCausesOfItsInterval) {
  LimitQuestion question = limit_of("jet_speed");
  question.converge = true;
  question.tolerance = 0.005;
  question.most_runs = 200;
  const LimitPlan plan = limit_plan_of(test::small_case, question);
  const ThresholdGoal& goal = *plan.study.threshold;
  EXPECT_DOUBLE_EQ(goal.draft, std::sqrt(0.5)) << "the jet is two particles wide";
  EXPECT_EQ(goal.repeats, 3);
  const auto limit_at = [](const Trial& trial) {
    return 3.0 + 0.6 / trial.refinement + 0.1 * trial.repeat;
  };
  test::SyntheticLaboratory laboratory(
      [&](const Trial& trial) {
        return std::map<std::string, double>{{"cut_through", speed_of(trial) >= limit_at(trial)}};
      },
      1);
  const ThresholdAnswer answer = find_threshold(goal, {{}, 0, 1.0}, laboratory);
  ASSERT_EQ(answer.problem, "");
  const LimitCauses causes = causes_of(answer);
  const double bracket = 0.005 * 3.8;
  EXPECT_LE(causes.bracket, bracket);
  EXPECT_NEAR(*causes.layout, 0.2, 2.0 * bracket);
  // Each middle is off by half a bracket at most, which 1 / (r - 1) = 2.41 enlarges.
  EXPECT_NEAR(*causes.spacing, -0.6, 2.0 * 2.42 * bracket);
  EXPECT_LE(answer.stated.low, 3.0 + 2.0 * 3.42 * bracket);
  EXPECT_GE(answer.stated.high, 3.8);
}

RunRow limit_run(double speed, bool cuts, int repeat = 0) {
  RunRow row;
  row.id = fmt::format("{}-{}", speed, repeat);
  row.state = RunState::done;
  row.trial = {{{{"jet.jet.speed", speed}}, {}}, repeat, 1.0};
  row.metrics = {{"cut_through", cuts}, {"kerf.margin", cuts ? 0.25 : -0.5}, {"kerf.depth", 0.004}};
  return row;
}

TEST(Limit, SaysHowFarAnUnfinishedSearchIs) {
  const LimitPlan plan = limit_plan_of(test::small_case, limit_of("jet_speed"));
  LimitAnswer answer;
  answer.runs = {limit_run(5.0, false)};
  EXPECT_EQ(bracket_of(plan, answer.runs, {{}, 0, 1.0}), std::nullopt);
  EXPECT_EQ(describe_limit(plan, answer).finding, "not found yet");
  answer.runs.push_back(limit_run(10.0, true));
  answer.runs.push_back(limit_run(7.0, true, 1));  // another layout
  const auto bracket = bracket_of(plan, answer.runs, {{}, 0, 1.0});
  ASSERT_TRUE(bracket.has_value());
  EXPECT_DOUBLE_EQ(bracket->low, 5.0);
  EXPECT_DOUBLE_EQ(bracket->high, 10.0);
  EXPECT_THAT(describe_limit(plan, answer).finding, HasSubstr("between 5 m/s and 10 m/s"));
  // A third of the middle, halved to 0.05: log2(20 / 3) = 2.7 rounds; in three parts log3 = 1.7.
  EXPECT_EQ(rounds_left(*bracket, 0.05, 1), 3);
  EXPECT_EQ(rounds_left(*bracket, 0.05, 2), 2);
  EXPECT_EQ(rounds_left({9.9, 10.0}, 0.05, 1), 0);
}

TEST(Limit, TablePageAndJsonHaveTheSameTrials) {
  const LimitPlan plan = limit_plan_of(test::small_case, limit_of("jet_speed"));
  auto laboratory = limit_cutter(3.9, 1);
  LimitAnswer answer;
  answer.threshold = find_threshold(*plan.study.threshold, {}, laboratory);
  for (const Trial& trial : laboratory.asked)
    answer.runs.push_back(limit_run(speed_of(trial), speed_of(trial) >= 3.9));
  const auto json = limit_json(plan, answer);
  EXPECT_EQ(json.at("trials").size(), answer.runs.size());
  EXPECT_EQ(json.at("quantity"), "jet_speed");
  EXPECT_LT(json.at("low").get<double>(), 3.9);
  EXPECT_GE(json.at("high").get<double>(), 3.9);
  EXPECT_TRUE(json.at("causes").at("spacing").is_null());
  EXPECT_EQ(json.at("trials").at(0).at("holds"), true);
  EXPECT_DOUBLE_EQ(json.at("trials").at(0).at("margin"), 0.25);
  EXPECT_THAT(trial_line(plan, 1, answer.runs[0]), AllOf(HasSubstr("cuts"), HasSubstr("+25.0%")));
  const std::string page = limit_page(plan, answer);
  EXPECT_THAT(page, AllOf(HasSubstr("Least jet_speed that still cuts"), HasSubstr("<svg"),
                          HasSubstr("The stated 5 m/s is")));
}

// Reads the case of each job and fails where it is not valid.
class ReadingExecutor : public Executor {
 public:
  void run(const std::vector<Job>& jobs, JobWatcher& watcher) override {
    for (const Job& job : jobs) {
      watcher.started(job);
      JobEnd end{exit_run_failed, 0, "read"};
      try {
        read_case(job.case_file);
      } catch (const UserError& error) {
        end.problem = error.what();
      }
      watcher.ended(job, end);
    }
  }
  int side_by_side() const override { return 1; }
};

// A front that is at most 30 mm deep is asked for below a limit, which is the greatest speed.
TEST(Limit, AConditionThatHoldsEverywhereHasItsUnitAndNamesTheOtherLimit) {
  LimitQuestion question = limit_of("jet_speed");
  question.where = "front_depth <= 30 mm";
  const LimitPlan plan = test::limit_plan_of(test::small_case, question);
  ThresholdAnswer found;
  found.problem = "the condition holds everywhere";
  found.holds_everywhere = true;
  const LimitWords words = describe_limit(plan, {found, {}});
  EXPECT_THAT(words.question, HasSubstr("front_depth <= 30 mm"));
  EXPECT_THAT(words.finding, HasSubstr("front_depth <= 30 mm holds"));
  EXPECT_THAT(words.finding, HasSubstr("--find greatest"));
}

TEST(Limit, MeshesOfTheCaseAreBesideItsRuns) {
  const test::TemporaryFolder folder;
  const LimitPlan plan = plan_limit(
      std::filesystem::path(KERF_SOURCE_DIR) / "cases/machine/stl-part.toml", limit_of("pressure"));
  StudyDatabase database(folder / "study.db");
  const CaseMaker maker(plan.study);
  ReadingExecutor executor;
  StudyRuns runs(folder.path(), maker, database, executor, {}, false);
  const auto outcomes = runs.run({{}, {{{{"machine.pressure", 1e5}}, {}}, 0, 1.0}});
  for (const Outcome& outcome : outcomes) EXPECT_EQ(outcome.error, "read");
}

}  // namespace
}  // namespace kerf
