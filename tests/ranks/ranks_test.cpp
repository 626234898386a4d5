// SPDX-License-Identifier: Apache-2.0
// Results of several ranks have the same bits as those of one, also when ranks go on with the
// checkpoint of another number of ranks. What cannot be divided is refused once, with the reason.
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
namespace {

namespace fs = std::filesystem;

// The water leaves the step, runs along the floor and meets the wall; it is divided anew as it
// spreads.
constexpr const char* dam_break = R"(title = "Dam break"
dimension = 2
gravity = ["0 m/s2", "-9.81 m/s2"]
[time]
end = "70 ms"
[domain]
minimum = ["-20 mm", "-20 mm"]
maximum = ["220 mm", "160 mm"]
[[body]]
name = "water"
material = "slow-water"
shape = { type = "box", minimum = ["0 mm", "0 mm"], maximum = ["60 mm", "60 mm"] }
spacing = "2 mm"
[[body]]
name = "tank"
role = "rigid"
spacing = "2 mm"
[body.shape]
type = "difference"
parts = [
  { type = "box", minimum = ["-8 mm", "-8 mm"], maximum = ["208 mm", "120 mm"] },
  { type = "box", minimum = ["0 mm", "0 mm"], maximum = ["200 mm", "130 mm"] },
]
[materials."slow-water"]
base = "water"
sound_speed = "15 m/s"
source = "water of the library with the speed of sound of ten times its fastest motion"
[[probe]]
name = "middle"
position = ["20 mm", "10 mm"]
[[probe]]
name = "cut"
kind = "plane"
position = ["50 mm", "0 mm"]
normal = [1, 0]
[output]
frame_interval = "20 ms"
series_interval = "2 ms"
)";

// Inflow, outflow, a symmetry plane and a pump that feels the pressure at its exit.
std::string jet_on_plate(int dimension) {
  const bool flat = dimension == 2;
  const auto point = [&](const char* two, const char* third) {
    return std::string("[") + two + (flat ? "" : std::string(", ") + third) + "]";
  };
  return "title = \"Jet on a plate\"\ndimension = " + std::to_string(dimension) +
         "\n[time]\nend = \"" + (flat ? "3 ms" : "2 ms") +
         "\"\n[domain]\nminimum = " + point("\"0 mm\", \"-6 mm\"", "\"-12 mm\"") +
         "\nmaximum = " + point("\"12 mm\", \"14 mm\"", "\"12 mm\"") +
         "\nsymmetry = [\"x-\"]\n[[body]]\nname = \"plate\"\nrole = \"rigid\"\nspacing = \"" +
         (flat ? "0.4 mm" : "0.5 mm") +
         "\"\nshape = { type = \"box\", minimum = " + point("\"-10 mm\", \"-4 mm\"", "\"-10 mm\"") +
         ", maximum = " + point("\"10 mm\", \"0 mm\"", "\"10 mm\"") +
         " }\n[[jet]]\nname = \"jet\"\nmaterial = \"water\"\nspeed = \"10 m/s\"\n" +
         (flat ? "width" : "diameter") +
         " = \"4 mm\"\nposition = " + point("\"0 mm\", \"0 mm\"", "\"0 mm\"") +
         "\nstandoff = \"4 mm\"\nspacing = \"" + (flat ? "0.4 mm" : "0.5 mm") +
         "\"\n[[probe]]\nname = \"stagnation\"\nposition = " +
         point("\"0 mm\", \"0.8 mm\"", "\"0 mm\"") +
         "\n[output]\nframe_interval = \"0.5 ms\"\nseries_interval = \"0.1 ms\"\n";
}

class Ranks : public testing::Test {
 protected:
  fs::path folder(const std::string& name) const { return folder_.path() / name; }
  void write_case(const std::string& text) const { write_file(folder("case.toml"), text); }
  // Runs the case with so many ranks; 0: without mpirun.
  Ending run(int ranks, const std::string& name,
             const std::vector<std::string>& options = {}) const {
    const auto words = words_of_run(name, options);
    if (ranks == 0) return Program(words, folder(name + ".log")).wait();
    return Program("mpirun", words_of_mpirun(ranks, words), folder(name + ".log")).wait();
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
  std::vector<std::string> words_of_run(const std::string& name,
                                        const std::vector<std::string>& options) const {
    std::vector<std::string> words{
        "run", folder("case.toml").string(), "--out", folder(name).string(), "--threads", "1"};
    words.insert(words.end(), options.begin(), options.end());
    return words;
  }
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

TEST_F(Ranks, DamBreakHasTheSameBits) {
  write_case(dam_break);
  expect_same_for({1, 2, 3});
}
TEST_F(Ranks, JetHasTheSameBits) {
  write_case(jet_on_plate(2));
  expect_same_for({2, 3});
}
TEST_F(Ranks, JetInSpaceHasTheSameBits) {
  write_case(jet_on_plate(3));
  expect_same_for({2, 3});
}
TEST_F(Ranks, AnotherNumberGoesOnWithTheSameBits) {
  write_case(jet_on_plate(2));
  expect_same_resumed({2, 3, 1}, SIGTERM, 0);
}
// All ranks end with the one that is killed; what was saved before is enough to go on.
TEST_F(Ranks, AKilledRankEndsAllAndTheRunGoesOnWithTheSameBits) {
  write_case(jet_on_plate(2) + "checkpoint_interval = \"0.01 s\"\n");
  expect_same_resumed({3, 2}, SIGKILL, 1);
}

TEST_F(Ranks, WhatIsNotDividedIsRefusedOnceWithTheReason) {
  const std::string jet = jet_on_plate(2);
  const std::string plate = "role = \"rigid\"", block = "material = \"tofu\"";
  std::string deformable = jet;
  deformable.replace(deformable.find(plate), plate.size(), block);
  for (const auto& [text, reason] :
       {std::pair{deformable, "the body 'plate' deforms"},
        std::pair{read_file(fs::path(KERF_SOURCE_DIR) / "cases" / "column-on-wall.toml"),
                  "'shinohara2004'"},
        std::pair{jet + "[numerics]\nwater = \"delta_sph\"\n", "numerics.water"}}) {
    write_case(text);
    const Ending ending = run(2, "refused");
    EXPECT_NE(ending.exit_code, 0);
    const auto at = ending.output.find(reason);
    ASSERT_NE(at, std::string::npos) << ending.output;
    EXPECT_EQ(ending.output.find(reason, at + 1), std::string::npos) << ending.output;
  }
}
TEST_F(Ranks, OtherCommandsAndOptionsAreRefused) {
  write_case(jet_on_plate(2));
  EXPECT_NE(run(2, "refused", {"--converge"}).output.find("--converge"), std::string::npos);
  const Ending ending =
      Program("mpirun", words_of_mpirun(2, {"check", folder("case.toml").string()}),
              folder("check.log"))
          .wait();
  EXPECT_NE(ending.exit_code, 0);
  EXPECT_NE(ending.output.find("only 'kerf run'"), std::string::npos) << ending.output;
}

// More ranks than a small machine has cores: ctest -C scheduled -R ranks
class ManyRanks : public Ranks {
 protected:
  void SetUp() override {
    if (std::getenv("KERF_SCHEDULED") == nullptr) GTEST_SKIP() << "a scheduled test";
  }
};
TEST_F(ManyRanks, DamBreakHasTheSameBits) {
  write_case(dam_break);
  expect_same_for({5, 8});
}
TEST_F(ManyRanks, JetInSpaceHasTheSameBits) {
  write_case(jet_on_plate(3));
  expect_same_for({5, 8});
}

}  // namespace
}  // namespace kerf::test
