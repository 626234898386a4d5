// SPDX-License-Identifier: Apache-2.0
// Water beside the edge in which two rigid walls meet feels the whole gradient of a pressure that
// changes along the edge, and the whole divergence of a motion that is linear along it, whatever
// the angle of the walls against the lattice that fills them.
#include "fluid/gradient_in_corner.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/water_at_wall.hpp"

namespace kerf::test::at_wall {
namespace {

template <class Kind>
class GradientInCorners : public testing::Test {};
using CornerKinds = testing::Types<Kind<3, Double>, Kind<3, Mixed>>;
TYPED_TEST_SUITE(GradientInCorners, CornerKinds);

constexpr double angles[] = {0.0, 0.4, 1.1};
// Without the completion the water feels 0.6 of both. The particles of the walls see the water in
// one phase of its lattice.
constexpr double accuracy = 0.015;

LinearField corner_at(double angle) {
  LinearField field;
  field.in_corner = true;
  field.frame = turned<3>(angle);
  return field;
}

TYPED_TEST(GradientInCorners, PressureAlongTheEdgeIsFeltInFull) {
  for (const double angle : angles) {
    LinearField field = corner_at(angle);
    const Vector3 edge = field.frame.col(2);
    field.steepness = 0.1 * edge;
    const AtWall<3, typename TypeParam::P> water(field);
    ASSERT_TRUE(water.is_in_corner()) << angle;
    // dp/dx = rho_0 c^2 (1 + eps)^6 d eps/dx, over rho_0 (1 + eps), by the equation of Tait with
    // the exponent 7
    const double expected = -sound_speed * sound_speed * 0.1 * std::pow(1.0 + field.compression, 5);
    EXPECT_NEAR(water.acceleration().dot(edge) / expected, 1.0, accuracy) << angle;
  }
}

// The walls take what the pairs of water lack, so that momentum is conserved.
TYPED_TEST(GradientInCorners, TheWallsTakeTheReaction) {
  LinearField field = corner_at(0.0);
  const Vector3 edge = field.frame.col(2);
  field.steepness = 0.1 * edge;
  const AtWall<3, typename TypeParam::P> water(field);
  const double share = water.repulsion().dot(edge) / water.acceleration().dot(edge);
  EXPECT_GT(share, 0.3);
  EXPECT_LT(share, 0.5);
}

TYPED_TEST(GradientInCorners, DivergenceOfMotionAlongTheEdge) {
  constexpr double rate = 0.5;  // 1/s
  for (const double angle : angles) {
    LinearField field = corner_at(angle);
    const Vector3 edge = field.frame.col(2);
    field.motion = rate * edge * edge.transpose();
    const AtWall<3, typename TypeParam::P> water(field);
    EXPECT_NEAR(water.compression_rate() / -rate, 1.0, accuracy) << angle;
  }
}

// A third wall leaves nothing to complete: what two walls of a corner get, three do not.
TYPED_TEST(GradientInCorners, AdjugateOfTwoNormalsIsTheEdge) {
  const Vector3 n(0.6, 0.8, 0.0), m(-0.3, 0.9, 0.3);
  const Vector3 edge = n.cross(m).normalized();
  const Matrix3 normals = 0.7 * n * n.transpose() + 0.3 * m * m.transpose();
  Matrix<3, double> given;
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b) given(a, b) = normals(a, b);
  const auto across = adjugate(given);
  EXPECT_NEAR(determinant(given), 0.0, 1e-15);
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b)
      EXPECT_NEAR(across(a, b) / across.trace(), edge[a] * edge[b], 1e-12) << a << b;
}

}  // namespace
}  // namespace kerf::test::at_wall
