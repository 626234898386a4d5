// SPDX-License-Identifier: Apache-2.0
// Shifting moves particles of water to positions with fewer neighbours, without a change of
// surfaces.
#include "fluid/shifting.hpp"

#include <gtest/gtest.h>

#include <random>

#include "fluid/particle_concentration.hpp"
#include "kernels/wendland_c2.hpp"
#include "pairs/pair_loop.hpp"
#include "support/kinds.hpp"
#include "support/loaded.hpp"
#include "support/mixture.hpp"
#include "time/verlet.hpp"

namespace kerf::test::shifting_test {
namespace {

constexpr double spacing = 1e-3, dt = 1e-5, max_relative_velocity = 1e3;
constexpr int side = 14;

// A block of water whose lattice is randomly displaced by up to `amplitude` spacings.
ReferenceState block(int dimension, double amplitude) {
  std::mt19937 engine(3);
  std::uniform_real_distribution<double> uniform(-amplitude, amplitude);
  ReferenceState state;
  state.dimension = dimension;
  auto water = mixture_water(spacing, dimension);
  water.smoothing_length = 1.3 * spacing;
  water.volume = std::pow(spacing, dimension);
  state.media = {water};
  const int rows = dimension == 2 ? 1 : side;
  for (int k = 0; k < side * side * rows; ++k) {
    ReferenceParticle particle;
    const int cell[3] = {k % side, k / side % side, k / (side * side)};
    for (int a = 0; a < dimension; ++a)
      particle.position[a] = spacing * (cell[a] + 1.5 + uniform(engine));
    state.particles.push_back(particle);
  }
  return state;
}

template <int D, class P>
struct Shifted {
  using Real = typename P::Real;

  explicit Shifted(const ReferenceState& state) : loaded(state, {0.0, 0.02, 5e-4}) {
    auto& particles = loaded.particles;
    thrust::fill(particles.next_wall_normal.begin(), particles.next_wall_normal.end(),
                 Vector<D, Real>::zero());
    concentration_gradient.resize(particles.size());
    look();
    thrust::fill(particles.max_relative_velocity.begin(), particles.max_relative_velocity.end(),
                 Real(max_relative_velocity));
  }
  void look() {
    const auto view = loaded.particles.view();
    using Concentration = ParticleConcentration<D, P, ContactPairs::Kernel<D>>;
    const Real kept = loaded.particles.max_relative_velocity.empty()
                          ? Real(0)
                          : Real(loaded.particles.max_relative_velocity[0]);
    for_each_index(loaded.particles.size(), PairLoop<D, P, ContactPairs, Concentration>(
                                                view, loaded.list.view(), {}, Concentration{}));
    thrust::fill(loaded.particles.max_relative_velocity.begin(),
                 loaded.particles.max_relative_velocity.end(), kept);
    for_each_index(loaded.particles.size(), UpdateSurfaceFlags<D, P>{view});
    for_each_index(loaded.particles.size(),
                   PairLoop<D, P, ContactPairs, ConcentrationGradientSum<D, P>>(
                       view, loaded.list.view(), {}, {pointer(concentration_gradient)}));
  }
  void shift() {
    for_each_index(
        loaded.particles.size(),
        ShiftParticles<D, P>{loaded.particles.view(), pointer(concentration_gradient), dt});
  }
  // Returns the number of rows between a position and the nearest side of the block, from 0.
  int depth(Index i) const {
    int least = side;
    const Vector<D, double> place = loaded.particles.build_position[i];
    for (int a = 0; a < D; ++a) {
      const int row = int(std::lround(place[a] / spacing - 1.5));
      least = std::min({least, row, side - 1 - row});
    }
    return least;
  }

