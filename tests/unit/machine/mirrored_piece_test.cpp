// SPDX-License-Identifier: Apache-2.0
// The part of a workpiece under a jet and that under its mirror image are mirror images.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geometry/graded_fill.hpp"
#include "input/read.hpp"
#include "model/case.hpp"

namespace kerf {
namespace {

Case piece_under(const std::string& machine) {
  return parse_case(
      "title = \"mirrored\"\ndimension = 2\nquality = \"draft\"\n[machine]\npressure = \"10 MPa\"\n"
      "orifice_diameter = \"0.4 mm\"\nstandoff = \"3 mm\"\n" +
          machine + "[workpiece]\nmaterial = \"gelatin-10\"\nsize = [\"100 mm\", \"2 mm\"]\n",
      "my.toml");
}

// Returns x, y and level of all particles, in order, with x times `sign`.
std::vector<std::array<double, 3>> sorted_particles(const Case& description, double sign) {
  const double cell = 0.1 * description.bodies.front().spacing;
  std::vector<std::array<double, 3>> particles;
  for (const GradedParticle& particle : fill_levels(description.bodies.front(), 2))
    particles.push_back({std::round(sign * particle.position[0] / cell),
                         std::round(particle.position[1] / cell), double(particle.level)});
  std::sort(particles.begin(), particles.end());
  return particles;
}

void expect_mirrored(const Case& one, const Case& other) {
  const Box &box = one.bodies.front().shape.box, &image = other.bodies.front().shape.box;
  EXPECT_EQ(box.minimum[0], -image.maximum[0]);
  EXPECT_EQ(box.maximum[0], -image.minimum[0]);
  EXPECT_EQ(one.domain.minimum[0], -other.domain.maximum[0]);
  EXPECT_EQ(one.domain.maximum[0], -other.domain.minimum[0]);
  EXPECT_EQ(one.domain.minimum[1], other.domain.minimum[1]);
  EXPECT_EQ(one.time.end, other.time.end);
  EXPECT_EQ(sorted_particles(one, 1.0), sorted_particles(other, -1.0));
}

TEST(MirroredPiece, UnderALeaningJet) {
  expect_mirrored(piece_under("lead_angle = \"30 deg\"\n"),
                  piece_under("lead_angle = \"-30 deg\"\n"));
}

TEST(MirroredPiece, AtAnEdge) {
  const auto at = [](const char* x) {
    return piece_under(fmt::format("position = [\"{} mm\", \"0 mm\"]\n", x));
  };
  expect_mirrored(at("50"), at("-50"));
  expect_mirrored(at("47.3"), at("-47.3"));
}

}  // namespace
}  // namespace kerf
