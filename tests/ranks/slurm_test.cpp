// SPDX-License-Identifier: Apache-2.0
// Runs of several ranks in jobs of a real Slurm, if it can be started on this machine.
#include "studies/slurm.hpp"

#include <gmock/gmock.h>

#include "ranks/rank_runs.hpp"
#include "studies/small_study.hpp"

namespace kerf::test {
namespace {

class SlurmRanks : public Ranks {
 protected:
  void SetUp() override {
    setenv("OMPI_ALLOW_RUN_AS_ROOT", "1", 1);
    setenv("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1", 1);
    if (const std::string why = slurm_.start(); !why.empty()) GTEST_SKIP() << why;
    write_case(small_study_case);
  }

  SlurmOfOneNode slurm_;
};

TEST_F(SlurmRanks, ARunHasTheBitsOfOneProcess) {
  ASSERT_EQ(run(0, "alone").exit_code, 0);
  const Ending ending = run(0, "job", {"--on", "slurm", "--ranks", "2"});
  ASSERT_EQ(ending.exit_code, 0) << ending.output;
  expect_same("alone", "job");
  EXPECT_THAT(output_of("scontrol", {"show", "job", "1"}).output, testing::HasSubstr("NumTasks=2"));
}

TEST_F(SlurmRanks, TheRunsOfAStudyHaveThem) {
  write_file(folder("two.toml"),
             "base = \"case.toml\"\n[vary]\n\"jet.jet.speed\" = [\"3 m/s\", \"6 m/s\"]\n");
  const auto study = [&](const std::string& name, const std::vector<std::string>& options) {
    std::vector<std::string> words{"study", folder("two.toml").string(), "--out",
                                   folder(name).string()};
    words.insert(words.end(), options.begin(), options.end());
    return Program(words, folder(name + ".log")).wait();
  };
  ASSERT_EQ(study("here", {}).exit_code, 0);
  const Ending ending = study("jobs", {"--on", "slurm", "--ranks", "2"});
  ASSERT_EQ(ending.exit_code, 0) << ending.output;
  EXPECT_THAT(read_file(folder("jobs") / "slurm" / "1.sh"),
              testing::HasSubstr("'mpirun' '-n' '2'"));
  int runs = 0;
  for (const auto& entry : fs::directory_iterator(folder("here") / "runs")) {
    if (!entry.is_directory()) continue;
    const fs::path there = folder("jobs") / "runs" / entry.path().filename();
    EXPECT_EQ(read_file(entry.path() / "series.csv"), read_file(there / "series.csv"));
    ++runs;
  }
  EXPECT_EQ(runs, 2);
}

TEST_F(SlurmRanks, WhatIsNotDividedIsRefusedBeforeItIsSubmitted) {
  write_case(read_file(fs::path(KERF_SOURCE_DIR) / "cases" / "column-on-wall.toml"));
  const Ending ending = run(0, "refused", {"--on", "slurm", "--ranks", "2"});
  EXPECT_NE(ending.exit_code, 0);
  EXPECT_THAT(ending.output, testing::HasSubstr("'shinohara2004'"));
  EXPECT_EQ(ending.output.find("job 1 of Slurm"), std::string::npos);
}

}  // namespace
}  // namespace kerf::test
