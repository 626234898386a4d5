// SPDX-License-Identifier: Apache-2.0
// New and repeated runs, and their entries in study.db.
#include "study/study_runs.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <atomic>
#include <cmath>
#include <csignal>
#include <thread>

#include "core/error.hpp"
#include "output/files.hpp"
#include "study/boundary.hpp"
#include "support/temporary_folder.hpp"
#include "synthetic.hpp"

namespace kerf {
namespace {

using testing::HasSubstr;

// Ends runs at once with the given results.
class InstantExecutor : public Executor {
 public:
  std::function<JobEnd(const Job&)> end = [](const Job&) { return JobEnd{}; };
  std::vector<std::string> ran;
  std::size_t stop_after = 1000;

  void run(const std::vector<Job>& jobs, JobWatcher& watcher) override {
    std::vector<Job> queue(jobs.begin(), jobs.end());
    while (!queue.empty()) {
      const Job job = queue.front();
      queue.erase(queue.begin());
      if (ran.size() >= stop_after && watcher.look({job})) return;
      watcher.started(job);
      ran.push_back(job.id);
      const JobEnd how = end(job);
      if (how.exit_code == 0 && how.signal == 0) {
        make_folder(job.folder);
        write_file(
            job.folder / "result.json",
            R"({"wall_time": 8.0, "cut_through": true, "front_depth": 0.004, "balance": {"mass": 1},
                       "kerf": {"depth": 0.003, "lag": null, "top": {"width": 0.002}}})");
      }
      if (watcher.ended(job, how)) queue.push_back(job);
    }
  }
  int side_by_side() const override { return 2; }
};

class StudyRunsTest : public testing::Test {
 protected:
  StudyRuns laboratory(bool retry = false) {
    return {folder_.path(), maker_, database_, executor_, {nullptr, [this] { return signal_; }},
            retry};
  }
  static std::vector<Trial> speeds(std::initializer_list<double> values) {
    std::vector<Trial> trials;
    for (const double value : values) trials.push_back({{{{"jet.jet.speed", value}}, {}}, 0, 1.0});
    return trials;
  }

