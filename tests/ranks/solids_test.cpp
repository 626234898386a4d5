// SPDX-License-Identifier: Apache-2.0
// Solids that deform, flow, soften, break and touch have the same bits for any number of ranks. In
// each case bonds break, and debris of one rank meets the solid of another.
#include "ranks/rank_runs.hpp"

namespace kerf::test {
namespace {

// A jet splits a soft block whose stiffness is for the most part in its density.
constexpr const char* jet_on_block = R"(title = "Jet on a block"
dimension = 2
[time]
end = "28 ms"
[domain]
minimum = ["-150 mm", "-20 mm"]
maximum = ["150 mm", "100 mm"]
[materials.curd]
base = "tofu"
poisson_ratio = 0.493
criterion = "crack_band"
failure_strain = 0.05
fracture_energy = "10 J/m2"
artificial_linear = 0.2
artificial_quadratic = 0.5
[[body]]
name = "block"
material = "curd"
shape = { type = "box", minimum = ["-50 mm", "0 mm"], maximum = ["50 mm", "50 mm"] }
spacing = "2 mm"
[[body]]
name = "plate"
role = "rigid"
shape = { type = "box", minimum = ["-62 mm", "-8 mm"], maximum = ["62 mm", "0 mm"] }
spacing = "2 mm"
[[jet]]
name = "jet"
material = "water"
speed = "5 m/s"
width = "10 mm"
position = ["0 mm", "50 mm"]
standoff = "20 mm"
feed = "flow"
spacing = "2 mm"
[output]
frame_interval = "4 ms"
series_interval = "0.5 ms"
)";

// A metal ball crushes rock whose strength grows with the rate of strain and that is bonded to
// concrete, which absorbs waves, beside a plane of symmetry; a part leaves the domain.
constexpr const char* ball_on_rock = R"(title = "A ball meets rock on concrete"
dimension = 2
[time]
end = "30 us"
[domain]
minimum = ["0 mm", "-14 mm"]
maximum = ["14 mm", "12 mm"]
symmetry = ["x-"]
[materials.rock]
base = "granite"
strength_rate_exponent = 0.05
strength_reference_rate = "1 s-1"
[[body]]
name = "rock"
material = "rock"
shape = { type = "box", minimum = ["-12.8 mm", "-4 mm"], maximum = ["12.8 mm", "0 mm"] }
spacing = "0.4 mm"
[[body]]
name = "base"
material = "concrete"
joined_to = "rock"
absorbing = ["x+"]
shape = { type = "box", minimum = ["-12.8 mm", "-8 mm"], maximum = ["12.8 mm", "-4 mm"] }
spacing = "0.4 mm"
[[load]]
kind = "pressure"
body = "base"
shape = { type = "box", minimum = ["-13 mm", "-8.2 mm"], maximum = ["13 mm", "-7.8 mm"] }
pressure = "20 MPa"
[[load]]
kind = "body_force"
body = "rock"
acceleration = ["0 m/s2", "-9.81 m/s2"]
[[body]]
name = "ball"
material = "aluminium-6061"
shape = { type = "disc", centre = ["0 mm", "5.2 mm"], radius = "4.8 mm" }
spacing = "0.4 mm"
velocity = ["0 m/s", "-600 m/s"]
[[probe]]
name = "below"
kind = "plane"
position = ["0 mm", "-2.1 mm"]
normal = [0.1, -1]
[output]
frame_interval = "10 us"
series_interval = "1 us"
)";

// Cracks grow from flaws in a bar that is pulled.
constexpr const char* pulled_bar = R"(title = "A bar of rock is pulled"
dimension = 2
[time]
end = "12 us"
maximum_step = "0.1 us"
[domain]
minimum = ["-40 mm", "-20 mm"]
maximum = ["40 mm", "20 mm"]
[materials.rock]
kind = "elastic"
density = "2700 kg/m3"
youngs_modulus = "57 GPa"
poisson_ratio = 0
criterion = "grady_kipp"
weibull_k = "5e34 m-3"
weibull_m = 8.5
source = "Benz & Asphaug, 1994"
[[body]]
name = "bar"
material = "rock"
spacing = "0.5 mm"
shape = { type = "box", minimum = ["-20 mm", "-5 mm"], maximum = ["20 mm", "5 mm"] }
velocity_expression = ["100*x", "0"]
[[body]]
name = "grip"
material = "rock"
spacing = "0.5 mm"
shape = { type = "box", minimum = ["20 mm", "-5 mm"], maximum = ["23 mm", "5 mm"] }
joined_to = "bar"
displacement_expression = ["100*0.0205*t", "0"]
[output]
frame_interval = "4 us"
series_interval = "0.5 us"
)";

