// SPDX-License-Identifier: Apache-2.0
// The program `kerf study`, also when it is stopped or killed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "core/error.hpp"
#include "faults/program.hpp"
#include "output/hdf5.hpp"
#include "small_study.hpp"
#include "study/study_database.hpp"
#include "support/temporary_folder.hpp"

namespace kerf {
namespace {

namespace fs = std::filesystem;
using test::Ending;
using test::Program;
using testing::AllOf;
using testing::HasSubstr;

constexpr const char* map = R"(base = "small.toml"
[vary]
"jet.jet.speed" = { from = "2 m/s", to = "10 m/s", count = 3 }
"jet.jet.width" = ["4 mm", "6 mm"]
)";

class StudyProgram : public testing::Test {
 protected:
  StudyProgram() {
    write_file(folder_ / "small.toml", test::small_study_case);
    write_file(folder_ / "map.toml", map);
  }
  std::vector<std::string> arguments(const std::string& study, const std::string& more = "") const {
    std::vector<std::string> words{
        "study", (folder_ / study).string(), "--out", out().string(), "--jobs", "2"};
    if (!more.empty()) words.push_back(more);
    return words;
  }
  Ending run(const std::string& study, const std::string& more = "") const {
    return Program(arguments(study, more), folder_ / "output.txt").wait();
  }
  fs::path out() const { return folder_ / "out"; }
  std::vector<RunRow> rows() const { return StudyDatabase(out() / "study.db").runs(); }
  std::size_t count(RunState state) const {
    if (!fs::exists(out() / "study.db")) return 0;
    const auto all = rows();
    return static_cast<std::size_t>(std::count_if(
        all.begin(), all.end(), [=](const RunRow& row) { return row.state == state; }));
  }
  // Processes whose command names a file of the study's folder.
  std::size_t processes() const {
    std::size_t found = 0;
    for (const auto& entry : fs::directory_iterator("/proc")) {
      std::ifstream file(entry.path() / "cmdline", std::ios::binary);
      const std::string words{std::istreambuf_iterator<char>(file), {}};
      found += words.find(out().string()) != std::string::npos;
    }
    return found;
  }

  test::TemporaryFolder folder_;
};

TEST_F(StudyProgram, RunsAMapAndWritesItsTables) {
  const Ending ending = run("map.toml");
  ASSERT_EQ(ending.exit_code, 0) << ending.output;
  EXPECT_THAT(ending.output, AllOf(HasSubstr("6 of 6 runs"), HasSubstr("jet.jet.speed")));
  const auto json = nlohmann::json::parse(read_file(out() / "study.json"));
  ASSERT_EQ(json.at("runs").size(), 6u);
  std::set<std::pair<double, double>> settings;
  for (const auto& entry : json.at("runs")) {
    EXPECT_EQ(entry.at("state"), "done");
    EXPECT_TRUE(fs::exists(out() / entry.at("report").get<std::string>()));
    EXPECT_EQ(entry.at("metrics").at("jet_speed"), entry.at("setting").at("jet.jet.speed"));
    settings.emplace(entry.at("setting").at("jet.jet.speed"),
                     entry.at("setting").at("jet.jet.width"));
  }
  EXPECT_EQ(settings.size(), 6u);
  const std::string csv = read_file(out() / "study.csv");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 7);
  EXPECT_THAT(csv, HasSubstr("jet.jet.speed (m/s),jet.jet.width (m)"));
  const auto file = hdf5::open(out() / "study.h5");
  const auto table = hdf5::open_group(file, "runs");
  EXPECT_EQ(hdf5::read_array<double>(table, "jet.jet.width"),
            (std::vector<double>{0.004, 0.006, 0.004, 0.006, 0.004, 0.006}));
}

TEST_F(StudyProgram, KilledStudyCompletesWithoutRepeatedRuns) {
  std::set<std::string> finished;
  for (const std::size_t wanted : {1u, 3u}) {
    Program study(arguments("map.toml"), folder_ / "output.txt");
    ASSERT_TRUE(test::wait_for([&] { return count(RunState::done) >= wanted; }));
    ASSERT_EQ(study.end(SIGKILL).signal, SIGKILL) << "it ended before it was killed";
    EXPECT_TRUE(test::wait_for([&] { return processes() == 0; })) << "runs outlive the study";
    for (const RunRow& row : rows())
      if (row.state == RunState::done) finished.insert(row.id + " " + row.ended);
    EXPECT_LT(finished.size(), 6u);
  }
  const Ending ending = run("map.toml");
  ASSERT_EQ(ending.exit_code, 0) << ending.output;
  EXPECT_EQ(count(RunState::done), 6u);
  // Runs that were complete at the kill are not started again.
  std::set<std::string> at_the_end;
  for (const RunRow& row : rows()) {
    at_the_end.insert(row.id + " " + row.ended);
    EXPECT_LE(row.attempts, 3);
  }
  for (const std::string& run : finished) EXPECT_EQ(at_the_end.count(run), 1u) << run;
  std::size_t starts = 0;
  for (const RunRow& row : rows()) starts += static_cast<std::size_t>(row.attempts);
  EXPECT_LE(starts, 6u + 2u * 2u) << "at each kill two runs were at work";
}

