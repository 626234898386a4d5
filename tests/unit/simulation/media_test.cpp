// SPDX-License-Identifier: Apache-2.0
// Media, levels and settings of a case against the closed forms of elasticity and of Tait's
// equation of state, and against counts by hand.
#include "simulation/media.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "simulation/run_settings.hpp"
#include "support/small_cases.hpp"

namespace kerf::test {
namespace {

Body block(const char* name, double spacing) {
  return body(name, Role::elastic, box({0.0, 0.0, 0.0}, {0.02, 0.01, 0.0}), spacing);
}

std::vector<Medium<double>> media_of(const Case& c) {
  return run_settings(c).media;
}

TEST(Media, SolidHasTheModuliAndWavesOfItsYoungsModulus) {
  Case c = empty_case(2, PrecisionKind::double_precision);
  c.bodies = {block("block", 2e-3)};
  const Medium<double> solid = media_of(c).at(0);
  const double e = 1e5, nu = 0.3, density = 940.0;
  const double lame = e * nu / ((1.0 + nu) * (1.0 - 2.0 * nu)), shear = e / (2.0 * (1.0 + nu));
  EXPECT_EQ(solid.phase, Phase::solid);
  EXPECT_NEAR(solid.shear_modulus, shear, 1e-12 * shear);
  EXPECT_NEAR(solid.bulk_modulus, lame + 2.0 / 3.0 * shear, 1e-12 * e);
  EXPECT_NEAR(solid.longitudinal_speed, std::sqrt((lame + 2.0 * shear) / density), 1e-11);
  EXPECT_NEAR(solid.sound_speed, std::sqrt((lame + 2.0 / 3.0 * shear) / density), 1e-11);
  EXPECT_NEAR(solid.mass, density * 4e-6, 1e-15);
  EXPECT_DOUBLE_EQ(solid.smoothing_length, 1.5 * 2e-3);
  EXPECT_FALSE(solid.constrained);
}

TEST(Media, WaterUnderPressureHasTheDensityOfTait) {
  Case c = empty_case(3, PrecisionKind::double_precision);
  c.bodies = {body("water", Role::water, box({0.0, 0.0, 0.0}, {0.01, 0.01, 0.01}), 1e-3)};
  c.bodies[0].pressure = 2e5;
  const Medium<double> water = media_of(c).at(0);
  // p = B ((rho/rho_0)^7 - 1), B = c^2 rho_0 / 7.
  const double ratio = std::pow(1.0 + 2e5 / (50.0 * 50.0 * 1000.0 / 7.0), 1.0 / 7.0);
  EXPECT_EQ(water.phase, Phase::water);
  EXPECT_NEAR(water.initial_compression, ratio - 1.0, 1e-14);
  EXPECT_NEAR(water.mass, 1000.0 * ratio * 1e-9, 1e-20);
}

TEST(Media, OnlyNearlyIncompressibleSolidsOfTheStandardFormulationHaveABulkModulusByDensity) {
  Case c = empty_case(2, PrecisionKind::double_precision);
  c.bodies = {block("block", 2e-3)};
  c.materials[0].poisson_ratio = 0.45;  // K = 29/3 G
  EXPECT_EQ(media_of(c)[0].excess_bulk_modulus, 0.0);
  EXPECT_FALSE(media_of(c)[0].cavitates);
  c.formulation = Formulation::standard;
  const Medium<double> solid = media_of(c)[0];
  const double shear = 1e5 / 2.9;
  EXPECT_NEAR(solid.excess_bulk_modulus, (29.0 / 3.0 - 5.0) * shear, 1e-9 * shear);
  EXPECT_NEAR(solid.bulk_modulus, 5.0 * shear, 1e-9 * shear);
  EXPECT_NEAR(solid.total_bulk_modulus, 29.0 / 3.0 * shear, 1e-9 * shear);
  EXPECT_TRUE(solid.cavitates);
}

// A lattice has more or fewer nodes in a round shape than cells: 177 for 167 in a disc of 7.3 d.
TEST(Media, FittedBodiesHaveTheMassOfTheirShape) {
  constexpr double pi = std::numbers::pi, d = 1e-3;
  const auto round = [](Shape::Kind kind, double radius, double inner) {
    Shape shape;
    shape.kind = kind;
    shape.centre = {0.0013, 0.0007, 0.0};
    shape.radius = radius;
    shape.inner_radius = inner;
    shape.axis = {0.0, 0.6, 0.8};
    shape.length = 8.3e-3;
    return shape;
  };
  Shape wedge;
  wedge.kind = Shape::Kind::polygon;
  wedge.vertices = {{0.0, 0.0}, {0.02, 0.0}, {0.0, 0.01}};
  wedge.depth_maximum = 5e-3;
  Shape drilled;
  drilled.kind = Shape::Kind::difference;
  drilled.parts = {box({-0.01, -0.01, 0.0}, {0.01, 0.01, 0.0}),
                   round(Shape::Kind::disc, 5.3e-3, 0.0)};
  const auto check = [&](const Shape& shape, int dimension, double volume, double tolerance) {
    for (const Role role : {Role::elastic, Role::water}) {
      Case c = empty_case(dimension, PrecisionKind::double_precision);
      c.formulation = Formulation::standard;
      c.bodies = {body("part", role, shape, d)};
      c.bodies[0].body_fitted = true;
      const RunSettings settings = run_settings(c);
      const double density = c.materials[static_cast<std::size_t>(c.bodies[0].material)].density;
      const double mass = settings.media[0].mass * static_cast<double>(settings.particles.size());
      EXPECT_NEAR(mass, density * volume, tolerance * density * volume);
      const double cell = dimension == 2 ? d * d : d * d * d;
      EXPECT_NEAR(settings.media[0].volume, cell, 0.1 * cell);
    }
  };
  for (const double radius : {7e-3, 7.3e-3, 11.8e-3})
    check(round(Shape::Kind::disc, radius, 0.0), 2, pi * radius * radius, 1e-9);
  check(round(Shape::Kind::ring, 9e-3, 4e-3), 2, pi * 65e-6, 1e-9);
  check(wedge, 2, 1e-4, 1e-9);
  check(drilled, 2, 4e-4 - pi * 5.3e-3 * 5.3e-3, 2e-3);
  check(round(Shape::Kind::sphere, 6e-3, 0.0), 3, 4.0 / 3.0 * pi * 216e-9, 1e-9);
  check(round(Shape::Kind::disc, 5e-3, 0.0), 3, pi * 25e-6 * 8.3e-3, 1e-9);
  check(wedge, 3, 5e-7, 1e-9);
}

TEST(Media, JoinedBodiesAreOnePiece) {
  Case c = empty_case(2, PrecisionKind::mixed);
  c.bodies = {block("a", 2e-3), block("b", 2e-3), block("alone", 2e-3), block("c", 2e-3)};
  c.bodies[1].joined_to = "a";
  c.bodies[3].joined_to = "b";
  const auto media = media_of(c);
  EXPECT_EQ(media[1].piece, media[0].piece);
  EXPECT_EQ(media[3].piece, media[0].piece);
  EXPECT_NE(media[2].piece, media[0].piece);
}

TEST(Media, RigidFixedAndMovedBodiesAreConstrained) {
  Case c = empty_case(2, PrecisionKind::mixed);
  c.bodies = {body("wall", Role::rigid, box({0.0, 0.0, 0.0}, {0.02, 0.01, 0.0}), 2e-3),
              block("fixed", 2e-3), block("moved", 2e-3), block("free", 2e-3)};
  c.bodies[1].fixed = true;
  c.bodies[2].displacement = {"t", "0", "0"};
  const auto media = media_of(c);
  EXPECT_TRUE(media[0].constrained);
  EXPECT_EQ(media[0].repulsion, 25.0);
  EXPECT_TRUE(media[1].constrained);
  EXPECT_TRUE(media[2].constrained);
  EXPECT_FALSE(media[3].constrained);
}

TEST(Levels, BodiesComeFirstThenJetsThenCoarserLevels) {
  Case c = empty_case(2, PrecisionKind::mixed);
  c.bodies = {block("graded", 1e-3), block("uniform", 1e-3)};
  c.bodies[0].grading.levels = 2;
  c.bodies[0].grading.width = 2e-3;
  c.bodies[0].grading.around = box({0.0, 0.0, 0.0}, {0.002, 0.002, 0.0});
  c.jets = {jet(5e-3, 5e-4, {0.0, 0.02, 0.0}, 2e-3)};
  std::vector<std::pair<int, int>> origins;
  for (const MediumOrigin& origin : medium_origins(c))
    origins.emplace_back(origin.source, origin.level);
  EXPECT_EQ(origins, (std::vector<std::pair<int, int>>{{0, 0}, {1, 0}, {2, 0}, {0, 1}, {0, 2}}));
  EXPECT_EQ(media_of_levels(c), (std::vector<std::vector<std::uint16_t>>{{0, 3, 4}, {1}}));
  const auto media = media_of(c);
  ASSERT_EQ(media.size(), 5u);
  EXPECT_DOUBLE_EQ(media[4].spacing, 4e-3);
  EXPECT_NEAR(media[4].mass, 16.0 * media[0].mass, 1e-15);
  EXPECT_EQ(media[4].level, 2);
  EXPECT_EQ(media[2].phase, Phase::water);
}

TEST(Settings, NameTheSourcesOfParticles) {
  Case c = empty_case(2, PrecisionKind::mixed);
  c.bodies = {block("plate", 2e-3)};
  c.jets = {jet(5e-3, 5e-4, {0.0, 0.02, 0.0}, 2e-3)};
  EXPECT_EQ(run_settings(c).source_names, (std::vector<std::string>{"body 'plate'", "jet 'jet'"}));
}

}  // namespace
}  // namespace kerf::test
