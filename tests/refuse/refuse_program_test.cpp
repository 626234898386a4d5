// SPDX-License-Identifier: Apache-2.0
// Exit codes of the program, the streams of its messages, and its printed tables.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>

#include "parallel/ranks.hpp"

namespace kerf {
namespace {

struct Outcome {
  int code;
  std::string output;  // stdout, or stderr when asked for
};

// `before`: commands of the shell before the program.
Outcome run(const std::string& arguments, bool errors = false, const std::string& before = "") {
  const std::string command = before + std::string(KERF_PROGRAM) + " " + arguments +
                              (errors ? " 2>&1 >/dev/null" : " 2>/dev/null");
  FILE* pipe = popen(command.c_str(), "r");
  if (!pipe) return {-1, {}};
  std::string output;
  std::array<char, 4096> block;
  std::size_t read;
  while ((read = fread(block.data(), 1, block.size(), pipe)) > 0) output.append(block.data(), read);
  return {WEXITSTATUS(pclose(pipe)), output};
}

std::string contents(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

// An empty name, as of a variable of a script that is not set, is not the default.
TEST(RefuseProgram, AFolderWithoutAName) {
  for (const char* command : {"run", "study", "limit"}) {
    const Outcome outcome = run(std::string(command) + " no-such.toml --out \"\"", true);
    EXPECT_EQ(outcome.code, 2) << command;
    EXPECT_NE(outcome.output.find("--out: the folder has no name"), std::string::npos)
        << outcome.output;
  }
}

TEST(RefuseProgram, BadCasesEndWithOneAndAMessage) {
  const auto file = std::filesystem::path(testing::TempDir()) / "kerf-bad-case.toml";
  std::ofstream(file) << "title = \"bad\"\ndimension = 2\nsped = 1\n";
  const Outcome outcome = run("check " + file.string(), true);
  EXPECT_EQ(outcome.code, 1);
  EXPECT_EQ(outcome.output.rfind("kerf: error: " + file.string() + ":", 0), 0u) << outcome.output;
  EXPECT_NE(outcome.output.find("toml:3: sped = 1: the key is unknown."), std::string::npos);
  std::filesystem::remove(file);
}

TEST(RefuseProgram, MisspelledArgumentsAreGuessed) {
  const Outcome command = run("chek", true);
  EXPECT_EQ(command.code, 2);
  EXPECT_NE(command.output.find("Did you mean check instead of chek?"), std::string::npos);
  const Outcome far = run("conditions", true);  // like no command
  EXPECT_EQ(far.code, 2);
  EXPECT_NE(far.output.find("no command \"conditions\". Allowed: new, check, run"),
            std::string::npos)
      << far.output;
  const Outcome option = run("run --treads 2 my.toml", true);
  EXPECT_EQ(option.code, 2);
  EXPECT_NE(option.output.find("Did you mean --threads instead of --treads?"), std::string::npos);
  const Outcome name = run("new foam", true);
  EXPECT_EQ(name.code, 1);
  EXPECT_NE(name.output.find("Did you mean \"foam-"), std::string::npos);
}

// A verification case that is named is not left out: the message has its reason and what it allows.
TEST(RefuseProgram, RanksNeedAProgramThatHasThem) {
  const Outcome here = run("run my.toml --ranks 3", true);
  EXPECT_EQ(here.code, 1);
  EXPECT_NE(here.output.find("mpirun -n 3 kerf run"), std::string::npos) << here.output;
  if (ranks::exist) return;
  const Outcome cluster = run("run my.toml --on slurm --ranks 3", true);
  EXPECT_EQ(cluster.code, 1);
  EXPECT_NE(cluster.output.find("preset mpi"), std::string::npos) << cluster.output;
}

TEST(RefuseProgram, MovesThatACaseDoesNotAllowAreNamedWithTheReason) {
  const Outcome moved =
      run("verify standard-wall-beside-jet --turned '20 deg' --mirrored --moved 0.3", true);
  EXPECT_EQ(moved.code, 1);
  EXPECT_NE(moved.output.find("standard-wall-beside-jet cannot be turned 20 deg, mirrored, moved "
                              "0.3 d: the jet touches the wall"),
            std::string::npos)
      << moved.output;
  EXPECT_NE(moved.output.find("Of this it can be turned 20 deg, mirrored: leave out the rest"),
            std::string::npos)
      << moved.output;
  const Outcome turned = run("verify standard-kalthoff --turned '20 deg'", true);
  EXPECT_EQ(turned.code, 1);
  EXPECT_NE(turned.output.find("asymmetry"), std::string::npos) << turned.output;
  EXPECT_NE(turned.output.find("Leave out --turned"), std::string::npos) << turned.output;
}

TEST(RefuseProgram, UnknownExperimentsAreGuessed) {
  const Outcome outcome = run("verify --experiments beef-heiland1900", true);
  EXPECT_EQ(outcome.code, 1);
  EXPECT_NE(outcome.output.find("there is no experiment \"beef-heiland1900\""), std::string::npos)
      << outcome.output;
  EXPECT_NE(outcome.output.find("Did you mean \"beef-heiland1990\"?"), std::string::npos);
  const Outcome other = run("verify beef-heiland1990", true);
  EXPECT_EQ(other.code, 1);
  EXPECT_NE(other.output.find("is a published experiment: add --experiments"), std::string::npos)
      << other.output;
}

// A row with an interval takes it from other runs, so one run alone would pass without any
// judgement.
TEST(RefuseProgram, RunsThatJudgeNoRowAreRefusedWithWhatTheyLack) {
  const Outcome outcome =
      run("verify --experiments muscle-zhao2025 --run '1.1 MPa' --threads 1", true);
  EXPECT_EQ(outcome.code, 1);
  EXPECT_NE(outcome.output.find("these runs alone judge no row"), std::string::npos)
      << outcome.output;
  EXPECT_NE(outcome.output.find("1.1 MPa, strength along the fibres"), std::string::npos)
      << outcome.output;
}

TEST(RefuseProgram, MissingFilesEndWithFour) {
  const Outcome outcome = run("check /nowhere/case.toml", true);
  EXPECT_EQ(outcome.code, 4);
  EXPECT_NE(outcome.output.find("/nowhere/case.toml: the case file cannot be read"),
            std::string::npos);
}

TEST(RefuseProgram, WrongUseEndsWithTwo) {
  EXPECT_EQ(run("").code, 2);
  EXPECT_EQ(run("chekc").code, 2);
  EXPECT_EQ(run("check").code, 2);
  EXPECT_EQ(run("check --threads -3 case.toml").code, 2);
}

TEST(RefuseProgram, NumbersOfRanksAndNetworksBeyondTheirRange) {
  const std::string words = "check --no-timing " KERF_SOURCE_DIR "/cases/tofu-5ms.toml ";
  for (const auto& [option, range] : {std::pair{"--ranks 0", "1 to 10000"},
                                      {"--ranks 10001", "1 to 10000"},
                                      {"--ranks many", "1 to 10000"},
                                      {"--ranks 8 --latency 0", "0.01 to 1000000"},
                                      {"--ranks 8 --bandwidth -1", "0.001 to 100000"}}) {
    const Outcome outcome = run(words + option, true);
    EXPECT_EQ(outcome.code, 2) << option;
    EXPECT_NE(outcome.output.find(std::string("Allowed: ") + range), std::string::npos)
        << outcome.output;
  }
  EXPECT_EQ(run(words + "--latency 2").code, 2);  // of no ranks
}

// Without MPI a case cannot be divided.
TEST(RefuseProgram, RanksOfABuildWithoutThem) {
  if (ranks::exist) GTEST_SKIP() << "a build with MPI";
  const Outcome outcome =
      run("check --no-timing --ranks 8 " KERF_SOURCE_DIR "/cases/tofu-5ms-standard.toml", true);
  EXPECT_EQ(outcome.code, 1);
  for (const char* part : {"tofu-5ms-standard.toml: --ranks 8", "Allowed", "--preset mpi"})
    EXPECT_NE(outcome.output.find(part), std::string::npos) << outcome.output;
}

// Names become part of JSON, which is UTF-8.
TEST(RefuseProgram, NamesInOtherEncodingsEndWithTwo) {
  const Outcome outcome = run("check 'b\xe4r.toml'", true);
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.output.find("the word is not valid UTF-8"), std::string::npos)
      << outcome.output;
}

// Libraries end the program by a signal where the address space ends, so it is measured first.
TEST(RefuseProgram, SmallLimitsEndWithThree) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "the sanitizers reserve terabytes of addresses";
#endif
  const std::string words = "check --no-timing " KERF_SOURCE_DIR "/cases/tofu-5ms.toml";
  for (const char* limit : {"ulimit -v 120000", "ulimit -d 60000", "ulimit -s 500"}) {
    const Outcome outcome = run(words, true, std::string(limit) + "; ");
    EXPECT_EQ(outcome.code, 3) << limit;
    for (const std::string& part : {std::string("there is not enough memory"),
                                    std::string(limit, 9), std::string("Raise the limit")})
      EXPECT_NE(outcome.output.find(part), std::string::npos) << outcome.output;
  }
}

TEST(RefuseProgram, UnknownTemplatesAndMaterials) {
  const Outcome material = run("materials tofo", true);
  EXPECT_EQ(material.code, 1);
  EXPECT_NE(material.output.find("Did you mean \"tofu\"?"), std::string::npos);
  const Outcome start = run("new tofu-5m", true);
  EXPECT_EQ(start.code, 1);
  EXPECT_NE(start.output.find("Did you mean \"tofu-5ms\"?"), std::string::npos);
}

TEST(Program, TemplatesAreTheFilesOfCases) {
  for (const auto& entry : std::filesystem::directory_iterator(KERF_SOURCE_DIR "/cases")) {
    if (entry.path().extension() != ".toml") continue;
    const Outcome outcome = run("new " + entry.path().stem().string());
    EXPECT_EQ(outcome.code, 0);
    EXPECT_EQ(outcome.output, contents(entry.path())) << entry.path();
    EXPECT_NE(run("new").output.find(entry.path().stem().string()), std::string::npos);
  }
}

TEST(Program, KeysPageIsPrinted) {
  EXPECT_EQ(run("check --keys").output, contents(KERF_SOURCE_DIR "/docs/keys.md"));
}

TEST(Program, ChecksACase) {
  const Outcome outcome = run("check --no-timing " KERF_SOURCE_DIR "/cases/tofu-5ms.toml");
  EXPECT_EQ(outcome.code, 0);
  for (const char* part : {"crack-led", "0.8428", "2872", "water can pass"})
    EXPECT_NE(outcome.output.find(part), std::string::npos) << part;
}

// Every built-in case runs, and its speed is a number.
TEST(Program, BenchRunsEveryCase) {
  const auto file = std::filesystem::path(testing::TempDir()) / "kerf-bench.json";
  ASSERT_EQ(run("bench --seconds 0.1 --json " + file.string()).code, 0);
  const auto figures = nlohmann::json::parse(contents(file.string()));
  ASSERT_EQ(figures.at("loads").size(), 6u);
  for (const auto& load : figures.at("loads")) {
    EXPECT_GT(load.at("particles").get<int>(), 1000) << load;
    EXPECT_GT(load.at("particle_steps_per_second").get<double>(), 0.0) << load;
    EXPECT_GT(load.at("neighbours_per_particle").get<double>(), 5.0) << load;
  }
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace kerf
