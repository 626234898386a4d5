// SPDX-License-Identifier: Apache-2.0
// The meaning of a case file, and the defaults.
#include "input/read.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <numbers>
#include <string>

#include "input/schema.hpp"
#include "input/write_used.hpp"
#include "model/case.hpp"

namespace kerf {
namespace {

const std::string minimal = R"(title = "minimal"
dimension = 2
formulation = "shinohara2004"
[time]
end = "10 ms"
[[body]]
name = "block"
material = "tofu"
shape = { type = "box", minimum = ["-20 mm", "0 mm"], maximum = ["20 mm", "20 mm"] }
spacing = "2 mm"
[[body]]
name = "plate"
role = "rigid"
shape = { type = "box", minimum = ["-40 mm", "-4 mm"], maximum = ["40 mm", "0 mm"] }
spacing = "2 mm"
[[jet]]
name = "jet"
speed = "5 m/s"
width = "10 mm"
position = ["0 mm", "20 mm"]
standoff = "20 mm"
spacing = "1 mm"
)";

TEST(Read, DefaultsOfAMinimalCase) {
  const Case read = parse_case(minimal, "minimal.toml");
  EXPECT_EQ(read.precision, PrecisionKind::mixed);
  EXPECT_EQ(read.smoothing_ratio, 1.5);
  EXPECT_EQ(read.time.courant, 0.25);
  EXPECT_EQ(read.time.maximum_step, std::numeric_limits<double>::infinity());
  ASSERT_EQ(read.materials.size(), 2u);
  EXPECT_EQ(read.materials[0].name, "tofu");
  EXPECT_EQ(read.materials[1].name, "water");
  EXPECT_EQ(read.materials[1].sound_speed, 50.0);  // c = 10 V, eq. (18)
  EXPECT_EQ(read.bodies[0].role, Role::elastic);
  EXPECT_EQ(read.bodies[0].material, 0);
  EXPECT_EQ(read.bodies[1].role, Role::rigid);
  EXPECT_EQ(read.bodies[1].material, -1);
  EXPECT_EQ(read.bodies[1].repulsion, 25.0);  // V^2
  EXPECT_EQ(read.jets[0].material, 1);
  EXPECT_EQ(read.jets[0].profile, "1");
  EXPECT_FALSE(read.back_flow_removal.has_value());
  EXPECT_EQ(read.artificial_stress.epsilon, 0.0);
  EXPECT_EQ(read.output.frame_times.size(), 21u);
  EXPECT_EQ(read.output.frame_times.back(), 0.01);
  // All bodies and jets are within -40 .. 40 by -10 .. 50 mm; half of 80 mm is added.
  EXPECT_DOUBLE_EQ(read.domain.minimum[0], -0.08);
  EXPECT_DOUBLE_EQ(read.domain.maximum[1], 0.09);
  EXPECT_EQ(read.domain.maximum[2], 0.0);
}

TEST(Read, StandardIsTheDefaultFormulation) {
  std::string text = minimal;
  const std::string line = "formulation = \"shinohara2004\"\n";
  text.erase(text.find(line), line.size());
  const Case read = parse_case(text, "minimal.toml");
  EXPECT_EQ(read.formulation, Formulation::standard);
  EXPECT_EQ(read.time.courant, 0.45);
  EXPECT_EQ(read.smoothing_ratio, 1.3);
  EXPECT_EQ(read.bodies[1].repulsion, 0.0);  // a key of the other formulation
}

// It needs no repulsion of rigid bodies where nothing tells a speed.
TEST(Read, RepulsionIsOfThePapersFormulationAlone) {
  const std::string resting = R"(title = "rest"
dimension = 2
[time]
end = "1 ms"
[[body]]
name = "block"
material = "tofu"
shape = { type = "box", minimum = ["-8 mm", "0 mm"], maximum = ["8 mm", "8 mm"] }
spacing = "2 mm"
[[body]]
name = "floor"
role = "rigid"
shape = { type = "box", minimum = ["-8 mm", "-6 mm"], maximum = ["8 mm", "0 mm"] }
spacing = "2 mm"
)";
  EXPECT_EQ(parse_case(resting, "resting.toml").bodies[1].repulsion, 0.0);
  EXPECT_THROW(parse_case("formulation = \"shinohara2004\"\n" + resting, "resting.toml"),
               UserError);
}

