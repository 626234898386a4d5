// SPDX-License-Identifier: Apache-2.0
// Water in the first row at a plane rigid wall feels the whole gradient of a pressure that changes
// along the wall, and the whole divergence of a motion that is linear, whatever the angle of the
// wall against the lattice that fills it.
#include "fluid/gradient_at_wall.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "fluid/lattice_sums.hpp"
#include "kernels/wendland_c2.hpp"
#include "support/standard_mixture.hpp"
#include "time/verlet.hpp"

namespace kerf::test::gradient_at_wall_test {
namespace {

constexpr double spacing = 1e-3, centre = 0.01, sound_speed = 50.0, density = 1000.0;
constexpr int reach = 5;  // rows of water and wall on each side of the particle that is judged

// The water moves by v = motion (x - f), with the foot f of the particle that is judged on the
// wall; its compression changes by `steepness` (x - x_i).
struct LinearField {
  Matrix3 frame = Matrix3::Identity();  // columns: along the wall, its normal, along the wall
  Matrix3 motion = Matrix3::Zero();     // 1/s
  Vector3 steepness = Vector3::Zero();  // 1/m
  double compression = 1e-3;
  double height = 0.5;  // of the first row above the wall, spacings
};

template <int D, class P>
class AtWall {
 public:
  using Real = typename P::Real;

  explicit AtWall(const LinearField& field) : field_(field), loaded_(state(), {0.0, 0.02, 5e-4}) {
    auto& particles = loaded_.particles;
    const auto place = loaded_.places();
    for (std::size_t k = 0; k < place.size(); ++k) {
      if (state_.particles[k].source == 0) continue;
      particles.face_normal[place[k]] = Vector<D, Real>::from(Vector3(field.frame.col(1)));
      particles.face_depth[place[k]] = Real(-above_wall(state_.particles[k].position));
    }
    // The normal of the wall is known after one step, the factors of its sums after two.
    for (int step = 0; step < 3; ++step) {
      evaluate();
      for_each_index(particles.size(), UpdateSurfaceFlags<D, P>{particles.view()});
      thrust::fill(particles.flags.begin(), particles.flags.end(), std::uint8_t(0));
    }
    water_ = place[0];
  }
  Vector3 acceleration() const {
    return as_eigen(
        Vector<D, double>::from(Vector<D, Real>(loaded_.particles.acceleration[water_])));
  }
  // The reaction of the wall is the part that is no pair of water.
  Vector3 repulsion() const {
    return as_eigen(Vector<D, double>::from(Vector<D, Real>(loaded_.particles.repulsion[water_])));
  }
  double compression_rate() const { return loaded_.particles.compression_rate[water_]; }

 private:
  void evaluate() {
    auto& particles = loaded_.particles;
    const StandardRates<D, P> rates({}, state_.media, lattice_sums<D, WendlandC2<D>>(1.3));
    thrust::fill(particles.solid_initial_overlap.begin(), particles.solid_initial_overlap.end(), 1);
    thrust::fill(particles.rigid_initial_overlap.begin(), particles.rigid_initial_overlap.end(), 1);
    Array<ConcentrationGradient<D, Real>> gradient(particles.size());
    rates.evaluate(particles.view(), particles.size(), loaded_.list.view(), MixtureBonds<D, P>{},
                   pointer(gradient));
  }
  Vector3 from_water(const Vector3& x) const {
    return x - Vector3(centre, centre, D == 3 ? centre : 0.0);
  }
  double above_wall(const Vector3& x) const {
    return field_.frame.col(1).dot(from_water(x)) + field_.height * spacing;
  }
  const ReferenceState& state() {
    state_.dimension = D;
    auto water = mixture_water(spacing, D);
    water.smoothing_length = 1.3 * spacing;
    water.viscosity = 0.0;
    water.volume = std::pow(spacing, D);
    water.mass = density * water.volume;
    auto rigid = mixture_rigid(spacing);
    rigid.smoothing_length = water.smoothing_length;
    rigid.volume = water.volume;
    state_.media = {water, rigid};
    constexpr int side = 2 * reach + 1, count = side * side * (D == 3 ? side : 1);
    add_water(Vector3::Zero());  // the particle that is judged comes first
    for (int n = 0; n < count; ++n) {
      const Vector3 node(n % side - reach, n / side % side - reach,
                         D == 3 ? n / (side * side) - reach : 0);
      if (node[1] >= 0.0 && !node.isZero()) add_water(spacing * node);
      add_wall(spacing * node);
    }
    return state_;
  }
  void add_water(const Vector3& along_wall) {
    ReferenceParticle particle;
    const Vector3 offset = field_.frame * along_wall;
    particle.position = offset + Vector3(centre, centre, D == 3 ? centre : 0.0);
    particle.velocity = field_.motion * (offset + field_.height * spacing * field_.frame.col(1));
    particle.compression = field_.compression + field_.steepness.dot(offset);
    state_.particles.push_back(particle);
  }
  // The lattice of the wall is not in line with its face, unless the frame is the identity.
  void add_wall(const Vector3& node) {
    ReferenceParticle particle;
    particle.source = 1;
    particle.position = node + Vector3(centre, centre, D == 3 ? centre : 0.0);
    if (above_wall(particle.position) <= 0.0) state_.particles.push_back(particle);
  }

  LinearField field_;
  ReferenceState state_;
  Loaded<D, P, ContactPairs> loaded_;
  std::size_t water_ = 0;
};

template <int D>
Matrix3 turned(double angle) {
  const Vector3 axis = D == 3 ? Vector3(0.3, -0.5, 0.8).normalized() : Vector3(Vector3::UnitZ());
  return Eigen::AngleAxisd(angle, axis).toRotationMatrix();
}

template <class Kind>
class GradientAtWalls : public testing::Test {};
TYPED_TEST_SUITE(GradientAtWalls, MixtureKinds);

// Without the completion the first row feels 0.78 of the gradient. A wall whose lattice is not in
// line with its face is a staircase, whose factor f_i is that of its sum along the normal alone.
double tolerance_at(double angle) {
  return angle == 0.0 ? 5e-3 : 0.14;
}

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
    EXPECT_NEAR(water.acceleration().dot(along) / expected, 1.0, tolerance_at(angle)) << angle;
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
    const double tolerance = tolerance_at(angle) * stretch;
    field.motion = field.frame * along * field.frame.transpose();
    EXPECT_NEAR((AtWall<D, typename TypeParam::P>(field).compression_rate()), -stretch, tolerance)
        << angle;
    field.motion = field.frame * stagnation * field.frame.transpose();
    EXPECT_NEAR((AtWall<D, typename TypeParam::P>(field).compression_rate()), 0.0, tolerance)
        << angle;
  }
}

}  // namespace
}  // namespace kerf::test::gradient_at_wall_test
