// SPDX-License-Identifier: Apache-2.0
// Drawings of cases: the areas of sections, by Green's theorem and by counting, against the shapes.
#include "app/case_drawing.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>
#include <regex>

#include "app/shape_outline.hpp"
#include "input/read.hpp"
#include "model/case.hpp"
#include "support/fake_simulation.hpp"

namespace kerf {
namespace {

constexpr double pixels_per_metre = 100.0;

SectionPlane drawn_plane(int dimension, std::size_t across) {
  SectionPlane plane;
  plane.dimension = dimension;
  plane.across = across;
  plane.scale = pixels_per_metre;
  plane.corner = {-2.0, 2.0, -2.0};
  return plane;
}

// Returns the area of the rectangles that a sampled section consists of, m^2.
double sampled_area(const std::string& path) {
  static const std::regex strip(R"(M([-\d.]+) [-\d.]+H([-\d.]+)v([\d.]+)H[-\d.]+z)");
  double area = 0.0;
  for (std::sregex_iterator found(path.begin(), path.end(), strip), none; found != none; ++found)
    area += (std::stod((*found)[2]) - std::stod((*found)[1])) * std::stod((*found)[3]);
  return area / (pixels_per_metre * pixels_per_metre);
}

TEST(CaseDrawingSections, ABoxIsItsRectangle) {
  Shape box;
  box.box = {{-1.0, -0.5, -0.25}, {1.0, 0.5, 0.25}};
  EXPECT_EQ(section_of(box, drawn_plane(3, 0)).at(0).path, "M100.00 150.00H300.00V250.00H100.00z");
  EXPECT_EQ(section_of(box, drawn_plane(3, 2)).at(0).path, "M175.00 150.00H225.00V250.00H175.00z");
  box.box.minimum[2] = 0.1;
  EXPECT_TRUE(section_of(box, drawn_plane(3, 0)).empty());  // the plane z = 0 misses it
}

TEST(CaseDrawingSections, ASphereIsCutAtItsDistance) {
  Shape sphere;
  sphere.kind = Shape::Kind::sphere;
  sphere.radius = 1.0;
  sphere.centre = {0.0, 0.0, 0.6};  // the circle has a radius of 0.8
  EXPECT_THAT(section_of(sphere, drawn_plane(3, 0)).at(0).path, testing::HasSubstr("a80.00 80.00"));
}

TEST(CaseDrawingSections, ADifferenceIsSampled) {
  Shape whole, hole, difference;
  whole.box = {{-1.0, -1.0, 0.0}, {1.0, 1.0, 0.0}};
  hole.kind = Shape::Kind::disc;
  hole.radius = 0.5;
  difference.kind = Shape::Kind::difference;
  difference.parts = {whole, hole};
  const double area = 4.0 - std::numbers::pi * 0.25;
  // The boundaries are 11 m long, the sampling is at every 2 cm.
  EXPECT_NEAR(sampled_area(section_of(difference, drawn_plane(2, 0)).at(0).path), area,
              0.02 * area);
}

TEST(CaseDrawingSections, ACylinderFromTheSideIsARectangle) {
  Shape cylinder;
  cylinder.kind = Shape::Kind::disc;
  cylinder.radius = 0.5;
  cylinder.axis = {0.0, 0.0, 1.0};
  cylinder.length = 1.0;
  EXPECT_NEAR(sampled_area(section_of(cylinder, drawn_plane(3, 2)).at(0).path), 1.0, 0.04);
}

TEST(CaseDrawings, ShowBodiesJetAndProbes) {
  const Case description = test::fake_case();
  const auto drawings = draw_case(description);
  ASSERT_EQ(drawings.size(), 1u);
  // The domain is drawn to scale, with a margin of 4% of the width on all sides.
  static const std::regex size(R"x(viewBox="0 0 ([\d.]+) ([\d.]+)")x");
  std::smatch found;
  ASSERT_TRUE(std::regex_search(drawings[0].svg, found, size));
  const Box& domain = description.domain;
  const double wide = 1.08 * (domain.maximum[0] - domain.minimum[0]),
               high = domain.maximum[1] - domain.minimum[1] + 0.08 * wide;
  constexpr double line_of_scale = 30.0;
  EXPECT_NEAR((std::stod(found[2]) - line_of_scale) / std::stod(found[1]), high / wide, 0.003);
  for (const char* words : {"<title>block (tofu)</title>", "<title>plate</title>",
                            "<title>jet</title>", "jet: nozzle", "<title>wall</title>"})
    EXPECT_THAT(drawings[0].svg, testing::HasSubstr(words));
}

TEST(CaseDrawings, HaveTwoSectionsInSpaceAndSymmetryPlanes) {
  const auto drawings = draw_case(read_case(KERF_SOURCE_DIR "/cases/tofu-5ms-3d.toml", quick_look));
  ASSERT_EQ(drawings.size(), 2u);
  EXPECT_THAT(drawings[0].title, testing::StartsWith("Section at z"));
  EXPECT_THAT(drawings[1].title, testing::StartsWith("Section at x"));
}

}  // namespace
}  // namespace kerf
