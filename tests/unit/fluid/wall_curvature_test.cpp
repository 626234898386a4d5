// SPDX-License-Identifier: Apache-2.0
// WallCurvature against v^2/R on cylinders and spheres, from the faces around a particle.
#include "fluid/wall_curvature.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>

namespace kerf::test::wall_curvature_test {
namespace {

using Eigen::Vector3d;

// Returns v^2/R from the faces of a cylinder around the z axis within an angle of 0.2 of the
// particle, which lies 0.5 above it at the angle 0; radius < 0: inside a hollow cylinder.
template <int D>
double centripetal_beside_cylinder(double radius, const Vector3d& velocity) {
  std::mt19937 engine(7);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const double side = std::copysign(1.0, radius), r = std::abs(radius);
  const Vector3d particle(r + 0.5 * side, 0.0, 0.0);
  WallCurvature<D, double> sum;
  double all = 0.0;
  for (int k = 0; k < 200; ++k) {
    const double angle = 0.2 * uniform(engine), z = D == 3 ? 0.2 * r * uniform(engine) : 0.0;
    const Vector3d outward(std::cos(angle), std::sin(angle), 0.0);
    const Vector3d foot = r * outward + Vector3d(0.0, 0.0, z) - particle, normal = side * outward;
    const double weight = 1.0 + 0.5 * uniform(engine);
    sum.add(weight, Vector<D, double>::from(foot), Vector<D, double>::from(normal),
            Vector<D, double>::from(velocity));
    all += weight;
  }
  return sum.centripetal(all, 1.0);
}

template <class Dimension>
class WallCurvatures : public testing::Test {};
using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(WallCurvatures, Dimensions);

TYPED_TEST(WallCurvatures, IsThatOfCylinders) {
  constexpr int D = TypeParam::value;
  for (const double radius : {5.0, -5.0, 20.0, -80.0}) {
    const double found = centripetal_beside_cylinder<D>(radius, Vector3d(0.0, -3.0, 0.0));
    EXPECT_NEAR(found * radius / 9.0, 1.0, 0.01) << radius;
  }
}

TEST(WallCurvature, IsNoneAlongTheAxisAndHalfOfItOnADiagonal) {
  EXPECT_NEAR(centripetal_beside_cylinder<3>(5.0, Vector3d(0.0, 0.0, 4.0)), 0.0, 0.05);
  const double diagonal = centripetal_beside_cylinder<3>(5.0, Vector3d(0.0, 3.0, 3.0));
  EXPECT_NEAR(diagonal, 9.0 / 5.0, 0.1 * 9.0 / 5.0);  // (v . t)^2 / R
}

TEST(WallCurvature, IsNoneOnAPlaneAndWithoutFaces) {
  WallCurvature<2, double> sum;
  const Vector<2, double> normal = Vector<2, double>::from(Vector3d(0.6, 0.8, 0.0));
  const Vector<2, double> velocity = Vector<2, double>::from(Vector3d(8.0, -6.0, 0.0));
  EXPECT_EQ(sum.centripetal(0.0, 1.0), 0.0);
  for (int k = -3; k <= 3; ++k)
    sum.add(1.0, Vector<2, double>::from(Vector3d(0.8 * k, -0.6 * k, 0.0)), normal, velocity);
  EXPECT_NEAR(sum.centripetal(7.0, 1.0), 0.0, 1e-12);
}

}  // namespace
}  // namespace kerf::test::wall_curvature_test
