// SPDX-License-Identifier: Apache-2.0
#include "app/run_loop.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <sstream>

#include "core/error.hpp"
#include "input/write_used.hpp"
#include "output/series.hpp"
#include "support/fake_simulation.hpp"
#include "support/results.hpp"
#include "support/temporary_folder.hpp"

namespace kerf {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::FakeSimulation;
using test::message_of;
using testing::AllOf;
using testing::HasSubstr;
using BeforeStep = std::function<void(std::uint64_t)>;

struct Killed {};  // not a UserError: the loop cannot clean up after it, as after kill -9

class Run : public testing::Test {
 protected:
  RunLoopSettings settings(const std::string& name, Existing existing = Existing::refuse) {
    RunLoopSettings settings;
    settings.description = description_;
    settings.case_name = "fake";
    settings.case_text = write_used(description_);
    settings.folder = folder_ / name;
    settings.existing = existing;
    settings.quiet = true;
    settings.resume_command = "kerf run fake.toml --resume";
    return settings;
  }
  RunEnd run(const RunLoopSettings& settings, const BeforeStep& before_step = {}) {
    return RunLoop(settings,
                   [&](const Case& description) {
                     return std::make_unique<FakeSimulation>(description, before_step);
                   })
        .run();
  }
  json result(const std::string& name) {
    return json::parse(read_file(folder_ / (name + "/result.json")));
  }
  test::TemporaryFolder folder_;
  Case description_ = test::fake_case();
};

TEST_F(Run, WritesEveryDocumentedFile) {
  EXPECT_EQ(run(settings("a")).signal, 0);
  EXPECT_EQ(test::names_in(folder_ / "a"),
            (std::set<std::string>{"case.used.toml", "log.txt", "series.csv", "frames", "pictures",
                                   "fake.vtkhdf.series", "fake.paraview.py", "result.json",
                                   "report.html", "checkpoint.h5"}));
  EXPECT_EQ(read_file(folder_ / "a/case.used.toml"), write_used(description_));
  const json numbers = result("a");
  EXPECT_EQ(numbers.at("end_time"), 0.01);
  std::uint64_t limited = 0;
  for (const auto& [name, steps] : numbers.at("time_step_limits").items())
    limited += steps.get<std::uint64_t>();
  EXPECT_EQ(limited, numbers.at("steps").get<std::uint64_t>());
  EXPECT_EQ(numbers.at("pair_interactions"), 100.0 * numbers.at("steps").get<double>());
}

TEST_F(Run, ALogForProgramsHasAnObjectInEachLine) {
  RunLoopSettings chosen = settings("a");
  chosen.log_format = LogFormat::json;
  chosen.description.title = "a \"quoted\" \\ title";
  run(chosen);
  EXPECT_FALSE(fs::exists(folder_ / "a/log.txt"));
  std::istringstream lines(read_file(folder_ / "a/log.jsonl"));
  std::vector<json> entries;
  for (std::string line; std::getline(lines, line);) entries.push_back(json::parse(line));
  ASSERT_GT(entries.size(), 2u);
  EXPECT_THAT(entries.front().at("message").get<std::string>(), HasSubstr("a \"quoted\" \\ title"));
  for (const json& entry : entries) {
    EXPECT_EQ(entry.at("level"), "info");
    EXPECT_THAT(entry.at("time").get<std::string>(),
                testing::MatchesRegex(
                    "[0-9]{4}-[0-9]{2}-[0-9]{2}T[0-9:]{8}\\.[0-9]{3}[+-][0-9]{2}:[0-9]{2}"));
  }
}

TEST_F(Run, WritesAtTheFirstStepAtOrAfterEachDueTime) {
  run(settings("a"));
  // The oracle is the same steps without the loop.
  FakeSimulation simulation(description_);
  std::vector<double> expected{0.0};
  for (double due = 1e-3; !simulation.finished();) {
    simulation.advance();
    if (simulation.time() < due && !simulation.finished()) continue;
    expected.push_back(simulation.time());
    due += 1e-3;
  }
  const json series = json::parse(read_file(folder_ / "a/fake.vtkhdf.series"));
  std::vector<double> times;
  for (const json& file : series.at("files")) times.push_back(file.at("time"));
  EXPECT_EQ(times, expected);
  EXPECT_EQ(result("a").at("pictures").size(), 3u);  // two requested ones, and the end
  const SeriesTable table(folder_ / "a/series.csv", description_);
  EXPECT_EQ(table.rows(), 51u);
  EXPECT_EQ(table.numbers("time").back(), 0.01);
}

TEST_F(Run, OutputDoesNotChangeTheComputation) {
  run(settings("a"));
  description_.output.frame_times = {0.0033};
  description_.output.picture_times.clear();
  description_.output.series_interval = 1.7e-3;
  description_.output.checkpoint_interval = 1e-9;
  run(settings("b"));
  EXPECT_EQ(result("a").at("steps"), result("b").at("steps"));
  const SeriesTable a(folder_ / "a/series.csv", test::fake_case());
  const SeriesTable b(folder_ / "b/series.csv", description_);
  EXPECT_EQ(a.numbers("wall_pressure").back(), b.numbers("wall_pressure").back());
}

TEST_F(Run, KilledRunResumesToTheSameResult) {
  run(settings("full"));
  description_.output.checkpoint_interval = 2e-3;  // s, every few steps
  run(settings("frequent"));
  for (const std::uint64_t step : {1u, 58u, 200u, 390u}) {
    const std::string name = "killed" + std::to_string(step);
    const auto kill = [step](std::uint64_t now) {
      if (now == step) throw Killed();
    };
    EXPECT_THROW(run(settings(name), kill), Killed);
    run(settings(name, Existing::resume));
    test::expect_same_results(folder_ / "frequent", folder_ / name);
  }
  EXPECT_EQ(read_file(folder_ / "full/series.csv"), read_file(folder_ / "frequent/series.csv"));
}

TEST_F(Run, EndsAWhileAfterTheCut) {
  run(settings("full"));
  const double cut = result("full").at("cut_through_time").get<double>();
  description_.time.after_cut = 0.5e-3;
  description_.output.checkpoint_interval = 2e-3;  // s, every few steps
  run(settings("short"));
  const double end = result("short").at("end_time").get<double>();
  EXPECT_EQ(result("short").at("cut_through_time"), cut);
  EXPECT_GE(end, cut + 0.5e-3);
  EXPECT_LT(end, cut + 0.6e-3);  // steps are at most 30 us long
  const auto kill = [](std::uint64_t now) {
    if (now == 300) throw Killed();
  };
  EXPECT_THROW(run(settings("killed"), kill), Killed);
  run(settings("killed", Existing::resume));
  test::expect_same_results(folder_ / "short", folder_ / "killed");
}

TEST_F(Run, KilledLongAfterACheckpointResumesToTheSameResult) {
  run(settings("full"));
  // A signal writes a checkpoint at step 100; the kill is much later, after more output.
  run(settings("a"), [](std::uint64_t now) {
    if (now == 100) std::raise(SIGTERM);
  });
  const auto kill = [](std::uint64_t now) {
    if (now == 300) throw Killed();
  };
  EXPECT_THROW(run(settings("a", Existing::resume), kill), Killed);
  run(settings("a", Existing::resume));
  test::expect_same_results(folder_ / "full", folder_ / "a");
}

TEST_F(Run, ASignalEndsItWithACheckpoint) {
  run(settings("full"));
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const std::string name = std::to_string(signal);
    const RunEnd end = run(settings(name), [signal](std::uint64_t now) {
      if (now == 100) std::raise(signal);
    });
    EXPECT_EQ(end.signal, signal);
    EXPECT_FALSE(fs::exists(folder_ / (name + "/result.json")));
    EXPECT_THAT(read_file(folder_ / (name + "/log.txt")), HasSubstr("kerf run fake.toml --resume"));
    run(settings(name, Existing::resume));
    test::expect_same_results(folder_ / "full", folder_ / name);
  }
}

