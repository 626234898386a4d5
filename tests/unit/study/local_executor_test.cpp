// SPDX-License-Identifier: Apache-2.0
// Cores, memory and folders of runs, with a test program instead of Kerf that records the number of
// its running processes.
#include "study/local_executor.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <sstream>

#include "output/files.hpp"
#include "support/temporary_folder.hpp"

namespace kerf {
namespace {

namespace fs = std::filesystem;

class CountingWatcher : public JobWatcher {
 public:
  void started(const Job&) override {}
  bool ended(const Job& job, const JobEnd& end) override {
    ends.emplace_back(job.id, end);
    return false;
  }
  bool look(const std::vector<Job>& at_work) override {
    most_at_work = std::max(most_at_work, at_work.size());
    double memory = 0.0;
    for (const Job& job : at_work) memory += job.memory;
    most_memory = std::max(most_memory, memory);
    return on_look && on_look();
  }

  std::vector<std::pair<std::string, JobEnd>> ends;
  std::size_t most_at_work = 0;
  double most_memory = 0.0;
  std::function<bool()> on_look;
};

class LocalExecutorTest : public testing::Test {
 protected:
  LocalExecutorTest() { write_script("sleep 0.1; echo \"$@\""); }
  void write_script(const std::string& body) {
    write_file(program(), "#!/bin/sh\n" + body + "\n");
    fs::permissions(program(), fs::perms::owner_all);
  }
  fs::path program() const { return folder_ / "program"; }
  Job job(const std::string& id, double memory = 0.0) const {
    return {id, folder_ / (id + ".toml"), folder_ / id, folder_ / (id + ".txt"), memory};
  }
  std::vector<Job> jobs(int count, double memory = 0.0) const {
    std::vector<Job> result;
    for (int i = 0; i < count; ++i) result.push_back(job(std::to_string(i), memory));
    return result;
  }

  test::TemporaryFolder folder_;
  CountingWatcher watcher_;
};

TEST_F(LocalExecutorTest, RunsUpToTheMaximumAtOnce) {
  LocalExecutor(program(), {8, 3, 1e9}).run(jobs(7), watcher_);
  EXPECT_EQ(watcher_.ends.size(), 7u);
  EXPECT_EQ(watcher_.most_at_work, 3u);
}

TEST_F(LocalExecutorTest, ConcurrentRunsFitTheMemoryBudget) {
  LocalExecutor(program(), {8, 8, 9.0}).run(jobs(5, 4.0), watcher_);
  EXPECT_EQ(watcher_.ends.size(), 5u);
  EXPECT_EQ(watcher_.most_memory, 8.0);
}

TEST_F(LocalExecutorTest, ASmallRunStartsBeforeAWaitingLargeOne) {
  LocalExecutor(program(), {8, 8, 9.0})
      .run({job("a", 6.0), job("large", 6.0), job("small", 2.0)}, watcher_);
  EXPECT_EQ(watcher_.most_memory, 8.0);
  EXPECT_EQ(watcher_.ends.back().first, "large");
}

TEST_F(LocalExecutorTest, OnlyARunBeyondTheMemoryBudgetFails) {
  LocalExecutor(program(), {2, 2, 9.0}).run({job("huge", 10.0), job("small", 1.0)}, watcher_);
  ASSERT_EQ(watcher_.ends.size(), 2u);
  EXPECT_EQ(watcher_.ends[0].first, "huge");
  EXPECT_THAT(watcher_.ends[0].second.problem, testing::HasSubstr("--memory"));
  EXPECT_EQ(watcher_.ends[1].second.exit_code, 0);
}

TEST_F(LocalExecutorTest, CoresAreSharedAmongRuns) {
  const auto threads_of = [&](const std::string& id) {
    std::istringstream words(read_file(folder_ / (id + ".txt")));
    for (std::string word; words >> word;)
      if (word == "--threads") return (words >> word, std::stoi(word));
    return 0;
  };
  LocalExecutor(program(), {6, 6, 1e9}).run(jobs(1), watcher_);
  EXPECT_EQ(threads_of("0"), 6);
  LocalExecutor(program(), {6, 6, 1e9}).run(jobs(3), watcher_);
  for (const char* id : {"0", "1", "2"}) EXPECT_EQ(threads_of(id), 2);
  LocalExecutor(program(), {2, 4, 1e9}).run(jobs(6), watcher_);
  for (const char* id : {"0", "3", "5"}) EXPECT_EQ(threads_of(id), 1);
}

TEST_F(LocalExecutorTest, RunsGetTheirDevice) {
  const auto words = [&] { return read_file(folder_ / "0.txt"); };
  LocalExecutor(program(), {1, 1, 1e9}).run(jobs(1), watcher_);
  EXPECT_THAT(words(), testing::HasSubstr("--device cpu"));
  LocalExecutor(program(), {1, 1, 1e9, "gpu"}).run(jobs(1), watcher_);
  EXPECT_THAT(words(), testing::HasSubstr("--device gpu"));
}

TEST_F(LocalExecutorTest, WaitsForAFolderLockedByAnotherProcess) {
  make_folder(folder_ / "held");
  std::optional<FolderLock> lock(folder_ / "held");
  int looks = 0;
  bool was_started_early = false;
  watcher_.on_look = [&] {
    was_started_early = was_started_early || (lock && fs::exists(folder_ / "held.txt"));
    if (++looks == 10) lock.reset();
    return false;
  };
  LocalExecutor(program(), {2, 2, 1e9}).run({job("held")}, watcher_);
  EXPECT_FALSE(was_started_early);
  EXPECT_EQ(watcher_.ends.size(), 1u);
  EXPECT_GT(looks, 10);
}

TEST_F(LocalExecutorTest, ExitCodesAndSignalsAreReported) {
  write_script("case $2 in *code*) exit 7;; *) kill -11 $$;; esac");
  LocalExecutor(program(), {1, 1, 1e9}).run({job("code"), job("crash")}, watcher_);
  EXPECT_EQ(watcher_.ends[0].second.exit_code, 7);
  EXPECT_EQ(watcher_.ends[0].second.signal, 0);
  EXPECT_EQ(watcher_.ends[1].second.signal, 11);
}

TEST_F(LocalExecutorTest, AStopEndsRunsAndStartsNone) {
  write_script("trap 'exit 143' TERM; sleep 30 & wait");
  watcher_.on_look = [&] { return watcher_.most_at_work == 2; };
  LocalExecutor(program(), {2, 2, 1e9}).run(jobs(5), watcher_);
  ASSERT_EQ(watcher_.ends.size(), 2u);
  for (const auto& [id, end] : watcher_.ends) EXPECT_TRUE(end.exit_code == 143 || end.signal == 15);
}

}  // namespace
}  // namespace kerf
