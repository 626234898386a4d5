// SPDX-License-Identifier: Apache-2.0
// A solid whose particles know their faces acts on water as a rigid wall of the same particles
// does, and takes the opposite of all forces; without faces it acts along the lines of centres.
#include <gtest/gtest.h>

#include "fluid/wall_reaction.hpp"
#include "support/water_at_wall.hpp"

namespace kerf::test::at_wall {
namespace {

template <class Kind>
class SolidWalls : public testing::Test {};
TYPED_TEST_SUITE(SolidWalls, OtherTwoKinds);

// A pressure that changes along the wall and across it, and a motion along and towards the wall.
template <int D>
LinearField field_at(double angle) {
  LinearField field;
  field.frame = turned<D>(angle);
  field.steepness = field.frame * Vector3(0.1, -0.03, D == 3 ? 0.05 : 0.0);
  Matrix3 motion = Matrix3::Zero();
  motion(0, 0) = 0.4;
  motion(1, 1) = -0.3;
  field.motion = field.frame * motion * field.frame.transpose();
  return field;
}

TYPED_TEST(SolidWalls, ActAsRigidWallsOfTheSameParticles) {
  constexpr int D = TypeParam::D;
  using P = typename TypeParam::P;
  const double rounding = std::is_same_v<P, Double> ? 1e-12 : 1e-5;
  for (const double angle : {0.0, 0.4, 1.1}) {
    LinearField field = field_at<D>(angle);
    const AtWall<D, P> at_rigid(field);
    field.wall = Phase::solid;
    const AtWall<D, P> at_solid(field);
    EXPECT_LE((at_solid.acceleration() - at_rigid.acceleration()).norm(),
              rounding * at_rigid.acceleration().norm())
        << angle;
    EXPECT_NEAR(at_solid.compression_rate(), at_rigid.compression_rate(),
                rounding * std::abs(at_rigid.compression_rate()))
        << angle;
  }
}

TYPED_TEST(SolidWalls, TakeTheOppositeOfAllForces) {
  constexpr int D = TypeParam::D;
  using P = typename TypeParam::P;
  const double rounding = std::is_same_v<P, Double> ? 1e-13 : 1e-6;
  for (const double angle : {0.0, 0.4, 1.1}) {
    LinearField field = field_at<D>(angle);
    field.wall = Phase::solid;
    const AtWall<D, P> water(field);
    EXPECT_EQ(water.repulsion().norm(), 0.0) << angle;
    EXPECT_LE(water.total_force().norm(), rounding * water.sum_of_forces()) << angle;
  }
}

TYPED_TEST(SolidWalls, WithoutFacesActAlongTheLinesOfCentres) {
  constexpr int D = TypeParam::D;
  LinearField field = field_at<D>(0.4);
  field.wall = Phase::solid;
  const AtWall<D, typename TypeParam::P> smooth(field);
  field.has_faces = false;
  const AtWall<D, typename TypeParam::P> rough(field);
  const Vector3 along = field.frame.col(0);
  // The staircase holds up the water, and the gradient along it is not completed.
  EXPECT_GT(std::abs((rough.acceleration() - smooth.acceleration()).dot(along)),
            0.1 * std::abs(smooth.acceleration().dot(along)));
}

}  // namespace
}  // namespace kerf::test::at_wall