std::string with(const std::string& from, const std::string& to) {
  std::string text = minimal;
  text.replace(text.find(from), from.size(), to);
  return text;
}

TEST(Read, MaterialsOverTheLibrary) {
  const std::string table =
      "[materials.soft]\nbase = \"tofu\"\nyoungs_modulus = \"50 kPa\"\n[[body]]\nname = \"block\"";
  std::string text = with("[[body]]\nname = \"block\"", table);
  text.replace(text.find("\"tofu\"\nshape"), 6, "\"soft\"");
  const Case read = parse_case(text, "soft.toml");
  ASSERT_EQ(read.materials[0].name, "soft");
  EXPECT_EQ(read.materials[0].youngs_modulus, 5e4);
  EXPECT_EQ(read.materials[0].density, 940.0);
  EXPECT_EQ(read.materials[0].failure_strain, 0.1);
}

TEST(Read, SoundSpeedOfFallingWater) {
  const Case read = parse_case(R"(title = "dam"
dimension = 2
formulation = "shinohara2004"
gravity = ["0 m/s2", "-9.81 m/s2"]
[time]
end = "1 s"
[[body]]
name = "column"
material = "water"
shape = { type = "box", minimum = ["0 m", "0 m"], maximum = ["1 m", "2 m"] }
spacing = "10 mm"
)",
                               "dam.toml");
  EXPECT_NEAR(read.materials[0].sound_speed, 10.0 * std::sqrt(2.0 * 9.81 * 2.0), 1e-12 * 62.6);
}

TEST(Read, VelocitiesAndAngles) {
  const Case numbers = parse_case(
      with("material = \"tofu\"", "material = \"tofu\"\nvelocity = [\"36 km/h\", \"-1 m/s\"]"),
      "a");
  EXPECT_EQ(numbers.bodies[0].velocity[0], "10");
  EXPECT_EQ(numbers.bodies[0].velocity[1], "-1");
  EXPECT_NEAR(numbers.materials[1].sound_speed, 10.0 * std::hypot(10.0, 1.0), 1e-12 * 100.0);
  const Case tilted =
      parse_case(with("standoff = \"20 mm\"", "standoff = \"20 mm\"\nangle = \"30 deg\""), "a");
  EXPECT_NEAR(tilted.jets[0].angle, std::numbers::pi / 6.0, 1e-15);
}

