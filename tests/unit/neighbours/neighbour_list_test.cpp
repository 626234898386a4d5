// SPDX-License-Identifier: Apache-2.0
// The neighbour list against all pairs, and the rules of interaction.
#include "neighbours/neighbour_list.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "support/loaded.hpp"
#include "support/mixture.hpp"

namespace kerf::test {
namespace {

constexpr double skin = 5e-4;  // m

// Returns the reach of j on i, from the definition of the model: h_i + h_j = 2 (h_i + h_j)/2 among
// water and solid; d_0 for the repelling layer of a rigid body; 0 for a rigid body i.
double sight(const ReferenceState& state, std::size_t i, std::size_t j) {
  const auto &a = state.medium(i), &b = state.medium(j);
  if (a.phase == Phase::rigid) return 0.0;
  if (b.phase != Phase::rigid) return a.smoothing_length + b.smoothing_length;
  return state.particles[j].repelling ? 0.5 * (a.spacing + b.spacing) : 0.0;
}

// Every pair within the reach and `least_skin` must be listed, no pair beyond `most_skin` may be
// listed; a distance equal to the limit up to rounding may have either result.
template <int D>
void expect_all_pairs(const ReferenceState& state, const Loaded<D, Double>& loaded,
                      double least_skin, double most_skin) {
  const auto lists = loaded.neighbours();
  const std::size_t n = state.particles.size();
  std::size_t pairs = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const std::set<std::size_t> listed(lists[i].begin(), lists[i].end());
    ASSERT_EQ(listed.size(), lists[i].size()) << "a neighbour of " << i << " is listed twice";
    for (std::size_t j = 0; j < n; ++j) {
      const double reach = i == j ? 0.0 : sight(state, i, j);
      const double r = (state.particles[i].position - state.particles[j].position).norm();
      const bool must = reach > 0.0 && r < (reach + least_skin) * (1.0 - 1e-12);
      const bool may = reach > 0.0 && r < (reach + most_skin) * (1.0 + 1e-12);
      const bool is = listed.count(j) > 0;
      ASSERT_TRUE(is ? may : !must) << i << " and " << j << " at " << r << " m, reach " << reach;
      pairs += must ? 1 : 0;
    }
  }
  EXPECT_GT(pairs, n);  // otherwise nothing is tested
}

ReferenceState mixture(int dimension, unsigned seed, double jitter, double stretch = 1.0) {
  MixtureChoice choice;
  choice.dimension = dimension;
  choice.seed = seed;
  choice.jitter = jitter;
  choice.per_side = dimension == 2 ? 18 : 8;
  ReferenceState state = random_mixture(choice);
  for (auto& particle : state.particles) particle.position *= stretch;
  return state;
}

template <class Dimension>
class NeighbourLists : public testing::Test {
 protected:
  static constexpr int D = Dimension::value;
};
using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(NeighbourLists, Dimensions);

TYPED_TEST(NeighbourLists, RandomPoints) {
  for (unsigned seed : {1u, 2u}) {
    const auto state = mixture(TestFixture::D, seed, 0.49);
    const Loaded<TestFixture::D, Double> loaded(state, {0.0, 0.018, skin});
    expect_all_pairs(state, loaded, skin, skin);
  }
}

// The particles are spread out, so that the reach is a fraction of the domain and there are many
// cells.
TYPED_TEST(NeighbourLists, RandomPointsInManyCells) {
  auto state = mixture(TestFixture::D, 3, 0.49, 8.0);
  std::mt19937 engine(5);
  for (std::size_t k = 0; k + 1 < state.particles.size(); k += 2) {
    auto& pair = state.particles[k + 1];
    pair.position = state.particles[k].position;
    for (int a = 0; a < TestFixture::D; ++a)
      pair.position[a] += std::uniform_real_distribution<double>(-4e-3, 4e-3)(engine);
  }
  const Loaded<TestFixture::D, Double> loaded(state, {0.0, 0.144, skin});
  expect_all_pairs(state, loaded, skin, skin);
}

TYPED_TEST(NeighbourLists, Lattice) {
  const auto state = mixture(TestFixture::D, 4, 0.0);
  const Loaded<TestFixture::D, Double> loaded(state, {0.0, 0.018, skin});
  expect_all_pairs(state, loaded, skin, skin);
}

TYPED_TEST(NeighbourLists, SizeRatios) {
  for (std::size_t coarse : {std::size_t{2}, std::size_t{3}, std::size_t{4}}) {
    auto state = mixture(TestFixture::D, 6, 0.3, 3.0);
    // Solids of 1, 2 or 4 times the spacing beside water of the finest spacing.
    for (auto& particle : state.particles) particle.source = particle.source % 2 ? coarse : 0;
    for (auto& particle : state.particles) particle.repelling = false;
    const Loaded<TestFixture::D, Double> loaded(state, {0.0, 0.054, skin});
    expect_all_pairs(state, loaded, skin, skin);
  }
}

// Most of the particles are beyond the domain on every side.
TYPED_TEST(NeighbourLists, ParticlesOutsideTheDomain) {
  const auto state = mixture(TestFixture::D, 7, 0.4, 6.0);
  const Loaded<TestFixture::D, Double> loaded(state, {0.04, 0.07, skin});
  expect_all_pairs(state, loaded, skin, skin);
}

// A domain with so many cells that they must be enlarged.
TYPED_TEST(NeighbourLists, VastDomain) {
  const auto state = mixture(TestFixture::D, 8, 0.4);
  const Loaded<TestFixture::D, Double> loaded(state, {-300.0, 300.0, skin});
  expect_all_pairs(state, loaded, skin, skin);
}

TYPED_TEST(NeighbourLists, IsValidUntilAParticleMovesHalfTheSkin) {
  constexpr int dimension = TestFixture::D;
  auto state = mixture(dimension, 9, 0.3, 2.0);
  Loaded<dimension, Double> loaded(state, {0.0, 0.036, skin});
  const auto place = loaded.places();
  std::mt19937 engine(3);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (std::size_t i = 0; i < place.size(); ++i) {
    Vector3 step(uniform(engine), uniform(engine), dimension == 3 ? uniform(engine) : 0.0);
    state.particles[i].position += 0.4999 * skin / step.norm() * step;
    loaded.particles.position[place[i]] =
        Vector<dimension, double>::from(state.particles[i].position);
  }
  EXPECT_FALSE(loaded.list.is_outdated(loaded.particles, 0.0));
  expect_all_pairs(state, loaded, 0.0, 2.0 * skin);
  // A particle in steady motion moves half the skin within the horizon.
  for (std::size_t k = 0; k < place.size(); ++k)
    loaded.particles.velocity[k] = Vector<dimension, double>::zero();
  auto fast = Vector<dimension, double>::zero();
  Vector<dimension, double> moved = loaded.particles.position[0];
  moved -= Vector<dimension, double>(loaded.particles.build_position[0]);
  fast = (1.0 / norm(moved)) * moved;  // 1 m/s, straight on
  loaded.particles.velocity[0] = fast;
  EXPECT_FALSE(loaded.list.is_outdated(loaded.particles, 0.00009 * skin));
  EXPECT_TRUE(loaded.list.is_outdated(loaded.particles, 0.00011 * skin));
  loaded.particles.position[0] =
      Vector<dimension, double>(loaded.particles.build_position[0]) + 0.5001 * skin * fast;
  EXPECT_TRUE(loaded.list.is_outdated(loaded.particles, 0.0));
  loaded.rebuild();
  EXPECT_FALSE(loaded.list.is_outdated(loaded.particles, 0.0));
}

// The list of an empty run is empty, and one particle is not its own neighbour.
TYPED_TEST(NeighbourLists, ZeroAndOneParticle) {
  ReferenceState state = mixture(TestFixture::D, 1, 0.0);
  state.particles.resize(1);
  state.particles[0].source = 0;
  EXPECT_EQ((Loaded<TestFixture::D, Double>(state, {}).list.pairs()), 0u);
  state.particles.clear();
  EXPECT_EQ((Loaded<TestFixture::D, Double>(state, {}).list.pairs()), 0u);
}

}  // namespace
}  // namespace kerf::test
