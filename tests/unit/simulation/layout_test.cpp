// SPDX-License-Identifier: Apache-2.0
// The initial particles of a run, their prescribed motion, the symmetry planes and the absorbing
// faces, against counts and positions computed by hand.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "simulation/absorbing_sites.hpp"
#include "simulation/inflow.hpp"
#include "simulation/populate.hpp"
#include "simulation/symmetry.hpp"
#include "support/small_cases.hpp"

namespace kerf::test {
namespace {

constexpr double block_spacing = 1e-3;  // m

// 10 x 5 particles.
Case one_block() {
  Case c = empty_case(2, PrecisionKind::double_precision);
  c.bodies = {
      body("block", Role::elastic, box({0.0, 0.0, 0.0}, {0.01, 0.005, 0.0}), block_spacing)};
  return c;
}

TEST(Populate, ParticlesHaveTheVelocityOfTheExpressions) {
  Case c = one_block();
  c.bodies[0].velocity = {"2*x + y", "-3*y", "0"};
  const auto particles = run_settings(c).particles;
  ASSERT_EQ(particles.size(), 50u);
  for (const NewParticle& particle : particles) {
    const auto [x, y, z] = particle.position;
    EXPECT_NEAR(particle.velocity[0], 2.0 * x + y, 1e-15);
    EXPECT_NEAR(particle.velocity[1], -3.0 * y, 1e-15);
    EXPECT_EQ(particle.flags, 0);
  }
  c.bodies[0].fixed = true;
  for (const NewParticle& particle : run_settings(c).particles)
    EXPECT_EQ(particle.velocity, Point{});
}

TEST(Populate, RepellingLayerOfAWallIsItsTopRow) {
  Case c = one_block();
  c.bodies[0] = body("wall", Role::rigid, c.bodies[0].shape, block_spacing);
  std::size_t repelling = 0;
  for (const NewParticle& particle : run_settings(c).particles) {
    const bool top = particle.position[1] > 0.004;
    EXPECT_EQ(particle.flags, top ? flag::repelling : 0);
    repelling += top;
  }
  EXPECT_EQ(repelling, 10u);
}

TEST(Populate, NoParticlesBeyondASymmetryPlane) {
  Case c = one_block();
  c.domain.minimum = {0.004, -0.15, 0.0};
  c.symmetry.minimum = {true, false, false};
  const auto particles = run_settings(c).particles;
  EXPECT_EQ(particles.size(), 30u);
  for (const NewParticle& particle : particles) EXPECT_GT(particle.position[0], 0.004);
}

TEST(Populate, WaterIsAtRestInAClosedNozzleAndMovesInAnOpenOne) {
  Case c = empty_case(2, PrecisionKind::double_precision);
  c.jets = {jet(5e-3, 5e-4, {0.0, 0.02, 0.0}, 2e-3)};
  c.jets[0].start = 1e-3;
  c.jets[0].traverse = {0.3, 0.0, 0.0};
  const Nozzle nozzle = run_settings(c).nozzles.at(0);
  const std::vector<InletParticle> water{{{0.001, 0.022, 0.0}, 5.0, 3}};
  const NewParticle before = inlet_particles(water, nozzle, 7, 0.0).at(0);
  const NewParticle after = inlet_particles(water, nozzle, 7, 2e-3).at(0);
  EXPECT_EQ(before.velocity, Point{});
  EXPECT_NEAR(after.velocity[0], 0.3, 1e-15);
  EXPECT_NEAR(after.velocity[1], -5.0, 1e-14);
  EXPECT_EQ(after.inlet_column, 3u);
  EXPECT_EQ(after.source, 7);
  EXPECT_EQ(after.flags, flag::upstream);
  EXPECT_EQ(after.position, water[0].position);
}

TEST(Motion, BodiesFollowTheirExpressions) {
  Case c = one_block();
  c.bodies.push_back(c.bodies[0]);
  c.bodies[1].name = "moved";
  c.bodies[1].displacement = {"0.5*t^2", "1 + 0.1*t", "0"};
  const auto motion = Motion(c).between<2>(0.2, 0.6, 0.6, {});
  ASSERT_EQ(motion.size(), 2u);
  EXPECT_EQ(norm(motion[0].displacement), 0.0);
  EXPECT_NEAR(motion[1].displacement[0], 0.5 * (0.36 - 0.04), 1e-15);
  EXPECT_NEAR(motion[1].displacement[1], 0.04, 1e-15);
  EXPECT_NEAR(motion[1].velocity[0], 0.4, 1e-14);
  EXPECT_NEAR(motion[1].velocity[1], 0.1, 1e-14);
}

TEST(Motion, NozzlesTraverseAndAreOpenForPartOfAStep) {
  Case c = empty_case(2, PrecisionKind::double_precision);
  c.jets = {jet(5e-3, 5e-4, {0.0, 0.02, 0.0}, 2e-3)};
  c.jets[0].start = 1e-3;
  c.jets[0].traverse = {0.3, 0.0, 0.0};
  c.back_flow_removal = BackFlowRemoval{-0.1};
  const RunSettings settings = run_settings(c);
  const auto motion = settings.motion.between<2>(0.5e-3, 2.5e-3, 2.5e-3, settings.nozzles).at(0);
  const auto flows = column_flows(settings.nozzles.at(0), settings.media.at(0), 0.5e-3, 2.5e-3);
  ASSERT_EQ(flows.size(), 10u);
  for (const ColumnFlow& flow : flows) {
    EXPECT_NEAR(flow.distance, 1.5e-3 * 5.0, 1e-16);
    EXPECT_NEAR(flow.speed, 0.75 * 5.0, 1e-12);
    EXPECT_EQ(flow.compression, 0.0);
  }
  EXPECT_NEAR(motion.displacement[0], 0.3 * 1.5e-3, 1e-16);
  EXPECT_NEAR(motion.exit[0], 0.3 * 1.5e-3, 1e-16);
  EXPECT_NEAR(motion.exit[1], 0.022, 1e-15);
  EXPECT_NEAR(motion.direction[1], -1.0, 1e-15);
  EXPECT_TRUE(motion.removes_back_flow);
  EXPECT_NEAR(motion.back_flow_removal_speed, -0.5, 1e-15);
}

TEST(Symmetry, PlanesAreTheFacesThatTheCaseNames) {
  Case c = empty_case(3, PrecisionKind::double_precision);
  c.symmetry.minimum = {true, false, false};
  c.symmetry.maximum = {false, false, true};
  const auto mirrors = mirror_planes<3>(run_settings(c));
  EXPECT_EQ(mirrors.faces, mirrors.low_face(0) | mirrors.high_face(2));
  EXPECT_EQ(mirrors.low[0], -0.15);
  EXPECT_EQ(mirrors.high[2], 0.15);
  EXPECT_EQ(single_planes(mirrors).size(), 2u);
}

TEST(Symmetry, APieceIsJoinedToItsImageAtThePlane) {
  Case c = one_block();
  c.bodies.push_back(body("apart", Role::elastic,
                          box({block_spacing, 0.01, 0.0}, {0.006, 0.015, 0.0}), block_spacing));
  c.domain.minimum = {0.0, -0.15, 0.0};
  c.symmetry.minimum = {true, false, false};
  const RunSettings settings = run_settings(c);
  EXPECT_EQ(settings.media[0].joined_mirrors, mirror_planes<2>(settings).low_face(0));
  EXPECT_EQ(settings.media[1].joined_mirrors, 0u);
}

template <int D>
std::vector<AbsorbingSite<D>> sites_among(const RunSettings& settings,
                                          const std::vector<NewParticle>& particles) {
  std::vector<Vector<D, double>> position;
  std::vector<std::uint16_t> source;
  std::vector<std::uint32_t> number;
  for (const NewParticle& particle : particles) {
    number.push_back(static_cast<std::uint32_t>(position.size()));
    position.push_back(Vector<D, double>::from(particle.position));
    source.push_back(particle.source);
  }
  return absorbing_sites<D>({settings, settings.media, position, source, number, {}});
}

std::vector<AbsorbingSite<2>> sites_of(const Case& c) {
  const RunSettings settings = run_settings(c);
  return sites_among<2>(settings, settings.particles);
}

// The force per velocity along an axis over rho c_p, m^2 (2D: m): the area of the face if it lies
// across that axis and is the only one that absorbs.
template <int D>
double absorbing_area(const RunSettings& settings, const std::vector<NewParticle>& particles,
                      int axis) {
  double sum = 0.0;
  for (const auto& site : sites_among<D>(settings, particles)) sum += site.mass * site.rate[axis];
  return sum / (settings.media[0].density * settings.media[0].longitudinal_speed);
}

TEST(AbsorbingSites, RowsAtTheFacesAreDampedByTheImpedanceOfTheirWaves) {
  Case c = one_block();
  EXPECT_TRUE(sites_of(c).empty());
  c.bodies[0].absorbing.minimum = {true, true, false};
  const auto sites = sites_of(c);
  EXPECT_EQ(sites.size(), 10u + 5u - 1u);
  // The rate is rho c v on the face of a particle over its mass: c / spacing.
  const double shear = std::sqrt(1e5 / 2.6 / 940.0) / block_spacing;
  const double pressure = std::sqrt((1e5 / 1.2 + 4.0 / 3.0 * 1e5 / 2.6) / 940.0) / block_spacing;
  int corners = 0;
  for (const auto& site : sites) {
    const bool left = site.particle % 10 == 0, low = site.particle < 10;
    ASSERT_TRUE(left || low);
    EXPECT_NEAR(site.rate[0], (left ? pressure : 0.0) + (low ? shear : 0.0), 1e-6);
    EXPECT_NEAR(site.rate[1], (left ? shear : 0.0) + (low ? pressure : 0.0), 1e-6);
    EXPECT_NEAR(site.mass, 940.0 * block_spacing * block_spacing, 1e-15);
    corners += left && low;
  }
  EXPECT_EQ(corners, 1);
}

// The areas of the sites add up to the area of the face, whatever lattice lies behind it.
TEST(AbsorbingSites, ShareTheAreaOfTheFaceHoweverTheLatticeLies) {
  struct Choice {
    int dimension;
    Lattice lattice;
    double angle, jitter;
  };
  for (const Choice& choice :
       {Choice{2, Lattice::square, 0.2, 0.0}, Choice{2, Lattice::square, 0.5, 0.0},
        Choice{2, Lattice::square, 0.8, 0.0}, Choice{2, Lattice::square, 0.0, 0.3},
        Choice{2, Lattice::hexagonal, 0.0, 0.0}, Choice{2, Lattice::hexagonal, 0.3, 0.1},
        Choice{3, Lattice::square, 0.5, 0.0}, Choice{3, Lattice::square, 0.0, 0.3},
        Choice{3, Lattice::hexagonal, 0.0, 0.0}}) {
    Case c = empty_case(choice.dimension, PrecisionKind::double_precision);
    const bool solid = choice.dimension == 3;
    c.bodies = {body("block", Role::elastic,
                     box({0.0, 0.0, 0.0}, {0.0103, 0.0051, solid ? 0.007 : 0.0}), block_spacing)};
    c.bodies[0].lattice = choice.lattice;
    c.bodies[0].lattice_angle = choice.angle;
    c.bodies[0].jitter = choice.jitter;
    for (const std::size_t axis : {0, 1}) {
      c.bodies[0].absorbing = {};
      c.bodies[0].absorbing.maximum[axis] = true;
      const RunSettings settings = run_settings(c);
      const double area = (axis == 0 ? 0.0051 : 0.0103) * (solid ? 0.007 : 1.0);
      const int a = static_cast<int>(axis);
      EXPECT_NEAR(solid ? absorbing_area<3>(settings, settings.particles, a)
                        : absorbing_area<2>(settings, settings.particles, a),
                  area, 1e-9 * area)
          << choice.dimension << "D, angle " << choice.angle << ", axis " << axis;
    }
  }
}

// Of a face only the part that the shape leaves absorbs, and in front of a symmetry plane.
TEST(AbsorbingSites, HaveTheAreaThatCutsAndPlanesLeaveOfAFace) {
  Case c = one_block();
  Shape cut;
  cut.kind = Shape::Kind::difference;
  cut.parts = {c.bodies[0].shape, box({-1.0, 0.002, 0.0}, {0.004, 0.003, 0.0})};
  c.bodies[0].shape = cut;
  c.bodies[0].absorbing.minimum[0] = true;
  const RunSettings settings = run_settings(c);
  EXPECT_NEAR(absorbing_area<2>(settings, settings.particles, 0), 0.004, 1e-9);
  Case half = one_block();
  half.domain = {{-0.1, 0.002, 0.0}, {0.1, 0.1, 0.0}};
  half.symmetry.minimum[1] = true;
  half.bodies[0].absorbing.minimum[0] = true;
  const RunSettings above = run_settings(half);
  EXPECT_NEAR(absorbing_area<2>(above, above.particles, 0), 0.003, 1e-9);
}

// The faces of a window travel with it: its sites are those of a block that has moved as far.
TEST(AbsorbingSites, TravelWithTheWindow) {
  Case c = one_block();
  c.bodies[0].absorbing.minimum[0] = c.bodies[0].absorbing.maximum[0] = true;
  RunSettings settings = run_settings(c);
  const auto sites = sites_among<2>(settings, settings.particles);
  TravellingFrame frame;
  frame.sign = -1.0;
  frame.shift = 5e-3;
  settings.absorbing = MovingWindow{frame, settings.absorbing, {}}.absorbing_after(7);
  std::vector<NewParticle> moved = settings.particles;
  for (NewParticle& particle : moved) particle.position[0] -= 0.035;
  const auto there = sites_among<2>(settings, moved);
  ASSERT_EQ(there.size(), sites.size());
  ASSERT_EQ(sites.size(), 10u);
  for (std::size_t k = 0; k < sites.size(); ++k)
    EXPECT_NEAR(there[k].rate[0], sites[k].rate[0], 1e-9 * sites[k].rate[0]);
}

}  // namespace
}  // namespace kerf::test
