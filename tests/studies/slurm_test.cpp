// SPDX-License-Identifier: Apache-2.0
// Studies as job arrays of a real Slurm, if it can be started on this machine.
#include "slurm.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "core/error.hpp"
#include "faults/program.hpp"
#include "small_study.hpp"
#include "study/slurm_array.hpp"
#include "study/study_database.hpp"

namespace kerf {
namespace {

using test::Program;
using testing::HasSubstr;

// Characters that the shell, Slurm or both take for their own.
const std::string odd_name = "-a 'b' \"c\" $HOME `id` %A %j \\ ;*\n#SBATCH --hold\nd";

class SlurmStudy : public testing::Test {
 protected:
  void SetUp() override {
    if (const std::string why = slurm_.start(); !why.empty()) GTEST_SKIP() << why;
    write_file(folder_ / "small.toml", test::small_study_case);
    write_file(folder_ / "map.toml",
               "base = \"small.toml\"\n[vary]\n"
               "\"jet.jet.speed\" = { from = \"2 m/s\", to = \"9 m/s\", count = 8 }\n"
               "\"jet.jet.width\" = [\"4 mm\", \"6 mm\"]\n");
  }
  std::vector<std::string> arguments() const {
    return {"study",  (folder_ / "map.toml").string(),
            "--out",  out().string(),
            "--on",   "slurm",
            "--jobs", "2"};
  }
  std::filesystem::path out() const { return folder_ / name_; }
  std::vector<RunRow> rows() const {
    return std::filesystem::exists(out() / "study.db") ? StudyDatabase(out() / "study.db").runs()
                                                       : std::vector<RunRow>();
  }
  std::size_t count(RunState state) const {
    const auto all = rows();
    return static_cast<std::size_t>(std::count_if(
        all.begin(), all.end(), [=](const RunRow& row) { return row.state == state; }));
  }
  static std::string queue() {
    return output_of("squeue", {"--array", "--noheader", "--format=%i %t"}).output;
  }
  std::size_t arrays() const {
    const auto lists = std::filesystem::directory_iterator(out() / "slurm");
    return static_cast<std::size_t>(std::count_if(begin(lists), end(lists), [](const auto& entry) {
      return entry.path().extension() == ".list";
    }));
  }