// A case with every section is read back bit for bit.
// budget: function: a table of cases reads best in one place
TEST(Read, EverySectionIsReadBack) {
  const std::string text = R"toml(title = "all \"things\" \u00e9"
dimension = 3
formulation = "shinohara2004"
precision = "double"
smoothing_ratio = 1.3
[time]
end = "10 ms"
courant = 0.1
maximum_step = "3 us"
[materials.juice]
base = "water"
sound_speed_factor = 13
[[body]]
name = "tube"
material = "rubber"
lattice = "hexagonal"
offset = ["0.3 mm", "0 mm", "-1 mm"]
spacing = "3 mm"
velocity_expression = ["0.1*sin(pi*x/0.2)", "z", "0"]
[body.shape]
type = "difference"
parts = [
  { type = "union", parts = [
    { type = "ring", centre = ["0 m", "0 m", "0 m"], radius = "40 mm", inner_radius = "11 mm", axis = [1, 2, 3], length = "50 mm" },
    { type = "sphere", centre = ["0 m", "0 m", "0 m"], radius = "33 mm" } ] },
  { type = "polygon", vertices = [["0 m", "0 m"], ["9 mm", "0 m"], ["0 m", "7 mm"]], depth_minimum = "-9 mm", depth_maximum = "9 mm" },
]
[[body]]
name = "holder"
material = "rubber"
joined_to = "tube"
fixed = true
spacing = "3 mm"
shape = { type = "box", minimum = ["-63 mm", "-30 mm", "-30 mm"], maximum = ["-33 mm", "0 m", "0 m"] }
[[body]]
name = "piston"
role = "rigid"
repelling_layer = "front"
displacement_expression = ["0", "0.1*t", "1e-3*sin(20*t)"]
spacing = "3 mm"
shape = { type = "disc", centre = ["0 m", "-200 mm", "0 m"], radius = "40 mm", length = "10 mm", axis = [0.1, 0.2, 0.3] }
[[jet]]
name = "jet"
material = "juice"
speed = "7 m/s"
diameter = "9 mm"
position = ["0 m", "50 mm", "0 m"]
standoff = "37 mm"
angle = "17 deg"
azimuth = "-33 deg"
spacing = "1 mm"
start = "1 ms"
stop = "7 ms"
profile = "power"
[back_flow_removal]
speed_fraction = 0.1
[[probe]]
name = "p"
position = ["1 mm", "2 mm", "3 mm"]
[[probe]]
name = "q"
kind = "plane"
position = ["1 mm", "2 mm", "3 mm"]
normal = [1, 1, 1]
[artificial_stress]
[output]
frame_times = ["0 s", "1.1 ms", "7 ms"]
picture_times = []
checkpoint_interval = "1 h"
)toml";
  const Case read = parse_case(text, "all.toml");
  const std::string used = write_used(read);
  EXPECT_EQ(parse_case(used, "case.used.toml"), read) << used;
  EXPECT_EQ(read.artificial_stress.epsilon, 0.3);
  EXPECT_EQ(read.output.checkpoint_interval, 3600.0);
  EXPECT_EQ(read.jets[0].profile, "(1 - r)^(1/7)");
  EXPECT_EQ(read.bodies[2].repelling_layer, RepellingLayer::front);
  // The mean of (1 - r)^(1/7) over a disc is 98/120 of its speed on the axis, which nine particles
  // across give within a layer at the edge, 1%.
  const double on_the_axis = 7.0 * 120.0 / 98.0;
  EXPECT_NEAR(read.materials[0].sound_speed, 13.0 * on_the_axis, 0.01 * 13.0 * on_the_axis);
}

TEST(Read, JitterIsReadBack) {
  std::string text = with("material = \"tofu\"", "material = \"tofu\"\njitter = 0.2\nseed = 77");
  text.replace(text.find("shinohara2004"), 13, "standard");
  const Case read = parse_case(text, "jittered.toml");
  EXPECT_EQ(read.bodies[0].jitter, 0.2);
  EXPECT_EQ(read.bodies[0].seed, 77u);
  EXPECT_EQ(parse_case(write_used(read), "case.used.toml"), read);
}

TEST(Read, BoundariesOfTheStandardFormulationAreReadBack) {
  const std::string text = R"toml(title = "quarter"
dimension = 3
formulation = "standard"
[time]
end = "10 ms"
[domain]
minimum = ["0 mm", "-10 mm", "-50 mm"]
maximum = ["50 mm", "50 mm", "0 mm"]
symmetry = ["z+", "x-"]
[[body]]
name = "pool"
material = "water"
spacing = "2 mm"
pressure = "3 bar"
velocity = ["1 m/s", "0 m/s", "0 m/s"]
shape = { type = "box", minimum = ["-20 mm", "20 mm", "-20 mm"], maximum = ["20 mm", "40 mm", "20 mm"] }
[[body]]
name = "block"
material = "rubber"
spacing = "2 mm"
absorbing = ["y-", "x+"]
shape = { type = "box", minimum = ["-20 mm", "0 mm", "-20 mm"], maximum = ["20 mm", "20 mm", "20 mm"] }
)toml";
  const Case read = parse_case(text, "quarter.toml");
  EXPECT_EQ(parse_case(write_used(read), "case.used.toml"), read) << write_used(read);
  EXPECT_EQ(read.symmetry, (Faces{{true, false, false}, {false, false, true}}));
  EXPECT_EQ(read.bodies[1].absorbing, (Faces{{false, true, false}, {true, false, false}}));
  EXPECT_EQ(read.bodies[0].absorbing, Faces{});
  EXPECT_EQ(read.bodies[0].pressure, 3e5);
}

}  // namespace
}  // namespace kerf
