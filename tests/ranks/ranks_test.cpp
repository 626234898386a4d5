// SPDX-License-Identifier: Apache-2.0
// Results of several ranks have the same bits as those of one, also when ranks go on with the
// checkpoint of another number of ranks. What cannot be divided is refused once, with the reason.
#include "ranks/rank_runs.hpp"

namespace kerf::test {
namespace {

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

TEST_F(Ranks, DamBreakHasTheSameBits) {
  write_case(dam_break);
  expect_same_for({1, 2, 3});
}
TEST_F(Ranks, DamBreakByDeltaSphHasTheSameBits) {
  write_case(dam_break + std::string("[numerics]\nwater = \"delta_sph\"\n"));
  expect_same_for({2, 3});
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
  const std::string reason = "'shinohara2004'";
  write_case(read_file(fs::path(KERF_SOURCE_DIR) / "cases" / "column-on-wall.toml"));
  const Ending ending = run(2, "refused");
  EXPECT_NE(ending.exit_code, 0);
  const auto at = ending.output.find(reason);
  ASSERT_NE(at, std::string::npos) << ending.output;
  EXPECT_EQ(ending.output.find(reason, at + 1), std::string::npos) << ending.output;
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
