// SPDX-License-Identifier: Apache-2.0
// Particles without bonds from the start: which they are, and that no measurement counts them.
#include "analysis/loose_particles.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "analysis/broken_bonds.hpp"
#include "analysis/cut.hpp"
#include "analysis/workpiece.hpp"
#include "engine/device.hpp"
#include "input/read.hpp"
#include "layout.hpp"

namespace kerf::test::loose_particles_test {
namespace {

using namespace layout;

Case case_of(int dimension, const std::string& shape, const std::string& more = "") {
  return parse_case(fmt::format(R"(
title = "loose"
dimension = {}
[time]
end = "1 ms"
[domain]
minimum = ["-20 mm", "-20 mm", "-20 mm"]
maximum = ["20 mm", "20 mm", "20 mm"]
[[body]]
name = "body"
material = "tofu"
spacing = "1 mm"
shape = {}
{})",
                                dimension, shape, more),
                    "my.toml");
}

Case plane_case(const std::string& shape, const std::string& more = "") {
  std::string text = R"(
title = "loose"
dimension = 2
[time]
end = "1 ms"
[domain]
minimum = ["-20 mm", "-20 mm"]
maximum = ["20 mm", "20 mm"]
[[body]]
name = "body"
material = "tofu"
spacing = "1 mm"
shape = )" + shape + "\n" +
                     more;
  return parse_case(text, "my.toml");
}

std::string wedge(const char* base, double tip) {
  return fmt::format(
      R"({{ type = "polygon", vertices = [["-3 mm", "{0} mm"], ["3 mm", "{0} mm"], ["0 mm", "{1} mm"]] }})",
      base, tip);
}

std::vector<Case> cases() {
  const std::string lattice = "lattice = \"hexagonal\"\n";
  return {
      plane_case(wedge("0", 12.0)),
      plane_case(wedge("12", 0.0)),
      plane_case(wedge("0", 9.0), lattice),
      plane_case(
          R"({ type = "ring", centre = ["0 mm", "0 mm"], radius = "8 mm", inner_radius = "6.9 mm" })"),
      plane_case(R"({ type = "box", minimum = ["-8 mm", "0 mm"], maximum = ["8 mm", "1 mm"] })"),
      plane_case(R"({ type = "box", minimum = ["-8 mm", "0 mm"], maximum = ["8 mm", "2 mm"] })"),
      case_of(
          3,
          R"({ type = "box", minimum = ["-5 mm", "-5 mm", "0 mm"], maximum = ["5 mm", "5 mm", "1 mm"] })"),
      case_of(
          3,
          R"({ type = "box", minimum = ["-5 mm", "-5 mm", "0 mm"], maximum = ["5 mm", "5 mm", "2 mm"] })"),
      case_of(3, R"({ type = "sphere", centre = ["0 mm", "0 mm", "0 mm"], radius = "4 mm" })"),
  };
}

// The layout alone tells the particles that the solid detaches before its first step.
TEST(LooseParticles, AreThoseThatTheSolidDetaches) {
  for (const Case& description : cases()) {
    const auto expected = loose_particles(description, make_simulation(description)->frame());
    const auto found = loose_particles(description);
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t n = 0; n < found.size(); ++n) {
      EXPECT_EQ(found[n].loose, expected[n].loose);
      EXPECT_EQ(found[n].all, expected[n].all);
    }
  }
}

TEST(LooseParticles, AreAllOfOneLayerAndNoneOfTwo) {
  const auto layers = [](const char* top) {
    return loose_particles(plane_case(fmt::format(
        R"({{ type = "box", minimum = ["-8 mm", "0 mm"], maximum = ["8 mm", "{} mm"] }})", top)));
  };
  const auto one = layers("1");
  ASSERT_EQ(one.size(), 1u);
  EXPECT_EQ(one[0].loose, 16u);
  EXPECT_EQ(one[0].all, 16u);
  EXPECT_TRUE(layers("2").empty());
}

// A row of particles on a block, loose from the start: it is no part of the workpiece, and water
// that reaches the block finds nothing broken.
TEST(LooseParticles, AreNoPartOfTheWorkpiece) {
  for (const int dimension : {2, 3}) {
    const Case description = make_case(dimension);
    Frame frame = make_block(dimension);
    const std::size_t block = frame.id.size();
    add_box(frame, {Category::fractured, 0, solid_spacing, 940.0}, {-4.0 * mm, 0.0, -4.0 * mm},
            {4.0 * mm, solid_spacing, 4.0 * mm});
    const Workpiece workpiece = make_workpiece(description, frame);
    EXPECT_EQ(workpiece.position.size(), block);
    EXPECT_EQ(broken_bond_sum(workpiece, frame), 0.0);
    CutMonitor monitor(description, frame);
    const CutState state = monitor.observe(frame);
    EXPECT_EQ(state.fractured_mass, 0.0);
    EXPECT_EQ(state.cut_depth, 0.0);
    frame.category[block / 2] = Category::fractured;
    EXPECT_EQ(broken_bond_sum(workpiece, frame), 1.0);
    EXPECT_GT(monitor.observe(frame).fractured_mass, 0.0);
  }
}

}  // namespace
}  // namespace kerf::test::loose_particles_test
