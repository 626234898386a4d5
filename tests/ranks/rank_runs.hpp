// SPDX-License-Identifier: Apache-2.0
// Runs of one case with several numbers of ranks, which must have the same bits.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>

#include "output/checkpoint.hpp"
#include "ranks/mpi_program.hpp"
#include "support/results.hpp"
#include "support/runs.hpp"
#include "support/temporary_folder.hpp"

namespace kerf::test {

namespace fs = std::filesystem;

class Ranks : public testing::Test {
 protected:
  fs::path folder(const std::string& name) const { return folder_.path() / name; }
  void write_case(const std::string& text) const { write_file(folder("case.toml"), text); }
  static void skip_unless_scheduled() {
    if (std::getenv("KERF_SCHEDULED") == nullptr) GTEST_SKIP() << "a scheduled test";
  }
  // Runs the case with so many ranks; 0: without mpirun.
  Ending run(int ranks, const std::string& name,
             const std::vector<std::string>& options = {}) const {
    const auto words = words_of_run(name, options);
    if (ranks == 0) return Program(words, folder(name + ".log")).wait();
    return Program("mpirun", words_of_mpirun(ranks, words), folder(name + ".log")).wait();
  }
  std::vector<std::string> words_of_run(const std::string& name,
                                        const std::vector<std::string>& options) const {
    std::vector<std::string> words{
        "run", folder("case.toml").string(), "--out", folder(name).string(), "--threads", "1"};
    words.insert(words.end(), options.begin(), options.end());
    return words;
  }
  void expect_same(const std::string& a, const std::string& b) const {
    expect_same_results(folder(a), folder(b));
    const auto state = [&](const std::string& name) {
      return read_checkpoint(folder(name) / "checkpoint.h5",
                             read_file(folder(name) / "case.used.toml"))
          .simulation;
    };
    expect_same_state(state(a), state(b));
  }
  void expect_same_for(const std::vector<int>& numbers) const {
    ASSERT_EQ(run(0, "alone").exit_code, 0);
    for (const int ranks : numbers) {
      const std::string name = "ranks-" + std::to_string(ranks);
      const Ending ending = run(ranks, name);
      ASSERT_EQ(ending.exit_code, 0) << ending.output;
      expect_same("alone", name);
    }
  }
  // Sends a signal to a rank after a while and goes on with other numbers of ranks.
  void expect_same_resumed(const std::vector<int>& numbers, int signal, int rank) const {
    ASSERT_EQ(run(0, "alone").exit_code, 0);
    for (std::size_t n = 0; n < numbers.size(); ++n) {
      std::vector<std::string> options;
      if (n > 0) options.push_back("--resume");
      if (n + 1 < numbers.size())
        signal_after_frames(numbers[n], 2 * n + 2, options, signal, rank);
      else
        ASSERT_EQ(run(numbers[n], "resumed", options).exit_code, 0);
    }
    expect_same("alone", "resumed");
  }

 private:
  void signal_after_frames(int ranks, std::size_t frames, const std::vector<std::string>& options,
                           int signal, int rank) const {
    Program program("mpirun", words_of_mpirun(ranks, words_of_run("resumed", options)),
                    folder("resumed.log"));
    const fs::path written = folder("resumed") / "frames";
    ASSERT_TRUE(wait_for([&] { return fs::exists(written) && names_in(written).size() > frames; }));
    ASSERT_EQ(kill(process_of_rank(program.process(), rank), signal), 0);
    const Ending ending = program.wait();
    EXPECT_EQ(ending.exit_code, 128 + signal) << ending.output;
    ASSERT_FALSE(fs::exists(folder("resumed") / "result.json")) << "it had ended before";
  }

  TemporaryFolder folder_;
};

// More ranks than a small machine has cores: ctest -C scheduled -R ranks
class ManyRanks : public Ranks {
 protected:
  void SetUp() override { skip_unless_scheduled(); }
};
}  // namespace kerf::test
