// SPDX-License-Identifier: Apache-2.0
// A list that is refreshed where particles have moved, come or become fluid against one that is
// built anew for the same build positions, and against all pairs.
#include <gtest/gtest.h>

#include <numeric>
#include <random>
#include <set>

#include "support/loaded.hpp"
#include "support/mirrored.hpp"
#include "support/mixture.hpp"

namespace kerf::test {
namespace {

constexpr double skin_of_list = 5e-4, domain = 0.06;  // m

using Lists = std::vector<std::vector<Index>>;
Lists lists_of(const NeighbourView& view, Index count) {
  Lists lists;
  for (Index i = 0; i < count; ++i)
    lists.emplace_back(view.neighbour + view.begin[i], view.neighbour + view.end[i]);
  return lists;
}

template <int D>
class Refreshed {
 public:
  using List = NeighbourList<D, Double, ContactPairs>;

  Refreshed(unsigned seed, const std::string& faces, bool by_class)
      : engine(seed), splits(by_class), loaded(spread_mixture(D, seed, domain), choice(by_class)) {
    loaded.particles.mirrors = planes_of<D>(faces, domain);
    loaded.rebuild();
  }

  // Moves the particles within a distance of a point, m, each by up to `way` in its own direction.
  void move_around(const Vector<D, double>& centre, double radius, double way) {
    for (Index i = 0; i < size(); ++i) {
      Vector<D, double> x = loaded.particles.position[i];
      if (norm(x - centre) > radius) continue;
      for (int a = 0; a < D; ++a) x[a] += way * uniform() / std::sqrt(double(D));
      loaded.particles.position[i] = x;
    }
    loaded.list.note({way, 0.0});
  }
  Vector<D, double> random_point() {
    Vector<D, double> x;
    for (int a = 0; a < D; ++a) x[a] = domain * (0.5 + 0.45 * uniform());
    return x;
  }
  // Appends a copy of the first particles near a point.
  void append(const Vector<D, double>& centre, Index count) {
    const Index first = size();
    std::vector<Index> order(first + count);
    std::iota(order.begin(), order.begin() + first, Index(0));
    std::fill(order.begin() + first, order.end(), Index(0));
    Array<Index> on_device;
    to_device(order, on_device);
    gather_particles(loaded.particles, on_device);
    for (Index i = first; i < size(); ++i) {
      Vector<D, double> x = centre;
      for (int a = 0; a < D; ++a) x[a] += 2e-3 * uniform();
      loaded.particles.position[i] = loaded.particles.build_position[i] = x;
    }
  }
  void fracture(int every) {
    for (Index i = 0; i < size(); ++i) {
      const bool solid = loaded.particles.view().medium(i).phase == Phase::solid;
      if (solid && engine() % unsigned(every) == 0) loaded.particles.fractured[i] = 1;
    }
  }

  void expect_that_of_a_new_list() {
    auto fresh = empty();
    fresh.build(loaded.particles);
    EXPECT_EQ(lists_of(loaded.list.view(), size()), lists_of(fresh.view(), size()));
    EXPECT_EQ(loaded.list.pairs(), fresh.pairs());
    const auto refreshed = loaded.list.view(), built = fresh.view();
    for (Index i = 0; i < size(); ++i) {
      ASSERT_EQ(refreshed.same_fluid[i], built.same_fluid[i]);
      ASSERT_EQ(refreshed.unlike[i], built.unlike[i]);
      ASSERT_EQ(refreshed.same_body[i], built.same_body[i]);
      ASSERT_EQ(refreshed.images[i], built.images[i]);
    }
  }
  // At the build positions, without images.
  void expect_all_pairs() {
    const auto view = loaded.particles.view();
    const auto lists = lists_of(loaded.list.view(), size());
    for (Index i = 0; i < size(); ++i) {
      const std::set<Index> listed(lists[i].begin(), lists[i].end());
      for (Index j = 0; j < size(); ++j) {
        const double reach = i == j ? 0.0 : ContactPairs::reach(view, i, j);
        const double distance = norm(view.build_position[i] - view.build_position[j]);
        const double limit = reach + skin_of_list;
        if (reach > 0.0 && std::abs(distance / limit - 1.0) < 1e-6) continue;
        ASSERT_EQ(listed.count(j) == 1, reach > 0.0 && distance < limit) << i << ' ' << j;
      }
    }
  }

  std::vector<std::vector<Index>> lists() const {
    const auto view = loaded.list.view();
    std::vector<std::vector<Index>> all;
    for (Index i = 0; i < size(); ++i)
      all.emplace_back(view.neighbour + view.begin[i], view.neighbour + view.end[i]);
    return all;
  }
  Index size() const { return loaded.particles.size(); }

  std::mt19937 engine;
  bool splits;
  Loaded<D, Double, ContactPairs> loaded;