TEST_F(Run, WallTimesAddUpOverResumedParts) {
  run(settings("a"), [](std::uint64_t now) {
    if (now == 100) std::raise(SIGTERM);
  });
  run(settings("a", Existing::resume));
  EXPECT_EQ(result("a").at("stage_times").at("rates"), 2.0);
  // In the order of a run that was not resumed.
  run(settings("full"));
  const auto stages = [&](const char* name) {
    const auto whole = nlohmann::ordered_json::parse(read_file(folder_ / name / "result.json"));
    std::vector<std::string> names;
    for (const auto& [stage, seconds] : whole.at("stage_times").items()) names.push_back(stage);
    return names;
  };
  EXPECT_EQ(stages("a").size(), 2u);
  EXPECT_EQ(stages("a"), stages("full"));
  EXPECT_GT(result("a").at("wall_time").get<double>(), 0.0);
}

TEST_F(Run, ResumingAFinishedRunChangesNothing) {
  run(settings("a"));
  const std::string before = read_file(folder_ / "a/result.json");
  int steps = 0;
  run(settings("a", Existing::resume), [&steps](std::uint64_t) { ++steps; });
  EXPECT_EQ(steps, 0);
  EXPECT_EQ(read_file(folder_ / "a/result.json"), before);
}

TEST_F(Run, ResumingAFinishedRunRewritesAMissingResult) {
  run(settings("a"));
  run(settings("b"));
  fs::remove(folder_ / "a/result.json");
  fs::remove(folder_ / "a/report.html");
  run(settings("a", Existing::resume));
  test::expect_same_results(folder_ / "a", folder_ / "b");
}

