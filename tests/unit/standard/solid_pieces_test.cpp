// SPDX-License-Identifier: Apache-2.0
// Pieces of solids with random damage, against a search over all pairs of particles.
#include "standard/solid_pieces.hpp"

#include <gtest/gtest.h>

#include <set>

#include "standard/solid_show.hpp"
#include "support/mirrored.hpp"
#include "support/solid_blocks.hpp"

namespace kerf {
namespace {

using namespace test;

// The pairs of a solid that are bonded, and what is broken of it.
template <int D>
struct Graph {
  std::vector<std::set<Index>> bonds;  // of each particle, to particles after it
};

template <class K>
class SolidPiecesOf : public testing::Test {
 protected:
  static constexpr int dimension = K::D;
  using P = typename K::P;
  using Solid = TotalLagrangian<dimension, P>;

  static SolidLayout<dimension> layout(unsigned seed) {
    auto made = block<dimension>({{12, 9, 6}, 1e-3, 0.3, seed});
    made.media[0].failure_strain = 0.5;
    made.media[0].softening_strain = 0.1;
    made.media[0].criterion = BondCriterion::crack_band;
    return made;
  }
  // Breaks both ends of the bonds that `choose(i, j)` names, i < j.
  template <class Choose>
  static Graph<dimension> break_bonds(Solid& solid, const Choose& choose) {
    Graph<dimension> graph;
    graph.bonds.resize(solid.size());
    const auto view = solid.view();
    std::set<std::pair<Index, Index>> broken;
    for (Index i = 0; i < solid.size(); ++i)
      for (Index k = view.bonds.first(i); k < view.bonds.last(i); ++k) {
        const Index j = view.bonds.end(i, k);
        // A corner that jitter leaves with too few neighbours is detached from the start.
        if (j < i || !view.is_intact(i, k)) continue;
        if (choose(i, j))
          broken.insert({i, j});
        else
          graph.bonds[i].insert(j);
      }
    for (Index i = 0; i < solid.size(); ++i)
      for (Index k = view.bonds.first(i); k < view.bonds.last(i); ++k) {
        const Index j = view.bonds.end(i, k);
        if (broken.count({std::min(i, j), std::max(i, j)}) > 0) view.break_bond(i, k);
      }
    return graph;
  }
  // Gives both the lower label; returns whether that changed one.
  static bool join(std::vector<Index>& label, Index i, Index j) {
    if (label[i] == label[j]) return false;
    label[i] = label[j] = std::min(label[i], label[j]);
    return true;
  }
  // Spreads the lowest number over all chains of pairs.
  template <class Counts>
  static std::vector<Index> spread(const Graph<dimension>& graph, const Counts& counts) {
    std::vector<Index> label(graph.bonds.size());
    for (Index i = 0; i < label.size(); ++i) label[i] = i;
    for (bool changed = true; changed;) {
      changed = false;
      for (Index i = 0; i < label.size(); ++i)
        for (const Index j : graph.bonds[i])
          changed = (counts(i, j) && join(label, i, j)) || changed;
    }
    return label;
  }
  static SolidPieces pieces_of(const Solid& solid, const std::vector<std::uint16_t>& body) {
    const SolidOnHost<dimension, P> host(solid.fields(), std::vector<std::uint16_t>(8, 0));
    return find_solid_pieces<dimension>(host, body);
  }
};
TYPED_TEST_SUITE(SolidPiecesOf, TwoKinds);

// From few to nearly all bonds are broken, so that there are from one to very many pieces.
TYPED_TEST(SolidPiecesOf, EqualThoseOfASearchOverAllPairs) {
  constexpr int D = TypeParam::D;
  for (unsigned seed = 1; seed <= 12; ++seed) {
    TotalLagrangian<D, typename TypeParam::P> solid(this->layout(seed));
    std::mt19937 engine(seed);
    const double share = 0.5 + 0.04 * seed;
    std::bernoulli_distribution breaks(D == 3 ? 0.9 + 0.1 * (share - 0.5) / 0.5 : share);
    const auto graph = this->break_bonds(solid, [&](Index, Index) { return breaks(engine); });
    std::vector<std::uint16_t> body(solid.size());
    for (std::uint16_t& one : body) one = static_cast<std::uint16_t>(engine() % 2);
    const SolidPieces pieces = this->pieces_of(solid, body);
    EXPECT_EQ(pieces.piece, this->spread(graph, [](Index, Index) { return true; })) << seed;
    EXPECT_EQ(pieces.body_piece, this->spread(graph, [&](Index i, Index j) {
      return body[i] == body[j];
    })) << seed;
  }
}

// The damage of a body is the share of its own bonds that are broken, whatever joins it to others.
TYPED_TEST(SolidPiecesOf, ShowTheDamageWithinABody) {
  constexpr int D = TypeParam::D;
  for (unsigned seed = 1; seed <= 4; ++seed) {
    auto layout = this->layout(seed);
    layout.media.push_back(layout.media[0]);
    const auto body = [&](Index i) { return layout.reference[i][1] < 4e-3 ? 0 : 1; };
    for (Index i = 0; i < layout.reference.size(); ++i)
      layout.medium_index[i] = static_cast<std::uint16_t>(body(i));
    TotalLagrangian<D, typename TypeParam::P> solid(layout);
    std::mt19937 engine(seed);
    std::bernoulli_distribution breaks(0.3);
    const auto graph = this->break_bonds(
        solid, [&](Index i, Index j) { return body(i) != body(j) || breaks(engine); });
    const auto view = solid.view();
    const auto is_broken = [&](Index i, Index j) {
      return graph.bonds[std::min(i, j)].count(std::max(i, j)) == 0;
    };
    // The bonds of a particle within its body, and how many of them are broken.
    const auto count = [&](Index i) {
      std::pair<int, int> bonds{0, 0};
      for (Index k = view.bonds.first(i); k < view.bonds.last(i); ++k)
        if (const Index j = view.bonds.end(i, k); body(i) == body(j)) {
          ++bonds.first;
          bonds.second += is_broken(i, j) ? 1 : 0;
        }
      return bonds;
    };
    for (Index i = 0; i < solid.size(); ++i) view.has_broken_bonds[i] = 1;
    const SolidOnHost<D, typename TypeParam::P> host(solid.fields(), {5, 7});
    EXPECT_TRUE(host.has_joints());
    for (Index i = 0; i < solid.size(); ++i) {
      const auto [all, broken] = count(i);
      const double share = all > 0 ? double(broken) / all : host.damage(i);
      EXPECT_NEAR(host.body_damage(i), share, 1e-6) << seed << ' ' << i;
    }
    const SolidOnHost<D, typename TypeParam::P> one_body(solid.fields(), {5, 5});
    EXPECT_FALSE(one_body.has_joints());
  }
}

// A bond counts until softening has left no tension to both of its ends.
TYPED_TEST(SolidPiecesOf, CountBondsThatStillTransmitTension) {
  constexpr int D = TypeParam::D;
  for (unsigned seed = 1; seed <= 6; ++seed) {
    TotalLagrangian<D, typename TypeParam::P> solid(this->layout(seed));
    std::mt19937 engine(seed);
    std::bernoulli_distribution breaks(D == 3 ? 0.95 : 0.7), ends(0.5);
    const auto graph = this->break_bonds(solid, [&](Index, Index) { return breaks(engine); });
    std::vector<bool> softened(solid.size());
    for (Index i = 0; i < solid.size(); ++i) {
      softened[i] = ends(engine);
      // Just before the end of softening a particle still bears a little.
      solid.view().current_strain[i] =
          static_cast<typename TypeParam::Real>(softened[i] ? 0.5 : 0.499);
    }
    const SolidPieces pieces = this->pieces_of(solid, std::vector<std::uint16_t>(solid.size(), 0));
    EXPECT_EQ(pieces.piece, this->spread(graph, [&](Index i, Index j) {
      return !softened[i] || !softened[j];
    })) << seed;
  }
}

// Half of a block beside a plane is joined to its image until all bonds across the plane break.
TYPED_TEST(SolidPiecesOf, NameThePlanesThatTheyCross) {
  constexpr int D = TypeParam::D;
  auto layout = this->layout(3);
  layout.mirrors = planes_of<D>("x-", 1.0);
  layout.media[0].joined_mirrors = layout.mirrors.faces;
  TotalLagrangian<D, typename TypeParam::P> solid(layout);
  const std::vector<std::uint16_t> body(solid.size(), 0);
  const SolidPieces whole = this->pieces_of(solid, body);
  for (Index i = 0; i < solid.size(); ++i)
    EXPECT_EQ(whole.planes[i], solid.fields().detached[i] ? 0u : 1u);
  // A crack parallel to the plane leaves a strip at it.
  const double crack = 4e-3;
  solid.cut([&](const auto& x, const auto& y) { return (x[0] < crack) != (y[0] < crack); });
  const SolidPieces parted = this->pieces_of(solid, body);
  for (Index i = 0; i < solid.size(); ++i)
    EXPECT_EQ(parted.planes[i],
              !solid.fields().detached[i] && layout.reference[i][0] < crack ? 1u : 0u);
  solid.cut([&](const auto& x, const auto& y) { return (x[0] < 0.0) != (y[0] < 0.0); });
  for (const std::uint8_t planes : this->pieces_of(solid, body).planes) EXPECT_EQ(planes, 0u);
}

}  // namespace
}  // namespace kerf