  test::TemporaryFolder folder_;
  CaseMaker maker_{test::plan_of("[vary]\n\"jet.jet.speed\" = [\"1 m/s\"]\n")};
  StudyDatabase database_{folder_ / "study.db"};
  InstantExecutor executor_;
  int signal_ = 0;
};

TEST_F(StudyRunsTest, ARepeatedRequestRunsOnce) {
  laboratory().run(speeds({1.0, 2.0, 2.0}));
  EXPECT_EQ(executor_.ran.size(), 2u);
  const auto outcomes = laboratory().run(speeds({2.0, 3.0, 1.0}));
  EXPECT_EQ(executor_.ran.size(), 3u);
  ASSERT_EQ(outcomes.size(), 3u);
  for (const Outcome& outcome : outcomes) EXPECT_FALSE(outcome.failed);
  EXPECT_EQ(outcomes[0].metrics.at("front_depth"), 0.004);
  EXPECT_EQ(outcomes[0].metrics.at("kerf.top.width"), 0.002);
  EXPECT_EQ(outcomes[0].metrics.at("cut_through"), 1.0);
  EXPECT_EQ(outcomes[0].metrics.count("kerf.lag"), 0u);
  EXPECT_EQ(outcomes[0].metrics.count("balance.mass"), 0u);
}

// One of three runs was made by an earlier start, in 8 s: the two others take 16 s, although
// finding the first took no time.
TEST_F(StudyRunsTest, ARunThatWasFoundFinishedHasItsOwnTime) {
  laboratory().run(speeds({1.0}));
  executor_.stop_after = 1;  // looks at each run
  StudyProgress first;
  StudyRuns runs(folder_.path(), maker_, database_, executor_,
                 {[&](const StudyProgress& now) {
                    if (now.total == 3 && first.total == 0) first = now;
                  },
                  nullptr},
                 false);
  runs.run(speeds({1.0, 2.0, 3.0}));
  ASSERT_EQ(first.ended, 1u);
  EXPECT_NEAR(seconds_left(first, first.share, 1e-3), 16.0, 1e-9);
  EXPECT_NEAR(seconds_left(first, 0.0, 1e-3), 16.0, 1e-9);
  StudyProgress untimed;
  untimed.total = 4;
  untimed.share = 0.5;
  EXPECT_NEAR(seconds_left(untimed, 0.25, 10.0), 20.0, 1e-9) << "a quarter took 10 s";
  EXPECT_TRUE(std::isinf(seconds_left(untimed, 0.5, 10.0)));
}

// A grid with settings that no case can have names all of them, and looks as if it had not begun.
TEST_F(StudyRunsTest, SettingsWithoutAValidCaseAreRefusedTogetherBeforeAnyRun) {
  StudyRuns runs = laboratory();
  std::string message;
  try {
    runs.run(speeds({1.0, -2.0, 3.0, -4.0, -4.0}));
  } catch (const UserError& error) {
    message = error.what();
  }
  EXPECT_THAT(message, testing::StartsWith("2 settings of the study have no valid case"));
  EXPECT_THAT(message, HasSubstr("with jet.jet.speed = -2 m/s"));
  EXPECT_THAT(message, HasSubstr("with jet.jet.speed = -4 m/s"));
  EXPECT_TRUE(executor_.ran.empty());
  EXPECT_TRUE(runs.asked().empty());
  EXPECT_TRUE(database_.runs().empty());
}

TEST_F(StudyRunsTest, AFailedRunStopsNoOtherAndIsNotRepeated) {
  executor_.end = [this](const Job& job) {
    if (executor_.ran.size() != 1) return JobEnd{};
    write_file(job.output, "Starting\nkerf: error: a value is not a number.\n");
    return JobEnd{3, 0, ""};
  };
  const auto outcomes = laboratory().run(speeds({1.0, 2.0, 3.0}));
  EXPECT_EQ(executor_.ran.size(), 3u);
  EXPECT_TRUE(outcomes[0].failed);
  EXPECT_EQ(outcomes[0].error, "kerf: error: a value is not a number.");
  EXPECT_FALSE(outcomes[1].failed);
  executor_.end = [](const Job&) { return JobEnd{}; };
  EXPECT_TRUE(laboratory().run(speeds({1.0}))[0].failed);
  EXPECT_EQ(executor_.ran.size(), 3u);
  EXPECT_FALSE(laboratory(true).run(speeds({1.0}))[0].failed);
  EXPECT_EQ(executor_.ran.size(), 4u);
}

TEST_F(StudyRunsTest, ACrashedRunIsRepeatedOnce) {
  int crashes = 1;
  executor_.end = [&](const Job&) { return crashes-- > 0 ? JobEnd{0, SIGSEGV, ""} : JobEnd{}; };
  EXPECT_FALSE(laboratory().run(speeds({1.0}))[0].failed);
  EXPECT_EQ(executor_.ran.size(), 2u);
  executor_.end = [](const Job&) { return JobEnd{0, SIGSEGV, ""}; };
  const Outcome outcome = laboratory().run(speeds({2.0}))[0];
  EXPECT_THAT(outcome.error, HasSubstr("signal 11"));
  EXPECT_EQ(executor_.ran.size(), 4u);
}

TEST_F(StudyRunsTest, InterruptedRunsAreRepeated) {
  const ResolvedCase resolved = maker_.make(speeds({1.0})[0]);
  database_.add(resolved, speeds({1.0})[0]);
  database_.mark_started(resolved.id);
  laboratory().run(speeds({1.0}));
  EXPECT_EQ(executor_.ran, std::vector<std::string>{resolved.id});
  EXPECT_EQ(database_.find(resolved.id)->state, RunState::done);
}

// The kill of a study is no fault of the runs that end with it.
TEST_F(StudyRunsTest, ACrashAfterTheKillOfAnEarlierStudyIsTheFirst) {
  const ResolvedCase resolved = maker_.make(speeds({1.0})[0]);
  database_.add(resolved, speeds({1.0})[0]);
  for (int killed = 0; killed < 3; ++killed) database_.mark_started(resolved.id);
  int crashes = 1;
  executor_.end = [&](const Job&) { return crashes-- > 0 ? JobEnd{0, SIGKILL, ""} : JobEnd{}; };
  EXPECT_FALSE(laboratory().run(speeds({1.0}))[0].failed);
  EXPECT_EQ(executor_.ran.size(), 2u);
  EXPECT_EQ(database_.find(resolved.id)->state, RunState::done);
}

TEST_F(StudyRunsTest, AStopKeepsTheRemainingRunsPending) {
  signal_ = SIGTERM;
  executor_.stop_after = 2;
  EXPECT_THROW(laboratory().run(speeds({1.0, 2.0, 3.0, 4.0})), StudyStopped);
  signal_ = 0;
  laboratory().run(speeds({1.0, 2.0, 3.0, 4.0}));
  EXPECT_EQ(executor_.ran.size(), 4u);
}

TEST_F(StudyRunsTest, UnreadableResultsAreAFailure) {
  executor_.end = [](const Job& job) {
    make_folder(job.folder);
    write_file(job.folder / "result.json", "{ broken");
    return JobEnd{0, 0, ""};
  };
  class Torn : public Executor {
   public:
    void run(const std::vector<Job>& jobs, JobWatcher& watcher) override {
      for (const Job& job : jobs) {
        watcher.started(job);
        make_folder(job.folder);
        write_file(job.folder / "result.json", "{ broken");
        watcher.ended(job, {});
      }
    }
    int side_by_side() const override { return 1; }
  } has_broken_bonds;
  StudyRuns runs(folder_.path(), maker_, database_, has_broken_bonds, {}, false);
  const Outcome outcome = runs.run(speeds({1.0}))[0];
  EXPECT_TRUE(outcome.failed);
  EXPECT_THAT(outcome.error, HasSubstr("cannot be read"));
}

TEST_F(StudyRunsTest, TheDatabaseStoresAllValuesOfARun) {
  laboratory().run(speeds({2.5}));
  const StudyDatabase again(folder_ / "study.db");
  const RunRow row = again.runs().at(0);
  EXPECT_EQ(row.trial.setting.numbers.at("jet.jet.speed"), 2.5);
  EXPECT_EQ(row.trial.refinement, 1.0);
  EXPECT_EQ(row.spacing, 0.002);
  EXPECT_GT(row.memory, 0.0);
  EXPECT_EQ(row.attempts, 1);
  EXPECT_EQ(row.case_text, maker_.make(speeds({2.5})[0]).text);
  EXPECT_THAT(row.case_text, testing::HasSubstr("jet.jet.speed = 2.5 m/s"));  // in its title
  EXPECT_EQ(row.metrics.at("kerf.depth"), 0.003);
  for (const std::string& time : {row.made, row.started, row.ended}) EXPECT_EQ(time.size(), 20u);
}

TEST_F(StudyRunsTest, OneRunServesTwoKeys) {
  laboratory().run(speeds({5.0}));
  const ResolvedCase resolved = maker_.make(speeds({5.0})[0]);
  database_.add(resolved, {{{{"jet.jet.width", 0.004}}, {}}, 0, 1.0});
  EXPECT_EQ(database_.runs().size(), 1u);
  const auto numbers = database_.find(resolved.id)->trial.setting.numbers;
  EXPECT_EQ(numbers.at("jet.jet.speed"), 5.0);
  EXPECT_EQ(numbers.at("jet.jet.width"), 0.004);
  EXPECT_EQ(database_.find(resolved.id)->state, RunState::done);
}

TEST(StudyDatabase, NamesAFolderThatIsNotWritable) {
  EXPECT_THAT(test::message_of<UserError>([] { StudyDatabase("/proc/nowhere/study.db"); }),
              testing::AllOf(HasSubstr("/proc/nowhere/study.db"), HasSubstr("--out")));
}

// Reads the database several times; returns whether that succeeded.
bool looks_into(const std::filesystem::path& file) {
  try {
    for (int look = 0; look < 3; ++look) StudyDatabase(file).runs();
    return true;
  } catch (const UserError&) {
    return false;
  }
}

// A study starts while other processes read its database.
TEST(StudyDatabase, IsCreatedByConcurrentProcesses) {
  const test::TemporaryFolder folder;
  std::atomic<int> failures = 0;
  for (int round = 0; round < 50; ++round) {
    const auto file = folder / fmt::format("{}.db", round);
    std::vector<std::thread> programs;
    for (int program = 0; program < 4; ++program)
      programs.emplace_back([&] { failures += looks_into(file) ? 0 : 1; });
    for (std::thread& program : programs) program.join();
  }
  EXPECT_EQ(failures, 0);
}

RunRow verdict(double speed, double width, bool cuts) {
  RunRow row;
  row.state = RunState::done;
  row.trial.setting.numbers = {{"speed", speed}, {"width", width}};
  row.metrics["cut_through"] = cuts;
  return row;
}

// The model cuts if speed + width > 4.5, on a grid of integers: the boundary is between sums of 4
// and 5.
TEST(Boundary, LiesBetweenNeighboursWithDifferentResults) {
  std::vector<RunRow> runs;
  for (int speed = 1; speed <= 4; ++speed)
    for (int width = 1; width <= 4; ++width)
      runs.push_back(verdict(speed, width, speed + width > 4.5));
  std::vector<Axis> axes(2);
  axes[0].path.text = "speed";
  axes[1].path.text = "width";
  const auto crossings = cut_boundary(axes, runs);
  ASSERT_EQ(crossings.size(), 6u);
  for (const Crossing& crossing : crossings) {
    const double other = crossing.at.numbers.begin()->second;
    EXPECT_EQ(crossing.low + other, 4.0);
    EXPECT_EQ(crossing.high + other, 5.0);
    EXPECT_TRUE(crossing.cuts_above);
  }
}

}  // namespace
}  // namespace kerf