  Loaded<D, P, ContactPairs> loaded;
  Array<ConcentrationGradient<D, Real>> concentration_gradient;
};

template <class K>
class Shifting : public testing::Test {};
TYPED_TEST_SUITE(Shifting, OtherTwoKinds);

// Opposite neighbours cancel to rounding.
TYPED_TEST(Shifting, LatticeIsUnchanged) {
  constexpr int D = TypeParam::D;
  using P = typename TypeParam::P;
  Shifted<D, P> water(block(D, 0.0));
  water.shift();
  const double rounding = std::is_same_v<P, Double> ? 1e-12 : 1e-5;
  for (Index i = 0; i < water.loaded.particles.size(); ++i)
    EXPECT_LE(norm(water.loaded.particles.position[i] - water.loaded.particles.build_position[i]),
              rounding * spacing);
}

// C_i = sum V nabla W by a double loop; dr = - h^2 min(20 max_relative_velocity dt, 1/4) C inside,
// 0 in three rows at the sides.
template <int D, class P>
void expect_moved_from_the_crowd(double stirred, double share) {
  const ReferenceState state = block(D, 0.05);
  Shifted<D, P> water(state);
  thrust::fill(water.loaded.particles.max_relative_velocity.begin(),
               water.loaded.particles.max_relative_velocity.end(), typename P::Real(stirred));
  water.shift();
  const double h = 1.3 * spacing, tolerance = std::is_same_v<P, Double> ? 1e-10 : 1e-3;
  int inside = 0;
  for (Index i = 0; i < water.loaded.particles.size(); ++i) {
    const auto& p = water.loaded.particles;
    const Vector3 moved = as_eigen(Vector<D, double>(p.position[i])) -
                          as_eigen(Vector<D, double>(p.build_position[i]));
    if (water.depth(i) < 3) {
      EXPECT_EQ(moved.norm(), 0.0);
    }
    if (water.depth(i) < 5) continue;  // a displaced particle may have a neighbour near the surface
    ++inside;
    Vector3 concentration_gradient = Vector3::Zero();
    for (const ReferenceParticle& other : state.particles) {
      const Vector3 apart = as_eigen(Vector<D, double>(p.build_position[i])) - other.position;
      const double r = apart.norm();
      if (r > 0.0 && r < 2.0 * h)
        concentration_gradient +=
            std::pow(spacing, D) * WendlandC2<D>::derivative(r, h) / r * apart;
    }
    const Vector3 due = -share * h * h * concentration_gradient;
    ASSERT_LT(due.norm(), 0.1 * spacing);
    EXPECT_LE((moved - due).norm(), tolerance * spacing * 0.05);
  }
  EXPECT_EQ(inside, std::pow(side - 10, D));
}

TYPED_TEST(Shifting, ActsAgainstTheConcentrationGradientInside) {
  expect_moved_from_the_crowd<TypeParam::D, typename TypeParam::P>(
      max_relative_velocity, 20.0 * max_relative_velocity * dt);
}

TYPED_TEST(Shifting, IsBoundedForAnyVorticity) {
  expect_moved_from_the_crowd<TypeParam::D, typename TypeParam::P>(100.0 * max_relative_velocity,
                                                                   0.25);
}

// A hundred steps remove more than half of the random displacement.
TYPED_TEST(Shifting, EqualisesTheDistribution) {
  constexpr int D = TypeParam::D;
  using P = typename TypeParam::P;
  Shifted<D, P> water(block(D, 0.1));
  const auto concentration_gradient = [&] {
    double sum = 0.0;
    for (Index i = 0; i < water.loaded.particles.size(); ++i) {
      const auto gradient =
          ConcentrationGradient<D, typename P::Real>(water.concentration_gradient[i]).gradient;
      if (water.depth(i) >= 5) sum += double(dot(gradient, gradient));
    }
    return sum;
  };
  const double before = concentration_gradient();
  for (int n = 0; n < 100; ++n) {
    water.shift();
    water.look();
  }
  EXPECT_LT(concentration_gradient(), 0.25 * before);
}

// Water without relative velocity, and water in a nozzle, is not shifted; at a wall it is shifted
// only along the wall.
TEST(Shifting2D, ExcludesSurfacesAndOtherMatter) {
  Shifted<2, Double> water(block(2, 0.1));
  auto& p = water.loaded.particles;
  const Vector<2, double> up{{0.0, 1.0}};
  for (Index i = 0; i < p.size(); ++i) {
    if (i % 3 == 0) p.max_relative_velocity[i] = 0.0;
    if (i % 3 == 1) p.flags[i] = flag::upstream;
    if (i % 3 == 2) p.wall_normal[i] = up;
  }
  water.shift();
  double along = 0.0;
  for (Index i = 0; i < p.size(); ++i) {
    const auto moved = Vector<2, double>(p.position[i]) - Vector<2, double>(p.build_position[i]);
    EXPECT_LE(std::abs(moved[1]), 1e-16);
    if (i % 3 != 2) {
      EXPECT_EQ(moved[0], 0.0);
    }
    along += std::abs(moved[0]);
  }
  EXPECT_GT(along, 0.0);
}

}  // namespace
}  // namespace kerf::test::shifting_test