TEST_F(Run, ResumingWithoutACheckpointRestarts) {
  run(settings("full"));
  const auto kill = [](std::uint64_t now) {
    if (now == 200) throw Killed();
  };
  EXPECT_THROW(run(settings("a"), kill), Killed);
  ASSERT_FALSE(fs::exists(folder_ / "a/checkpoint.h5"));
  run(settings("a", Existing::resume));
  test::expect_same_results(folder_ / "full", folder_ / "a");
}

TEST_F(Run, SaysThatNothingIsThereToContinue) {
  run(settings("a", Existing::resume));
  EXPECT_THAT(read_file(folder_ / "a/log.txt"), HasSubstr("no checkpoint to continue from"));
  run(settings("a", Existing::resume));
  run(settings("b"));
  EXPECT_THAT(read_file(folder_ / "b/log.txt"), testing::Not(HasSubstr("no checkpoint")));
}

TEST_F(Run, AFailureKeepsTheCheckpointAndNamesTheRemedy) {
  description_.output.checkpoint_interval = 1e-9;
  const auto fail = [](std::uint64_t now) {
    if (now == 200) throw UserError("particle 7 is not a number", exit_run_failed);
  };
  EXPECT_THAT(message_of<UserError>([&] { run(settings("a"), fail); }),
              AllOf(HasSubstr("particle 7 is not a number"), HasSubstr("saved up to"),
                    HasSubstr("kerf run fake.toml --resume")));
  EXPECT_THAT(read_file(folder_ / "a/log.txt"), HasSubstr("particle 7 is not a number"));
  run(settings("a", Existing::resume));
  EXPECT_EQ(result("a").at("end_time"), 0.01);
}

// Between 2 ms and the failure the run gains energy from nothing: no checkpoint is made of that.
TEST_F(Run, OnlyAStateOfSoundEnergyIsSaved) {
  description_.output.checkpoint_interval = 1e-9;
  const auto made = [](bool fails) {
    return [fails](const Case& description) {
      auto simulation = std::make_unique<FakeSimulation>(description, [fails](std::uint64_t now) {
        if (fails && now == 200) throw UserError("not a number", exit_run_failed);
      });
      if (fails) simulation->breaks_down = 2e-3;
      return simulation;
    };
  };
  const std::string message =
      message_of<UserError>([&] { RunLoop(settings("a"), made(true)).run(); });
  const auto at = message.find("saved up to ");
  ASSERT_NE(at, std::string::npos) << message;
  const double saved = 1e-3 * std::stod(message.substr(at + 12));
  EXPECT_LT(saved, 2e-3);
  EXPECT_GT(saved, 2e-3 - 4e-5);  // steps are 30 us at most
  EXPECT_THAT(read_file(folder_ / "a/log.txt"), HasSubstr("energy balance is off by"));
  RunLoop(settings("a", Existing::resume), made(false)).run();
  EXPECT_EQ(result("a").at("end_time"), 0.01);
}

}  // namespace
}  // namespace kerf
