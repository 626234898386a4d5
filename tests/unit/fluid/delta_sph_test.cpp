// SPDX-License-Identifier: Apache-2.0
// The terms of delta-SPH against double loops written from Antuono et al. (2010), and their
// property at free surfaces: a linear density has its exact gradient and does not diffuse.
#include <gtest/gtest.h>

#include <random>

#include "fluid/delta_sph.hpp"
#include "fluid/density_gradient.hpp"
#include "kernels/wendland_c2.hpp"
#include "pairs/pair_loop.hpp"
#include "support/kinds.hpp"
#include "support/loaded.hpp"
#include "support/mixture.hpp"

namespace kerf::test::delta_sph_test {
namespace {

constexpr double spacing = 1e-3;

// A block of water of 10 particles a side, randomly displaced, with free surfaces on all sides.
template <class Compression>
ReferenceState shaken_block(int dimension, const Compression& compression) {
  std::mt19937 engine(7);
  std::uniform_real_distribution<double> displacement(-0.2, 0.2);
  ReferenceState state;
  state.dimension = dimension;
  auto water = mixture_water(spacing, dimension);
  water.smoothing_length = 1.3 * spacing;
  water.volume = std::pow(spacing, dimension);
  state.media = {water};
  const int side = dimension == 2 ? 10 : 7;
  for (int k = 0; k < (dimension == 2 ? side * side : side * side * side); ++k) {
    ReferenceParticle particle;
    const int cell[3] = {k % side, k / side % side, k / (side * side)};
    for (int a = 0; a < dimension; ++a)
      particle.position[a] = spacing * (cell[a] + 2.0 + displacement(engine));
    particle.compression = compression(particle.position);
    state.particles.push_back(particle);
  }
  return state;
}

template <class K>
class DeltaSph : public testing::Test {};
TYPED_TEST_SUITE(DeltaSph, OtherTwoKinds);

template <int D, class P>
struct Diffused {
  explicit Diffused(const ReferenceState& state) : loaded(state, {}) {
    using Real = typename P::Real;
    const Index count = loaded.particles.size();
    const auto view = loaded.particles.view();
    gradient.resize(count);
    for_each_index(count, PairLoop<D, P, ContactPairs, DensityGradient<D, P>>(
                              view, loaded.list.view(), {}, {pointer(gradient)}));
    thrust::fill(loaded.particles.compression_rate.begin(), loaded.particles.compression_rate.end(),
                 Real(0));
    for_each_index(count, PairLoop<D, P, ContactPairs, DensityDiffusion<D, P>>(
                              view, loaded.list.view(), {}, {pointer(gradient)}));
  }
  Loaded<D, P, ContactPairs> loaded;
  Array<Vector<D, typename P::Real>> gradient;
};

// Volumes follow from densities, so that neither result is exact by cancellation of equal weights.
TYPED_TEST(DeltaSph, LinearDensityHasAnExactGradientAndNoDiffusion) {
  constexpr int D = TypeParam::D;
  using P = typename TypeParam::P;
  const Vector3 slope{3.0, -2.0, D == 3 ? 1.5 : 0.0};
  const Diffused<D, P> now(shaken_block(D, [&](const Vector3& x) { return slope.dot(x) + 0.01; }));
  const double tolerance = std::is_same_v<P, Double> ? 1e-10 : 1e-3;  // of sums of rounded terms
  for (Index i = 0; i < now.loaded.particles.size(); ++i) {
    EXPECT_LE((as_eigen(Vector<D, typename P::Real>(now.gradient[i])) - slope).norm(),
              tolerance * slope.norm());
    // The tolerance is delta h c / d times the differences that cancel, of about one spacing.
    EXPECT_LE(std::abs(double(now.loaded.particles.compression_rate[i])),
              tolerance * 0.1 * 1.3 * 50.0 * slope.norm());
  }
}

double wobble(const Vector3& x) {
  return 0.01 * std::sin(900.0 * x[0]) * std::cos(700.0 * x[1] + 400.0 * x[2]);
}

// d rho_i/dt = delta h c sum V_j [2 (rho_j - rho_i) r_ji / r^2 - (g_i + g_j)] . nabla W.
TYPED_TEST(DeltaSph, DiffusionIsTheSumOfItsPairs) {
  constexpr int D = TypeParam::D;
  using P = typename TypeParam::P;
  const ReferenceState state = shaken_block(D, wobble);
  const Diffused<D, P> now(state);
  const auto place = now.loaded.places();
  const double h = 1.3 * spacing, c = 50.0;
  double largest = 0.0, error = 0.0;
  for (std::size_t i = 0; i < state.particles.size(); ++i) {
    double due = 0.0;
    for (std::size_t j = 0; j < state.particles.size(); ++j) {
      const Vector3 apart = state.particles[i].position - state.particles[j].position;
      const double r = apart.norm();
      if (i == j || r >= 2.0 * h) continue;
      const Vector3 gradient = WendlandC2<D>::derivative(r, h) / r * apart;
      const double rho_i = state.particles[i].compression, rho_j = state.particles[j].compression;
      const Vector3 g =
          as_eigen(Vector<D, typename P::Real>(now.gradient[static_cast<Index>(place[i])])) +
          as_eigen(Vector<D, typename P::Real>(now.gradient[static_cast<Index>(place[j])]));
      const double volume = std::pow(spacing, D) / (1.0 + rho_j);
      const Vector3 psi = 2.0 * (rho_j - rho_i) * -apart / (r * r) - g;
      due += 0.1 * h * c * volume * psi.dot(gradient);
    }
    const double is = now.loaded.particles.compression_rate[static_cast<Index>(place[i])];
    largest = std::max(largest, std::abs(due));
    error = std::max(error, std::abs(is - due));
  }
  EXPECT_GT(largest, 0.0);
  EXPECT_LE(error, (std::is_same_v<P, Double> ? 1e-12 : 1e-4) * largest);
}

// Diffusion smooths: the squares of the differences of density decrease.
TYPED_TEST(DeltaSph, DiffusionSmooths) {
  constexpr int D = TypeParam::D;
  using P = typename TypeParam::P;
  const Diffused<D, P> now(shaken_block(D, wobble));
  double change = 0.0;
  for (Index i = 0; i < now.loaded.particles.size(); ++i)
    change += double(now.loaded.particles.compression[i]) *
              double(now.loaded.particles.compression_rate[i]);
  EXPECT_LT(change, 0.0);
}

// - 2 V_i V_j P_d nabla W against alpha rho c h V_i V_j (v_ij . r_ij / r^2) nabla W, and its power.
TEST(DeltaSphPair, HasMeanPressureAndArtificialViscosity) {
  const RiemannSide<double> left{1010.0 * 50.0, 3e3, 2.0, 50.0},
      right{1010.0 * 50.0, 1e3, -1.0, 50.0};
  const double h = 1.3e-3, r = 1e-3;
  const auto star = DeltaSphPair::solve(left, right, h / r);
  EXPECT_EQ(star.mean_pressure, 2e3);
  EXPECT_EQ(star.speed, 0.5);
  // U = - v . e, e from j to i: v_ij . r_ij = - (U_l - U_r) r.
  const double along = -(left.speed - right.speed) * r / (r * r);
  EXPECT_NEAR(-2.0 * star.dissipation, 0.02 * 1010.0 * 50.0 * h * along, 1e-9);
  const auto parting = DeltaSphPair::solve(right, left, h / r);
  EXPECT_EQ(parting.dissipation, -star.dissipation);  // it resists separation
}

}  // namespace
}  // namespace kerf::test::delta_sph_test
