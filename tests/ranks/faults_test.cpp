// SPDX-License-Identifier: Apache-2.0
// Ranks that are killed at any moment and a disk that is full: what was saved before is enough for
// any number of ranks to end with the bits of a run without faults.
#include <gmock/gmock.h>

#include <random>

#include "ranks/rank_runs.hpp"

namespace kerf::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

// A jet splits a soft block; a second of one core.
std::string jet_on_strip() {
  return read_file(fs::path(KERF_SOURCE_DIR) / "tests/ranks/jet_on_strip.toml");
}

int count_of(const std::string& text, const std::string& part) {
  int count = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

// Returns how many processes have `text` among their arguments.
int processes_with(const std::string& text) {
  int count = 0;
  for (const auto& entry : fs::directory_iterator("/proc")) {
    const std::string name = entry.path().filename();
    if (name.find_first_not_of("0123456789") != std::string::npos) continue;
    std::ifstream file(entry.path() / "cmdline");
    const std::string line{std::istreambuf_iterator<char>(file), {}};
    count += line.find(text) != std::string::npos;
  }
  return count;
}

bool has_ended(pid_t process) {
  return read_file("/proc/" + std::to_string(process) + "/stat").find(") Z ") != std::string::npos;
}

int number_from(const char* variable, int otherwise) {
  const char* text = std::getenv(variable);
  return text ? std::atoi(text) : otherwise;
}

class KilledRanks : public ManyRanks {
 protected:
  using Clock = std::chrono::steady_clock;

  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  int uniform(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }

  // Goes on with a random number of ranks and kills one of them at a random moment. Returns false
  // where the run ends before.
  bool kill_one_of(const std::string& name, double longest) {
    const int ranks = uniform(2, 3), victim = uniform(0, ranks - 1);
    const bool goes_on = fs::exists(folder(name) / "checkpoint.h5");
    Program program("mpirun",
                    words_of_mpirun(ranks, words_of_run(name, {goes_on ? "--resume" : "--force"})),
                    folder("killed.log"));
    const auto moment = Clock::now() + std::chrono::duration<double>(uniform(0.0, longest));
    wait_for([&] { return Clock::now() > moment || has_ended(program.process()); });
    pid_t process = 0;
    wait_for([&] {
      process = process_of_rank(program.process(), victim);
      return process != 0 || has_ended(program.process());
    });
    const bool killed = process != 0 && kill(process, SIGKILL) == 0;
    const auto start = Clock::now();
    const Ending ending = program.wait();
    if (ending.exit_code == 0) return false;  // the signal came when all was done
    EXPECT_TRUE(killed) << ending.output;
    // A killed process may still return its memory when mpirun ends.
    EXPECT_TRUE(wait_for([&] { return processes_with(folder(name).string()) == 0; }));
    EXPECT_LT(std::chrono::duration<double>(Clock::now() - start).count(), 5.0);
    // The second is what mpirun says of a process that had not begun with MPI.
    const int told = count_of(ending.output, "signal 9");
    const int early = count_of(ending.output, "1 process returned");
    EXPECT_TRUE(told == 1 || (told == 0 && early == 1)) << ending.output;
    return true;
  }

  unsigned seed_ = static_cast<unsigned>(number_from("KERF_SEED", 0));
  std::mt19937 random_{seed_ != 0 ? seed_ : seed_ = std::random_device{}()};
};

TEST_F(KilledRanks, AtRandomMomentsChangeNoBit) {
  write_case(jet_on_strip());
  const auto start = Clock::now();
  ASSERT_EQ(run(2, "alone").exit_code, 0);
  const double longest = 1.1 * std::chrono::duration<double>(Clock::now() - start).count();
  const int wanted = number_from("KERF_KILLS", 200);
  std::printf("KERF_SEED=%u, %d kills, each within %.1f s\n", seed_, wanted, longest);
  int completed = 0, kills = 0;
  while (kills < wanted && !HasFailure()) {
    if (kill_one_of("killed", longest)) {
      ++kills;
      continue;
    }
    expect_same("alone", "killed");
    fs::remove_all(folder("killed"));
    ++completed;
  }
  if (fs::exists(folder("killed") / "checkpoint.h5")) {
    ASSERT_EQ(run(1, "killed", {"--resume"}).exit_code, 0);
    expect_same("alone", "killed");
    ++completed;
  }
  std::printf("%d kills; %d runs completed with the same bits\n", kills, completed);
  EXPECT_GT(completed, 0);
}

TEST_F(Ranks, AFullDiskIsToldOnceAndOtherRanksGoOn) {
  write_case(jet_on_strip());
  ASSERT_EQ(run(0, "alone").exit_code, 0);
  std::size_t size = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder("alone")))
    if (entry.is_regular_file()) size += entry.file_size();
  const SmallDisk disk(folder("disk"), size * 6 / 10);
  if (!disk.there()) GTEST_SKIP() << "mounting a small disk needs root";
  const Ending ending = run(2, "disk/out");
  EXPECT_NE(ending.exit_code, 0);
  EXPECT_THAT(ending.output, AllOf(HasSubstr("No space left on device"), HasSubstr("Free space"),
                                   HasSubstr("--resume")));
  EXPECT_EQ(count_of(ending.output, "No space left on device"), 1) << ending.output;
  EXPECT_EQ(processes_with(folder("disk").string()), 0);
  disk.resize(4 * size);
  ASSERT_EQ(run(0, "disk/out", {"--resume"}).exit_code, 0);
  expect_same("alone", "disk/out");
}

}  // namespace
}  // namespace kerf::test
