// SPDX-License-Identifier: Apache-2.0
// Water in the first row at a plane rigid wall feels the whole gradient of a pressure that changes
// along the wall, and the whole divergence of a motion that is linear, whatever the angle of the
// wall against the lattice that fills it.
#include "fluid/gradient_at_wall.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "support/water_at_wall.hpp"

namespace kerf::test::at_wall {
namespace {

template <class Kind>
class GradientAtWalls : public testing::Test {};
TYPED_TEST_SUITE(GradientAtWalls, OtherTwoKinds);

// Without the completion the first row feels 0.78 of the gradient.
// The particles of the wall see the water in one phase of its lattice; the mean over phases, which
// the layers have, differs by 2% of the part of the wall.
constexpr double within = 7e-3;

TYPED_TEST(GradientAtWalls, PressureAlongTheWallIsFeltInFull) {
  constexpr int D = TypeParam::D;
  for (const double angle : {0.0, 0.4, 1.1}) {
    LinearField field;
    field.frame = turned<D>(angle);
    const Vector3 along = D == 3 ? Vector3((field.frame.col(0) + field.frame.col(2)).normalized())
                                 : Vector3(field.frame.col(0));
    field.steepness = 0.1 * along;
    const AtWall<D, typename TypeParam::P> water(field);
    // dp/dx = rho_0 c^2 (1 + eps)^6 d eps/dx, over rho_0 (1 + eps): the equation of Tait, exponent
    // 7
    const double expected = -sound_speed * sound_speed * 0.1 * std::pow(1.0 + field.compression, 5);
    EXPECT_NEAR(water.acceleration().dot(along) / expected, 1.0, within) << angle;
    const Vector3 across_plane = along.cross(field.frame.col(1));
    EXPECT_NEAR(water.acceleration().dot(across_plane) / expected, 0.0, 0.05) << angle;
  }
}

// The wall takes as much as the pairs of water lack, so that momentum is conserved.
TYPED_TEST(GradientAtWalls, TheWallTakesTheReaction) {
  LinearField field;
  field.steepness = Vector3(0.1, 0.0, 0.0);
  const AtWall<TypeParam::D, typename TypeParam::P> water(field);
  const double share = water.repulsion()[0] / water.acceleration()[0];
  EXPECT_GT(share, 0.15);
  EXPECT_LT(share, 0.3);
}

// Water that stretches along the wall, and water that comes to the wall as it leaves along it,
// without divergence.
TYPED_TEST(GradientAtWalls, DivergenceOfLinearMotion) {
  constexpr int D = TypeParam::D;
  constexpr double rate = 0.5;  // 1/s
  for (const double angle : {0.0, 0.4, 1.1}) {
    LinearField field;
    field.frame = turned<D>(angle);
    Matrix3 along = Matrix3::Zero();
    along(0, 0) = rate;
    if (D == 3) along(2, 2) = 0.4 * rate;
    const double stretch = along.trace();
    Matrix3 stagnation = along;
    stagnation(1, 1) = -stretch;
    const double tolerance = within * stretch;
    field.motion = field.frame * along * field.frame.transpose();
    EXPECT_NEAR((AtWall<D, typename TypeParam::P>(field).compression_rate()), -stretch, tolerance)
        << angle;
    field.motion = field.frame * stagnation * field.frame.transpose();
    EXPECT_NEAR((AtWall<D, typename TypeParam::P>(field).compression_rate()), 0.0, tolerance)
        << angle;
  }
}

}  // namespace
}  // namespace kerf::test::at_wall
