// SPDX-License-Identifier: Apache-2.0
// The face of a particle of a solid after a homogeneous deformation is the plane through three
// deformed points of the plane that it was.
#include "standard/turn_faces.hpp"

#include <gtest/gtest.h>

#include <random>

#include "support/mixture.hpp"
#include "support/standard_mixture.hpp"

namespace kerf::test {
namespace {

// One particle of a solid, with a face at rest.
template <int D, class P>
class OneFace {
 public:
  using Real = typename P::Real;

  OneFace(const Vector3& normal, double depth, const Vector3& corner = Vector3::Zero()) {
    particles_.groups = {};
    const std::vector<Medium<double>> media{mixture_solid(1e-3, D, 0)};
    to_device(std::vector<Medium<Real>>{Medium<Real>::from(media[0])}, particles_.media);
    NewParticle particle;
    for (int a = 0; a < D; ++a) {
      particle.face_normal[static_cast<std::size_t>(a)] = normal[a];
      particle.face_corner[static_cast<std::size_t>(a)] = corner[a];
    }
    particle.face_depth = depth;
    particles_.append({particle}, media);
  }
  void turn(const Matrix3& gradient, bool is_damaged = false) {
    Matrix<D, Real> h;
    for (int a = 0; a < D; ++a)
      for (int b = 0; b < D; ++b) h(a, b) = Real(gradient(a, b) - (a == b ? 1.0 : 0.0));
    const Real damaged = is_damaged ? Real(1) : Real(0);
    const Index number = 0;
    Index particle = 0;
    const SolidIndexView link{&number, 1, &particle};
    TurnFaces<D, P>{particles_.view(), link, {}, &h, &damaged}(0);
  }
  Vector3 normal() {
    return as_eigen(Vector<D, double>::from(Vector<D, Real>(particles_.face_normal[0])));
  }
  double depth() { return particles_.face_depth[0]; }
  Particles<D, P>& particles() { return particles_; }

 private:
  Particles<D, P> particles_;
};

template <class Kind>
class FacesOfSolids : public testing::Test {};
TYPED_TEST_SUITE(FacesOfSolids, OtherTwoKinds);

template <int D>
Matrix3 random_gradient(std::mt19937& engine) {
  std::uniform_real_distribution<double> uniform(-0.6, 0.6);
  Matrix3 gradient = Matrix3::Identity();
  for (int a = 0; a < D; ++a)
    for (int b = 0; b < D; ++b) gradient(a, b) += uniform(engine);
  return gradient;
}

template <int D>
Vector3 random_normal(std::mt19937& engine) {
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  return Vector3(uniform(engine), uniform(engine), D == 3 ? uniform(engine) : 0.0).normalized();
}

TYPED_TEST(FacesOfSolids, AreThePlanesThroughDeformedPoints) {
  constexpr int D = TypeParam::D;
  using P = typename TypeParam::P;
  const double rounding = std::is_same_v<P, Double> ? 1e-12 : 2e-5;
  constexpr double depth = 4e-4;
  std::mt19937 engine(3);
  for (int n = 0; n < 50; ++n) {
    const Matrix3 gradient = random_gradient<D>(engine);
    if (gradient.determinant() < 0.2) continue;
    const Vector3 at_rest = random_normal<D>(engine);
    OneFace<D, P> face(at_rest, depth);
    face.turn(gradient);
    // Two directions in the plane; in 2D the second is that of z.
    const Vector3 one = at_rest.unitOrthogonal();
    const Vector3 first = D == 2 ? Vector3(at_rest[1], -at_rest[0], 0.0) : one;
    const Vector3 second = D == 2 ? Vector3(Vector3::UnitZ()) : Vector3(at_rest.cross(one));
    Vector3 expected = (gradient * first).cross(gradient * second).normalized();
    const double height = expected.dot(gradient * (depth * at_rest));
    if (height < 0.0) expected *= -1.0;
    EXPECT_LE((face.normal() - expected).norm(), rounding) << n;
    EXPECT_NEAR(face.depth(), std::abs(height), rounding * depth) << n;
  }
}

TYPED_TEST(FacesOfSolids, StayBitForBitWithoutDeformation) {
  std::mt19937 engine(4);
  OneFace<TypeParam::D, typename TypeParam::P> face(random_normal<TypeParam::D>(engine), 3e-4);
  face.turn(Matrix3::Identity());
  const Vector3 normal = face.normal();
  const double depth = face.depth();
  face.turn(Matrix3::Identity());
  EXPECT_EQ(face.normal(), normal);
  EXPECT_EQ(face.depth(), depth);
}

TYPED_TEST(FacesOfSolids, EndWithDamageAndCollapse) {
  constexpr int D = TypeParam::D;
  const Vector3 up = Vector3::UnitY();
  OneFace<D, typename TypeParam::P> face(up, 3e-4);
  face.turn(Matrix3::Identity(), true);
  EXPECT_EQ(face.normal().norm(), 0.0);
  face.turn(Matrix3::Identity());
  EXPECT_NEAR(face.normal()[1], 1.0, 1e-6);
  Matrix3 flat = Matrix3::Identity();
  flat(1, 1) = 0.01;
  face.turn(flat);
  EXPECT_EQ(face.normal().norm(), 0.0);
  // Debris is a fluid, whose normal is that of the wall beside it.
  face.particles().fractured[0] = 1;
  face.turn(Matrix3::Identity());
  EXPECT_EQ(face.normal().norm(), 0.0);
}

// A particle between two faces, whose body turns and swells: water on either side of it sees the
// face of its side, and water on the bisector none.
TYPED_TEST(FacesOfSolids, OfACornerTurnWithTheBody) {
  constexpr int D = TypeParam::D;
  using P = typename TypeParam::P;
  using Real = typename TypeParam::P::Real;
  constexpr double depth = 4e-4, growth = 1.2;  // m, 1
  const double rounding = std::is_same_v<Real, float> ? 1e-6 : 1e-12;
  const Vector3 axis = D == 2 ? Vector3(0, 0, 1) : Vector3(1, 2, -1).normalized();
  const Matrix3 turned = Eigen::AngleAxisd(2.1, axis).toRotationMatrix();
  const Vector3 one(std::cos(0.3), std::sin(0.3), 0.0), other(std::cos(1.5), std::sin(1.5), 0.0);
  OneFace<D, P> face((one + other) / 2.0, depth, (one - other) / 2.0);
  const auto seen_from = [&](const Vector3& place) {
    Vector<D, Real> separation;
    for (int a = 0; a < D; ++a) separation[a] = Real(1e-3 * place[a]);
    return as_eigen(Vector<D, double>::from(seen_face(face.particles().view(), 0, separation)));
  };
  for (const Matrix3& by : {Matrix3(Matrix3::Identity()), turned}) {
    if (!by.isIdentity()) face.turn(growth * by);
    for (const double nearer : {0.51, 0.6, 0.9}) {
      const Vector3 place = by * (nearer * one + (1.0 - nearer) * other);
      EXPECT_LE((seen_from(place) - by * one).norm(), rounding);
      const Vector3 beside = by * ((1.0 - nearer) * one + nearer * other);
      EXPECT_LE((seen_from(beside) - by * other).norm(), rounding);
    }
    EXPECT_EQ(seen_from(by * (one + other)).norm(), 0.0);
    EXPECT_NEAR(face.depth(), by.isIdentity() ? depth : growth * depth, rounding * depth);
  }
  face.turn(Matrix3::Identity(), true);
  EXPECT_EQ(seen_from(one).norm(), 0.0);
}

}  // namespace
}  // namespace kerf::test
