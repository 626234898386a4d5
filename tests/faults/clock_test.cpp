// SPDX-License-Identifier: Apache-2.0
// Runs and studies do not depend on the clock of the system, which may be set while they run: it
// only dates entries of the log and of study.db. Debian: libfaketime.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>

#include "faults/program.hpp"
#include "studies/small_study.hpp"
#include "support/results.hpp"
#include "support/temporary_folder.hpp"

namespace kerf::test {
namespace {

namespace fs = std::filesystem;

fs::path clock_library() {
  for (const char* place : {"/usr/lib/x86_64-linux-gnu", "/usr/lib/aarch64-linux-gnu", "/usr/lib"})
    if (const fs::path file = fs::path(place) / "faketime/libfaketimeMT.so.1"; fs::exists(file))
      return file;
  const char* chosen = std::getenv("KERF_FAKETIME");
  return chosen != nullptr ? fs::path(chosen) : fs::path();
}

// Programs that are started while it lives see a clock that is set forwards and backwards by months
// 50 times a second.
class JumpingClock {
 public:
  explicit JumpingClock(const fs::path& folder) : file_(folder / "clock.txt") {
    write_file(file_, "+0d");
    for (const auto& [name, value] : variables()) setenv(name.c_str(), value.c_str(), 1);
    setter_ = std::thread([this] {
      for (int n = 0; !ends_; ++n) {
        constexpr std::array offsets{"+0d", "+100d", "-100d", "+1d"};
        write_file(file_, offsets[static_cast<std::size_t>(n) % offsets.size()]);
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
      }
    });
  }
  ~JumpingClock() {
    ends_ = true;
    setter_.join();
    for (const auto& [name, value] : variables()) unsetenv(name.c_str());
  }
  JumpingClock(const JumpingClock&) = delete;
  JumpingClock& operator=(const JumpingClock&) = delete;

 private:
  // Setting the clock of a system does not touch its monotonic clock.
  std::vector<std::pair<std::string, std::string>> variables() const {
    return {{"LD_PRELOAD", clock_library().string()},
            {"FAKETIME_TIMESTAMP_FILE", file_.string()},
            {"FAKETIME_NO_CACHE", "1"},
            {"DONT_FAKE_MONOTONIC", "1"},
            {"FAKETIME_DONT_FAKE_MONOTONIC", "1"}};
  }

  fs::path file_;
  std::atomic<bool> ends_ = false;
  std::thread setter_;
};

class SetClock : public testing::Test {
 protected:
  void SetUp() override {
    if (clock_library().empty()) GTEST_SKIP() << "there is no libfaketime";
    write_file(folder_ / "small.toml", small_study_case);
  }
  Ending run(std::vector<std::string> words, const std::string& out) const {
    words.insert(words.end(), {"--out", (folder_ / out).string(), "--quiet"});
    return Program(words, folder_ / "output.txt").wait();
  }
  TemporaryFolder folder_;
};

TEST_F(SetClock, ARunHasTheSameResult) {
  const std::string file = (folder_ / "small.toml").string();
  ASSERT_EQ(run({"run", file}, "a").exit_code, 0);
  const JumpingClock clock(folder_.path());
  const auto start = std::chrono::steady_clock::now();
  const Ending ending = run({"run", file}, "b");
  ASSERT_EQ(ending.exit_code, 0) << ending.output;
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::minutes(1));
  expect_same_results(folder_ / "a", folder_ / "b");
}

TEST_F(SetClock, AStudyEndsAllItsRuns) {
  write_file(folder_ / "map.toml",
             "base = \"small.toml\"\n[vary]\n\"jet.jet.speed\" = [\"2 m/s\", \"9 m/s\"]\n");
  const JumpingClock clock(folder_.path());
  const Ending ending = run({"study", (folder_ / "map.toml").string()}, "out");
  EXPECT_EQ(ending.exit_code, 0) << ending.output;
  EXPECT_THAT(ending.output, testing::AllOf(testing::HasSubstr("  not cut through  "),
                                            testing::HasSubstr("  cut through  "),
                                            testing::Not(testing::HasSubstr("failed"))));
}

}  // namespace
}  // namespace kerf::test