// A jet pierces a block, half of which is computed.
constexpr const char* jet_on_block_in_space = R"(title = "Jet on a block in space"
dimension = 3
[time]
end = "1.6 ms"
[domain]
minimum = ["0 mm", "-10 mm", "-20 mm"]
maximum = ["20 mm", "30 mm", "20 mm"]
symmetry = ["x-"]
[materials.curd]
base = "tofu"
poisson_ratio = 0.45
criterion = "crack_band"
failure_strain = 0.05
fracture_energy = "10 J/m2"
[[body]]
name = "block"
material = "curd"
shape = { type = "box", minimum = ["-12 mm", "0 mm", "-12 mm"], maximum = ["12 mm", "12 mm", "12 mm"] }
spacing = "1.5 mm"
[[body]]
name = "plate"
role = "rigid"
shape = { type = "box", minimum = ["-16.5 mm", "-6 mm", "-16.5 mm"], maximum = ["16.5 mm", "0 mm", "16.5 mm"] }
spacing = "1.5 mm"
[[jet]]
name = "jet"
material = "water"
speed = "30 m/s"
diameter = "6 mm"
position = ["0 mm", "12 mm", "0 mm"]
standoff = "6 mm"
spacing = "1.5 mm"
[output]
frame_interval = "0.4 ms"
series_interval = "0.1 ms"
)";

// A block slides on another, pressed by a load that turns with its surface; the contact crosses the
// border of the ranks.
std::string block_on_block(const char* pressure) {
  return R"(title = "A block is pressed onto another"
dimension = 2
[time]
end = "3 ms"
[domain]
minimum = ["-40 mm", "-20 mm"]
maximum = ["40 mm", "30 mm"]
[[body]]
name = "lower"
material = "rubber"
shape = { type = "box", minimum = ["-20 mm", "-10 mm"], maximum = ["20 mm", "0 mm"] }
spacing = "1 mm"
[[body]]
name = "upper"
material = "rubber"
shape = { type = "box", minimum = ["-20 mm", "0 mm"], maximum = ["20 mm", "10 mm"] }
spacing = "1 mm"
velocity = ["0.5 m/s", "-1 m/s"]
[[load]]
kind = "pressure"
body = "upper"
shape = { type = "box", minimum = ["-21 mm", "9.5 mm"], maximum = ["21 mm", "10.5 mm"] }
pressure = ")" +
         std::string(pressure) + R"("
[output]
frame_interval = "1 ms"
series_interval = "0.1 ms"
)";
}

class SolidsOnRanks : public Ranks {
 protected:
  // What the case is for: some of the solid is debris at the end.
  void expect_debris(const std::string& name) const {
    EXPECT_GT(result_without_clock(folder(name)).at("fractured_fraction").get<double>(), 0.005);
  }
  void expect_same_with_debris(const std::string& text, const std::vector<int>& numbers) const {
    write_case(text);
    expect_same_for(numbers);
    expect_debris("alone");
  }
};

TEST_F(SolidsOnRanks, SplitBlockHasTheSameBits) {
  expect_same_with_debris(jet_on_block, {1, 2, 3});
}
TEST_F(SolidsOnRanks, CrushedRockHasTheSameBits) {
  expect_same_with_debris(ball_on_rock, {2, 3});
}
TEST_F(SolidsOnRanks, GrowingFlawsHaveTheSameBits) {
  expect_same_with_debris(pulled_bar, {2, 3});
}
TEST_F(SolidsOnRanks, PiercedBlockInSpaceHasTheSameBits) {
  expect_same_with_debris(jet_on_block_in_space, {2, 3});
}
TEST_F(SolidsOnRanks, BlocksInContactHaveTheSameBits) {
  write_case(block_on_block("20 kPa"));
  expect_same_for({2, 3});
}
// The load drives all of the solid out of the domain.
TEST_F(SolidsOnRanks, ARunGoesOnWithoutParticles) {
  write_case(block_on_block("400 kPa"));
  expect_same_for({2});
  EXPECT_EQ(result_without_clock(folder("alone")).at("particles"), 0);
}
TEST_F(SolidsOnRanks, AnotherNumberGoesOnWithTheSameBits) {
  write_case(jet_on_block);
  expect_same_resumed({2, 3, 1}, SIGTERM, 0);
  expect_debris("resumed");
}

// ctest -C scheduled -R ranks
class SolidsOnManyRanks : public SolidsOnRanks {
 protected:
  void SetUp() override { skip_unless_scheduled(); }
};
TEST_F(SolidsOnManyRanks, CrushedRockHasTheSameBits) {
  expect_same_with_debris(ball_on_rock, {5, 8});
}
TEST_F(SolidsOnManyRanks, PiercedBlockInSpaceHasTheSameBits) {
  expect_same_with_debris(jet_on_block_in_space, {5, 8});
}

}  // namespace
}  // namespace kerf::test
