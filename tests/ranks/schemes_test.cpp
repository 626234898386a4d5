// SPDX-License-Identifier: Apache-2.0
// Graded bodies, windows that travel and settling under a load have the same bits for any number of
// ranks.
#include "ranks/graded_block.hpp"
#include "ranks/rank_runs.hpp"
#include "support/travelling.hpp"

namespace kerf::test {
namespace {

// A jet on a graded block in space, beside two planes of symmetry.
constexpr const char* jet_on_graded_block_in_space = R"(title = "Jet on a graded block in space"
dimension = 3
[time]
end = "1 ms"
[domain]
minimum = ["0 mm", "-10 mm", "0 mm"]
maximum = ["30 mm", "30 mm", "30 mm"]
symmetry = ["x-", "z-"]
[materials.curd]
base = "tofu"
poisson_ratio = 0.49
criterion = "crack_band"
failure_strain = 0.05
fracture_energy = "10 J/m2"
[[body]]
name = "block"
material = "curd"
shape = { type = "box", minimum = ["-24 mm", "0 mm", "-24 mm"], maximum = ["24 mm", "12 mm", "24 mm"] }
spacing = "1 mm"
grading = { levels = 2, width = "8 mm" }
[[jet]]
name = "jet"
material = "water"
speed = "30 m/s"
diameter = "6 mm"
position = ["0 mm", "12 mm", "0 mm"]
standoff = "6 mm"
spacing = "1 mm"
[output]
frame_interval = "0.25 ms"
series_interval = "0.1 ms"
)";

// A beam sags under its weight; the motion is taken from it until it is at rest.
constexpr const char* sagging_beam = R"(title = "A beam settles under its weight"
dimension = 2
gravity = ["0 m/s2", "-9.81 m/s2"]
[time]
end = "20 ms"
relax = "16 ms"
[domain]
minimum = ["-20 mm", "-40 mm"]
maximum = ["70 mm", "20 mm"]
[[body]]
name = "beam"
material = "rubber"
shape = { type = "box", minimum = ["0 mm", "0 mm"], maximum = ["48 mm", "8 mm"] }
spacing = "2 mm"
[[body]]
name = "wall"
material = "rubber"
joined_to = "beam"
spacing = "2 mm"
shape = { type = "box", minimum = ["-8 mm", "0 mm"], maximum = ["0 mm", "8 mm"] }
displacement_expression = ["0", "0"]
[output]
frame_interval = "10 ms"
series_interval = "2 ms"
)";

class SchemesOnRanks : public Ranks {
 protected:
  static constexpr const char* outputs =
      "[output]\nframe_interval = \"0.2 ms\"\nseries_interval = \"0.1 ms\"\n";

  void expect_same_with_debris(const char* text) const {
    write_case(text);
    expect_same_for({2, 3});
    EXPECT_GT(result_without_clock(folder("alone")).at("fractured_fraction").get<double>(), 0.001);
  }
};

TEST_F(SchemesOnRanks, GradedBlockHasTheSameBits) {
  expect_same_with_debris(jet_on_graded_block);
}
TEST_F(SchemesOnRanks, GradedBlockInSpaceHasTheSameBits) {
  expect_same_with_debris(jet_on_graded_block_in_space);
}
TEST_F(SchemesOnRanks, AnotherNumberGoesOnWithAGradedBlock) {
  write_case(jet_on_graded_block);
  expect_same_resumed({2, 3, 1}, SIGTERM, 0);
}
// The window moves on seven times.
TEST_F(SchemesOnRanks, ATravellingWindowHasTheSameBits) {
  write_case(TravellingText{.rest = outputs}.text());
  expect_same_for({2, 3});
}
TEST_F(SchemesOnRanks, AnotherNumberGoesOnInATravellingWindow) {
  write_case(TravellingText{.rest = outputs}.text());
  expect_same_resumed({2, 3, 1}, SIGTERM, 0);
}
TEST_F(SchemesOnRanks, ABeamSettlesWithTheSameBits) {
  write_case(sagging_beam);
  expect_same_for({2, 3});
}

// ctest -C scheduled -R ranks
class SchemesOnManyRanks : public SchemesOnRanks {
 protected:
  void SetUp() override { skip_unless_scheduled(); }
};
TEST_F(SchemesOnManyRanks, GradedBlockInSpaceHasTheSameBits) {
  write_case(jet_on_graded_block_in_space);
  expect_same_for({5, 8});
}
TEST_F(SchemesOnManyRanks, ATravellingGradedWindowInSpaceHasTheSameBits) {
  TravellingText text = graded_window();
  text.rest = outputs;
  write_case(text.text());
  expect_same_for({2, 5});
}

}  // namespace
}  // namespace kerf::test