TEST_F(StudyProgram, ASignalMakesRunsWriteCheckpoints) {
  Program study(arguments("map.toml"), folder_ / "output.txt");
  ASSERT_TRUE(test::wait_for([&] { return count(RunState::done) >= 1; }));
  const Ending ending = study.end(SIGINT);
  EXPECT_EQ(ending.exit_code, 130);
  EXPECT_THAT(ending.output, HasSubstr("Continue with: kerf study"));
  EXPECT_EQ(processes(), 0u);
  EXPECT_EQ(count(RunState::running), 0u);
  EXPECT_EQ(count(RunState::failed), 0u);
  EXPECT_EQ(run("map.toml").exit_code, 0);
  EXPECT_EQ(count(RunState::done), 6u);
}

TEST_F(StudyProgram, AnExtendedStudyRunsNewCasesOnly) {
  ASSERT_EQ(run("map.toml").exit_code, 0);
  std::string larger = map;
  larger.replace(larger.find("\"6 mm\""), 6, "\"6 mm\", \"8 mm\"");
  write_file(folder_ / "map.toml", larger);
  ASSERT_EQ(run("map.toml").exit_code, 0);
  EXPECT_EQ(count(RunState::done), 9u);
  for (const RunRow& row : rows()) EXPECT_EQ(row.attempts, 1);
}

TEST_F(StudyProgram, AFailedRunStopsNoOther) {
  // A run with a folder that is not one of Kerf fails; a first study determines the id of that run.
  ASSERT_EQ(run("map.toml").exit_code, 0);
  const RunRow row = rows().at(2);
  fs::remove_all(out() / "runs" / row.id);
  write_file(out() / "runs" / (row.id + ".toml"), "title = \"broken\"\n");
  StudyDatabase(out() / "study.db").mark_waiting(row.id);
  const Ending ending = run("map.toml");
  EXPECT_EQ(ending.exit_code, exit_run_failed) << ending.output;
  EXPECT_THAT(ending.output, HasSubstr("1 run failed"));
  EXPECT_EQ(count(RunState::failed), 1u);
  EXPECT_EQ(count(RunState::done), 5u);
  EXPECT_THAT(rows().at(2).error, HasSubstr("dimension"));
  fs::remove(out() / "runs" / (row.id + ".toml"));
  ASSERT_EQ(run("map.toml", "--retry").exit_code, 0);
  EXPECT_EQ(count(RunState::done), 6u);
}

TEST_F(StudyProgram, TwoStudiesDoNotShareAFolder) {
  Program first(arguments("map.toml"), folder_ / "output.txt");
  ASSERT_TRUE(test::wait_for([&] { return count(RunState::running) >= 1; }));
  const Ending second = Program(arguments("map.toml"), folder_ / "second.txt").wait();
  EXPECT_EQ(second.exit_code, exit_files);
  EXPECT_THAT(second.output, HasSubstr("in use"));
  EXPECT_EQ(first.wait().exit_code, 0);
}

TEST_F(StudyProgram, FindsTheLeastSpeedThatASweepBrackets) {
  // Within 6 ms a jet of 4.25 m/s does not cut, though one of 4 m/s does.
  std::string longer = test::small_study_case;
  longer.replace(longer.find("end = \"6 ms\""), 12, "end = \"8 ms\"");
  write_file(folder_ / "small.toml", longer);
  write_file(folder_ / "least.toml",
             "base = \"small.toml\"\n[search]\nfind = \"least\"\nkey = \"jet.jet.speed\"\n"
             "from = \"1 m/s\"\nto = \"12 m/s\"\ndraft = 1.0\ntolerance = 0.05\n"
             "[vary]\n\"jet.jet.speed\" = { from = \"1 m/s\", to = \"12 m/s\", count = 12 }\n"
             "[design]\ntype = \"grid\"\n");
  const Ending ending = run("least.toml");
  ASSERT_EQ(ending.exit_code, 0) << ending.output;
  const auto json = nlohmann::json::parse(read_file(out() / "study.json"));
  const auto& found = json.at("search");
  ASSERT_EQ(found.at("problem"), "") << ending.output;
  ASSERT_GE(json.at("boundary").size(), 1u);
  // No run below the bracket cuts, and every run above it does.
  for (const auto& entry : json.at("runs")) {
    const double speed = entry.at("setting").at("jet.jet.speed");
    const double cuts = entry.at("metrics").at("cut_through");
    EXPECT_TRUE(cuts == 0.0 || speed > found.at("low").get<double>()) << speed;
    EXPECT_TRUE(cuts == 1.0 || speed < found.at("high").get<double>()) << speed;
  }
  EXPECT_LE(found.at("runs").get<int>(), 8);
}

TEST_F(StudyProgram, ReportsTooLittleMemoryForARun) {
  std::vector<std::string> words = arguments("map.toml", "--memory");
  words.emplace_back("1e-6");
  const Ending ending = Program(words, folder_ / "output.txt").wait();
  EXPECT_EQ(ending.exit_code, exit_run_failed) << ending.output;
  EXPECT_EQ(count(RunState::failed), 6u);
  EXPECT_THAT(ending.output, HasSubstr("6 runs failed"));
  EXPECT_THAT(rows().at(0).error, AllOf(HasSubstr("GiB of memory"), HasSubstr("--memory")));
}

}  // namespace
}  // namespace kerf
