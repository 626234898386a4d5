// SPDX-License-Identifier: Apache-2.0
// The program `kerf limit`, also when it is killed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <nlohmann/json.hpp>

#include "faults/program.hpp"
#include "small_study.hpp"
#include "study/study_database.hpp"
#include "support/temporary_folder.hpp"

namespace kerf {
namespace {

using test::Ending;
using test::Program;
using testing::AllOf;
using testing::HasSubstr;

class LimitProgram : public testing::Test {
 protected:
  LimitProgram() { write_file(folder_ / "small.toml", test::small_study_case); }
  std::vector<std::string> arguments(const std::vector<std::string>& more) const {
    std::vector<std::string> words{
        "limit", (folder_ / "small.toml").string(), "--out", out().string(), "--jobs", "1"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
  Ending limit(const std::vector<std::string>& more) const {
    return Program(arguments(more), folder_ / "output.txt").wait();
  }
  std::filesystem::path out() const { return folder_ / "out"; }
  nlohmann::json answer() const { return nlohmann::json::parse(read_file(out() / "limit.json")); }
  std::vector<RunRow> rows() const {
    return std::filesystem::exists(out() / "study.db") ? StudyDatabase(out() / "study.db").runs()
                                                       : std::vector<RunRow>();
  }
  std::size_t done() const {
    const auto all = rows();
    return static_cast<std::size_t>(std::count_if(
        all.begin(), all.end(), [](const RunRow& row) { return row.state == RunState::done; }));
  }

  test::TemporaryFolder folder_;
};

TEST_F(LimitProgram, FindsTheLeastSpeedOfAnOrdinaryCase) {
  const Ending ending = limit({"--of", "jet_speed"});
  ASSERT_EQ(ending.exit_code, 0) << ending.output;
  EXPECT_THAT(ending.output,
              AllOf(HasSubstr("verdict"), HasSubstr("more round"),
                    HasSubstr("Least jet_speed that still cuts"), HasSubstr("limit.html")));
  const auto json = answer();
  ASSERT_EQ(json.at("problem"), "") << ending.output;
  EXPECT_EQ(json.at("within_tolerance"), true);
  for (const auto& trial : json.at("trials")) {
    const double speed = trial.at("value");
    EXPECT_EQ(trial.at("holds"), trial.at("margin").get<double>() >= 0.0);
    EXPECT_TRUE(trial.at("holds") == true ? speed >= json.at("bracket").at("high").get<double>()
                                          : speed <= json.at("bracket").at("low").get<double>());
    EXPECT_TRUE(std::filesystem::exists(out() / trial.at("report").get<std::string>()));
  }
  EXPECT_THAT(read_file(out() / "limit.html"), HasSubstr("<svg"));
}

// A nozzle that is faster cuts less of its path; all runs have the same path.
TEST_F(LimitProgram, FindsTheGreatestFeedOverOnePath) {
  std::string travelling = test::small_study_case;
  const auto replace = [&](const std::string& old, const std::string& by) {
    travelling.replace(travelling.find(old), old.size(), by);
  };
  replace("[\"12 mm\", \"8 mm\"]", "[\"40 mm\", \"8 mm\"]");
  replace("[\"40 mm\", \"40 mm\"]", "[\"60 mm\", \"40 mm\"]");
  replace("standoff = \"4 mm\"", "standoff = \"4 mm\"\ntraverse = [\"2 m/s\", \"0 m/s\"]");
  replace("end = \"6 ms\"", "end = \"8 ms\"");
  replace("failure_strain = 0.1", "failure_strain = 0.03");  // else it is swept off whole
  write_file(folder_ / "small.toml", travelling);
  const Ending ending = limit({"--of", "feed"});
  ASSERT_EQ(ending.exit_code, 0) << ending.output;
  const auto json = answer();
  ASSERT_EQ(json.at("problem"), "") << ending.output;
  EXPECT_EQ(json.at("key"), "jet.jet.traverse.0");
  EXPECT_GT(json.at("value"), 2.0) << "the stated feed cuts";
  // 2 m/s for 8 ms, less the flight of 4 mm at 5 m/s.
  const double flight = 0.8e-3, path = 2.0 * (8e-3 - flight);
  for (const auto& trial : json.at("trials")) {
    const double feed = trial.at("value"), end = trial.at("end_time");
    EXPECT_NEAR(feed * (end - flight), path, 1e-6 * path);
    EXPECT_EQ(trial.at("holds"), feed <= json.at("bracket").at("low").get<double>());
  }
}

TEST_F(LimitProgram, ContinuesAfterAKillWithoutRepeatedRuns) {
  Program first(arguments({"--of", "jet_speed"}), folder_ / "output.txt");
  ASSERT_TRUE(test::wait_for([&] { return done() >= 2; }));
  ASSERT_EQ(first.end(SIGKILL).signal, SIGKILL) << "it ended before it was killed";
  ASSERT_EQ(limit({"--of", "jet_speed"}).exit_code, 0);
  const std::size_t runs = rows().size();
  for (const RunRow& row : rows()) EXPECT_LE(row.attempts, 2);
  ASSERT_EQ(limit({"--of", "jet_speed"}).exit_code, 0);
  EXPECT_EQ(rows().size(), runs);
  EXPECT_EQ(answer().at("runs"), runs);
}

TEST_F(LimitProgram, SaysThatItIsStoppedAndHowToContinue) {
  Program first(arguments({"--of", "jet_speed"}), folder_ / "output.txt");
  ASSERT_TRUE(test::wait_for([&] { return done() >= 2; }));
  const Ending ending = first.end(SIGINT);
  EXPECT_EQ(ending.exit_code, 130);
  EXPECT_THAT(ending.output, AllOf(HasSubstr("not found yet"), HasSubstr("same command again")));
  EXPECT_EQ(answer().at("trials").at(0).at("state"), "done");
}

TEST_F(LimitProgram, SaysThatTheJetCutsAtEverySpeedOfTheRange) {
  const Ending ending = limit({"--of", "jet_speed", "--from", "9 m/s", "--to", "20 m/s"});
  ASSERT_EQ(ending.exit_code, 0) << ending.output;
  EXPECT_THAT(ending.output, HasSubstr("The jet cuts at every jet_speed down to 9 m/s"));
  EXPECT_EQ(answer().at("holds_everywhere"), true);
  EXPECT_TRUE(answer().at("value").is_null());
}

TEST_F(LimitProgram, RefusesAQuantityThatTheCaseDoesNotHave) {
  const Ending ending = limit({"--of", "pressure"});
  EXPECT_EQ(ending.exit_code, 1);
  EXPECT_THAT(ending.output, HasSubstr("a case with a [[jet]] has no such limit"));
  EXPECT_FALSE(std::filesystem::exists(out()));
}

TEST_F(LimitProgram, ConvergeGivesEachHeadlineNumberAnInterval) {
  const std::vector<std::string> words{"run", (folder_ / "small.toml").string(), "--out",
                                       out().string(), "--converge"};
  const Ending first = Program(words, folder_ / "output.txt").wait();
  ASSERT_EQ(first.exit_code, 0) << first.output;
  EXPECT_THAT(first.output, AllOf(HasSubstr("4 of 4 runs"), HasSubstr("front_depth")));
  const std::string result = read_file(out() / "result.json");
  const auto json = nlohmann::json::parse(result);
  ASSERT_GE(json.at("intervals").size(), 4u);
  for (const auto& interval : json.at("intervals")) {
    if (interval.at("low").is_null()) {  // no coarser run has a width of the kerf
      EXPECT_EQ(interval.at("metric"), "kerf.middle.width");
      EXPECT_TRUE(interval.at("high").is_null());
      continue;
    }
    EXPECT_LE(interval.at("low"), interval.at("value"));
    EXPECT_GE(interval.at("high"), interval.at("value"));
    EXPECT_GE(interval.at("runs"), 1);
  }
  EXPECT_THAT(read_file(out() / "report.html"), HasSubstr("Value [low, high]"));
  std::vector<std::string> again = words;
  again.emplace_back("--resume");
  ASSERT_EQ(Program(again, folder_ / "output.txt").wait().exit_code, 0);
  EXPECT_EQ(read_file(out() / "result.json"), result);
  for (const RunRow& row : StudyDatabase(out() / "converge" / "study.db").runs())
    EXPECT_EQ(row.attempts, 1);
}

TEST_F(LimitProgram, ConvergeNeedsAJet) {
  std::string plain = test::small_study_case;
  const auto start = plain.find("[[jet]]"), end = plain.find("[output]");
  write_file(folder_ / "plain.toml", plain.erase(start, end - start));
  const Ending ending =
      Program({"run", (folder_ / "plain.toml").string(), "--out", out().string(), "--converge"},
              folder_ / "output.txt")
          .wait();
  EXPECT_EQ(ending.exit_code, 1);
  EXPECT_THAT(ending.output, AllOf(HasSubstr("--converge"), HasSubstr("no jet")));
}

}  // namespace
}  // namespace kerf