 private:
  static ListChoice choice(bool by_class) { return {0.0, domain, skin_of_list, by_class}; }
  double uniform() { return std::uniform_real_distribution<double>(-1.0, 1.0)(engine); }
  List empty() {
    auto minimum = Vector<D, double>::zero(), maximum = Vector<D, double>::filled(domain);
    double longest = 0.0;
    for (const auto& medium : to_host(loaded.particles.media))
      longest = std::max(longest, double(medium.smoothing_length));
    List list(minimum, maximum, 2.0 * longest, skin_of_list);
    if (splits) list.sort_neighbours_by_class();
    return list;
  }
};

template <class Dimension>
class RefreshedLists : public testing::Test {
 protected:
  static constexpr int D = Dimension::value;
};
using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(RefreshedLists, Dimensions);

// Particles move by more than the skin in one part after the other, so that their cells change.
TYPED_TEST(RefreshedLists, AreThoseOfANewListAfterMotion) {
  for (const bool splits : {false, true}) {
    Refreshed<TestFixture::D> run(3, "", splits);
    int refreshed = 0;
    for (int round = 0; round < 30; ++round) {
      run.move_around(run.random_point(), 0.2 * domain, 0.3 * skin_of_list);
      run.move_around(run.random_point(), 0.1 * domain, 2.0 * skin_of_list);
      ASSERT_TRUE(run.loaded.list.is_outdated(run.loaded.particles, 0.0));
      if (run.loaded.list.refresh(run.loaded.particles, 0.0, true))
        ++refreshed;
      else
        run.loaded.rebuild();
      run.expect_that_of_a_new_list();
      ASSERT_FALSE(run.loaded.list.is_outdated(run.loaded.particles, 0.0));
    }
    EXPECT_GT(refreshed, 20);
    run.expect_all_pairs();
  }
}

TYPED_TEST(RefreshedLists, AreThoseOfANewListBesidePlanes) {
  Refreshed<TestFixture::D> run(4, "x- y+", true);
  for (int round = 0; round < 10; ++round) {
    auto centre = run.random_point();
    centre[round % TestFixture::D] = round % 4 < 2 ? 0.05 * domain : 0.95 * domain;
    run.move_around(centre, 0.15 * domain, 2.0 * skin_of_list);
    if (!run.loaded.list.is_outdated(run.loaded.particles, 0.0)) continue;
    ASSERT_TRUE(run.loaded.list.refresh(run.loaded.particles, 0.0, true)) << round;
    run.expect_that_of_a_new_list();
  }
}

// Lists become ever longer, so that their memory has to be compacted and to grow.
TYPED_TEST(RefreshedLists, AreThoseOfANewListWithNewcomers) {
  Refreshed<TestFixture::D> run(5, "", true);
  for (int round = 0; round < 25; ++round) {
    const auto before = run.lists();
    run.append(run.random_point(), 20);
    run.move_around(run.random_point(), 0.1 * domain, 1e-2 * skin_of_list);
    ASSERT_TRUE(run.loaded.list.refresh(run.loaded.particles, 0.0, false)) << round;
    // What others keep of the neighbours of a particle stays valid unless its list is marked.
    const auto after = run.lists();
    for (std::size_t i = 0; i < before.size(); ++i) {
      if (run.loaded.list.listed_anew()[i] == 0) {
        ASSERT_EQ(after[i], before[i]) << round;
      }
    }
    run.expect_that_of_a_new_list();
  }
  run.expect_all_pairs();
}

TYPED_TEST(RefreshedLists, AreThoseOfANewListWithNewFluid) {
  Refreshed<TestFixture::D> run(6, "y-", true);
  for (const int every : {200, 20, 3, 1}) {
    const auto before = run.loaded.list.pairs();
    run.fracture(every);
    run.loaded.list.refresh_fractured(run.loaded.particles);
    EXPECT_GT(run.loaded.list.pairs(), before);  // fluid reaches further
    run.expect_that_of_a_new_list();
  }
}

// Only the lists near what has moved are found again.
TYPED_TEST(RefreshedLists, AreKeptElsewhere) {
  Refreshed<TestFixture::D> run(7, "", true);
  const auto corner = Vector<TestFixture::D, double>::filled(0.1 * domain);
  run.move_around(corner, 0.1 * domain, 2.0 * skin_of_list);
  ASSERT_TRUE(run.loaded.list.is_outdated(run.loaded.particles, 0.0));
  ASSERT_TRUE(run.loaded.list.refresh(run.loaded.particles, 0.0, true));
  const auto* listed_anew = run.loaded.list.listed_anew();
  if (!simd_exists) GTEST_SKIP() << "a list in passes is found as a whole";
  EXPECT_LT(std::count(listed_anew, listed_anew + run.size(), 1), 0.6 * run.size());
}

TYPED_TEST(RefreshedLists, AreLeftToASortWhereMostHaveMoved) {
  Refreshed<TestFixture::D> run(8, "", true);
  run.move_around(Vector<TestFixture::D, double>::filled(0.5 * domain), domain, 2.0 * skin_of_list);
  ASSERT_TRUE(run.loaded.list.is_outdated(run.loaded.particles, 0.0));
  EXPECT_FALSE(run.loaded.list.refresh(run.loaded.particles, 0.0, true));
}

}  // namespace
}  // namespace kerf::test