  test::SlurmOfOneNode slurm_;
  test::TemporaryFolder folder_;
  std::string name_ = "out";
};

TEST_F(SlurmStudy, SixteenRunsEndAndACancelledTaskIsRepeated) {
  Program study(arguments(), folder_ / "output.txt");
  ASSERT_TRUE(test::wait_for([&] { return queue().find("1_15 PD") != std::string::npos; }));
  ASSERT_EQ(output_of("scancel", {"1_15"}).exit_code, 0);
  const test::Ending ending = study.wait();
  ASSERT_EQ(ending.exit_code, 0) << ending.output;
  EXPECT_EQ(count(RunState::done), 16u);
  ASSERT_EQ(arrays(), 2u);
  const std::string all = read_file(out() / "slurm/1.list"),
                    again = read_file(out() / "slurm/2.list");
  EXPECT_EQ(std::count(all.begin(), all.end(), '\n'), 16);
  EXPECT_EQ(std::count(again.begin(), again.end(), '\n'), 1);
  EXPECT_TRUE(all.ends_with(again)) << "the cancelled task was the last of the array";
}

TEST_F(SlurmStudy, AKilledStudyResumesItsArray) {
  Program first(arguments(), folder_ / "output.txt");
  ASSERT_TRUE(test::wait_for([&] { return count(RunState::done) >= 2; }));
  ASSERT_EQ(first.end(SIGKILL).signal, SIGKILL) << "it ended before it was killed";
  const test::Ending ending = Program(arguments(), folder_ / "output.txt").wait();
  ASSERT_EQ(ending.exit_code, 0) << ending.output;
  EXPECT_EQ(count(RunState::done), 16u);
  EXPECT_EQ(arrays(), 1u) << "what was in the queue was submitted again";
}

TEST_F(SlurmStudy, RunsInAFolderOfAnyName) {
  name_ = odd_name;
  write_file(folder_ / "map.toml",
             "base = \"small.toml\"\n[vary]\n\"jet.jet.speed\" = [\"2 m/s\", \"9 m/s\"]\n");
  const test::Ending ending = Program(arguments(), folder_ / "output.txt").wait();
  ASSERT_EQ(ending.exit_code, 0) << ending.output;
  EXPECT_EQ(count(RunState::done), 2u);
  EXPECT_TRUE(std::filesystem::exists(out() / "slurm/1_0.txt"));
}

TEST_F(SlurmStudy, ReportsAClusterWithoutGpus) {
  std::vector<std::string> words = arguments();
  words.insert(words.end(), {"--device", "gpu"});
  const test::Ending ending = Program(words, folder_ / "output.txt").wait();
  EXPECT_EQ(ending.exit_code, exit_files);
  EXPECT_THAT(ending.output, HasSubstr("generic resource"));
  EXPECT_THAT(read_file(out() / "slurm/1.sh"), HasSubstr("--device gpu --resume"));
}

// Slurm counts time limits in minutes, so that this is for ctest -C scheduled -R time_limit.
TEST_F(SlurmStudy, ARunGoesOnBeyondTheTimeLimitOfItsTask) {
  if (std::getenv("KERF_SCHEDULED") == nullptr) GTEST_SKIP() << "it takes some minutes";
  std::string text = test::small_study_case;  // a run of two minutes
  for (const auto& [key, value] : {std::pair{"end = ", "110 s"}, {"frame_interval = ", "50 s"}})
    text.replace(text.find(key) + std::string(key).size() + 1, 4, value);
  write_file(folder_ / "small.toml", text);
  write_file(folder_ / "map.toml",
             "base = \"small.toml\"\n[vary]\n\"jet.jet.speed\" = [\"5 m/s\"]\n");
  setenv("SBATCH_TIMELIMIT", "1", 1);
  const test::Ending ending = Program(arguments(), folder_ / "output.txt").wait();
  unsetenv("SBATCH_TIMELIMIT");
  ASSERT_EQ(ending.exit_code, 0) << ending.output;
  EXPECT_EQ(count(RunState::done), 1u);
  EXPECT_GE(arrays(), 2u) << "the run ended within the limit";
}

TEST_F(SlurmStudy, ARunIsSubmittedAndFollowed) {
  const auto run = [&](const std::filesystem::path& to, std::vector<std::string> more) {
    std::vector<std::string> words{"run", (folder_ / "small.toml").string(), "--out", to.string()};
    words.insert(words.end(), more.begin(), more.end());
    return Program(words, folder_ / "output.txt").wait();
  };
  name_ = odd_name;
  const test::Ending ending = run(out(), {"--on", "slurm"});
  ASSERT_EQ(ending.exit_code, 0) << ending.output;
  EXPECT_THAT(ending.output, HasSubstr("job 1 of Slurm"));
  EXPECT_THAT(ending.output, HasSubstr("report.html"));
  EXPECT_FALSE(std::filesystem::exists(out().concat(".txt.exit")));
  ASSERT_EQ(run(folder_ / "here", {"--threads", "1"}).exit_code, 0);
  EXPECT_EQ(read_file(out() / "series.csv"), read_file(folder_ / "here/series.csv"));
  EXPECT_EQ(run(out(), {"--on", "slurm"}).exit_code, exit_files) << "the folder has a run";
}

TEST_F(SlurmStudy, ARunThatSlurmEndsIsReported) {
  std::string text = test::small_study_case;
  text.replace(text.find("6 ms"), 4, "60 s");
  write_file(folder_ / "small.toml", text);
  Program run({"run", (folder_ / "small.toml").string(), "--out", out().string(), "--on", "slurm"},
              folder_ / "output.txt");
  ASSERT_TRUE(test::wait_for([&] { return queue().find("1 R") != std::string::npos; }));
  ASSERT_EQ(output_of("scancel", {"1"}).exit_code, 0);
  const test::Ending ending = run.wait();
  EXPECT_EQ(ending.exit_code, exit_run_failed);
  EXPECT_THAT(ending.output, HasSubstr("Slurm ended job 1"));
  EXPECT_THAT(ending.output, HasSubstr("--threads 1 --on slurm --resume"));
}

TEST_F(SlurmStudy, ARunThatIsLeftGoesOn) {
  Program run({"run", (folder_ / "small.toml").string(), "--out", out().string(), "--on", "slurm"},
              folder_ / "output.txt");
  ASSERT_TRUE(test::wait_for([&] { return !queue().empty(); }));
  const test::Ending ending = run.end(SIGINT);
  EXPECT_EQ(ending.exit_code, 128 + SIGINT);
  EXPECT_THAT(ending.output, HasSubstr("job 1 goes on"));
  EXPECT_TRUE(test::wait_for([&] { return std::filesystem::exists(out() / "report.html"); }));
}

// An sbatch that does at once what the script of the first task says.
TEST(SlurmStudyWithoutSlurm, TheScriptRunsInAFolderOfAnyName) {
  const test::TemporaryFolder folder;
  const std::filesystem::path place = folder / odd_name, tools = folder / "tools";
  const auto write_program = [](const std::filesystem::path& file, const std::string& text) {
    write_file(file, "#!/bin/sh\n" + text);
    std::filesystem::permissions(file, std::filesystem::perms::owner_all);
  };
  make_folder(place / "runs");
  make_folder(tools);
  write_program(tools / "sbatch",
                "for word; do :; done\nSLURM_ARRAY_TASK_ID=1 exec sh \"$word\"\n");
  write_program(place / "program", "pwd\nfor word; do echo \"<$word>\"; done\n");
  const std::string path = getenv("PATH");
  setenv("PATH", (tools.string() + ":" + path).c_str(), 1);
  SlurmArrays(place).submit({"first", "second"}, {place / "program", 1, {}});
  setenv("PATH", path.c_str(), 1);
  EXPECT_EQ(read_file(place / "runs/second.txt"),
            place.string() +
                "\n<run>\n<runs/second.toml>\n<--out>\n<runs/second>\n<--threads>\n<1>\n"
                "<--device>\n<cpu>\n<--resume>\n");
  EXPECT_EQ(SlurmArrays(place).exit_code("second"), 0);
}

TEST(SlurmStudyWithoutSlurm, ReportsThatSlurmIsMissing) {
  const test::TemporaryFolder folder;
  write_file(folder / "small.toml", test::small_study_case);
  write_file(folder / "map.toml",
             "base = \"small.toml\"\n[vary]\n\"jet.jet.speed\" = [\"2 m/s\"]\n");
  const std::string path = getenv("PATH");
  setenv("PATH", folder.path().c_str(), 1);
  const test::Ending ending = Program({"study", (folder / "map.toml").string(), "--out",
                                       (folder / "out").string(), "--on", "slurm"},
                                      folder / "output.txt")
                                  .wait();
  setenv("PATH", path.c_str(), 1);
  EXPECT_EQ(ending.exit_code, 4);
  EXPECT_THAT(ending.output, HasSubstr("squeue does not answer: squeue is not installed"));
  EXPECT_THAT(ending.output, HasSubstr("This start has queued no run."));
}

}  // namespace
}  // namespace kerf
