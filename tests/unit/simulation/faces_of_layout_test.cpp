// SPDX-License-Identifier: Apache-2.0
// Which faces of bodies the particles of a case know: not those in a symmetry plane, nor those at
// which a solid is joined to another.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "simulation/populate.hpp"
#include "support/small_cases.hpp"

namespace kerf::test {
namespace {

constexpr double face_spacing = 1e-3;  // m

Case empty_plane() {
  Case c = empty_case(2, PrecisionKind::double_precision);
  c.formulation = Formulation::standard;
  c.jets = {jet(5e-3, face_spacing, {0.0, 0.0, 0.0}, 2e-3)};  // faces of solids are for water
  return c;
}

// The face of the particle nearest to a point, m.
const NewParticle& at(const std::vector<NewParticle>& particles, double x, double y) {
  const auto distance = [&](const NewParticle& p) {
    return std::hypot(p.position[0] - x, p.position[1] - y);
  };
  return *std::min_element(
      particles.begin(), particles.end(),
      [&](const NewParticle& a, const NewParticle& b) { return distance(a) < distance(b); });
}

void expect_face(const NewParticle& particle, double x, double y) {
  EXPECT_NEAR(particle.face_normal[0], x, 1e-9);
  EXPECT_NEAR(particle.face_normal[1], y, 1e-9);
}

TEST(FacesOfLayout, EndInASymmetryPlane) {
  for (const Role role : {Role::elastic, Role::rigid}) {
    Case c = empty_plane();
    c.domain.minimum[0] = 0.0;
    c.symmetry.minimum = {true, false, false};
    for (const double left : {0.0, -0.01}) {  // a body that ends in the plane, and one across it
      c.bodies = {body("block", role, box({left, -0.01, 0.0}, {0.01, 0.0, 0.0}), face_spacing)};
      const auto particles = initial_particles(c, {}).particles;
      expect_face(at(particles, 0.5e-3, -0.5e-3), 0.0, 1.0);
      expect_face(at(particles, 0.5e-3, -1.5e-3), 0.0, 1.0);
      expect_face(at(particles, 9.5e-3, -4.5e-3), 1.0, 0.0);
      EXPECT_EQ(at(particles, 0.5e-3, -4.5e-3).face_depth, 0.0) << "deep inside";
    }
  }
}

TEST(FacesOfLayout, EndWhereASolidIsJoinedToAnother) {
  Case c = empty_plane();
  c.bodies = {body("one", Role::elastic, box({-0.01, -0.01, 0.0}, {0.0, 0.0, 0.0}), face_spacing),
              body("two", Role::elastic, box({0.0, -0.01, 0.0}, {0.01, 0.0, 0.0}), face_spacing)};
  const auto apart = initial_particles(c, {}).particles;
  expect_face(at(apart, -0.5e-3, -1.5e-3), 1.0, 0.0);
  expect_face(at(apart, 0.5e-3, -1.5e-3), -1.0, 0.0);
  c.bodies[1].joined_to = "one";
  const auto joined = initial_particles(c, {}).particles;
  expect_face(at(joined, -0.5e-3, -1.5e-3), 0.0, 1.0);
  expect_face(at(joined, 0.5e-3, -1.5e-3), 0.0, 1.0);
}

}  // namespace
}  // namespace kerf::test
