// SPDX-License-Identifier: Apache-2.0
// BondFinder finds the bonds of the reference configuration, once, on the host: a grid of cells for
// each level of resolution, so that a small particle does not test those within reach of a large
// one (neighbours/level_grids.hpp does the same for the current positions); then each particle's
// list in ascending order, so that every sum has a fixed order; mirror images, whose entries have
// higher bits set, come last.
#pragma once

#include <algorithm>
#include <vector>

#include "core/mirror_planes.hpp"
#include "geometry/solid_region.hpp"
#include "neighbours/level_grids.hpp"
#include "neighbours/pair_range.hpp"
#include "solid/bond_weight.hpp"

namespace kerf {

template <int D>
struct SolidLayout {
  std::vector<Medium<double>> media;
  std::vector<Vector<D, double>> reference;  // X, m
  std::vector<std::uint16_t> medium_index;   // per particle
  // Per medium, the body of which it is a level of resolution; empty: there are no levels.
  std::vector<std::uint16_t> body;
  std::vector<BondRegion> regions;  // per medium; empty: no body has voids
  MirrorPlanes<D> mirrors{};
};

// Lists in compressed rows: the bonds of i are neighbour[begin[i]] .. neighbour[begin[i + 1] - 1].
struct BondLists {
  std::vector<Index> begin, neighbour;
};

// The scale of the bond weights between any two of these media.
template <int D>
class BondScales {
 public:
  explicit BondScales(const std::vector<Medium<double>>& media) : media_(media.size()) {
    for (const auto& a : media)
      for (const auto& b : media) scales_.push_back(BondScale<double>::of<D>(a, b));
  }
  const BondScale<double>& operator()(std::uint16_t a, std::uint16_t b) const {
    return scales_[a * media_ + b];
  }

 private:
  std::size_t media_;
  std::vector<BondScale<double>> scales_;
};

template <int D>
class BondFinder {
 public:
  explicit BondFinder(const SolidLayout<D>& layout) : layout_(layout), scales_(layout.media) {
    find_reach();
    auto low = layout.reference.front(), high = low;
    for (const auto& x : layout.reference)
      for (int a = 0; a < D; ++a) {
        low[a] = std::min(low[a], x[a]);
        high[a] = std::max(high[a], x[a]);
      }
    std::vector<std::vector<Index>> members(cells_.size());
    for (Index i = 0; i < static_cast<Index>(layout.reference.size()); ++i)
      members[level(i)].push_back(i);
    for (std::size_t a = 0; a < cells_.size(); ++a)
      if (!members[a].empty()) sort_into_cells(members[a], low, high, a);
  }

  BondLists find() const {
    BondLists lists;
    lists.begin.push_back(0);
    for (Index i = 0; i < static_cast<Index>(layout_.reference.size()); ++i) {
      append_images(i, lists.neighbour);
      std::sort(lists.neighbour.begin() + lists.begin.back(), lists.neighbour.end());
      lists.begin.push_back(static_cast<Index>(lists.neighbour.size()));
    }
    return lists;
  }

 private:
  // The particles of one level in the cells of a grid.
  struct LevelCells {
    Grid<D> grid{};
    std::vector<Index> begin, member;  // particles of cell c: member[begin[c]] ..
  };

  std::size_t level(Index i) const { return layout_.media[layout_.medium_index[i]].level; }

  // Finds the longest bond between any two levels that have particles.
  void find_reach() {
    std::vector<std::uint8_t> is_used(layout_.media.size());
    for (const auto medium : layout_.medium_index) is_used[medium] = 1;
    std::vector<Medium<double>> used;
    for (std::size_t m = 0; m < is_used.size(); ++m)
      if (is_used[m] != 0) used.push_back(layout_.media[m]);
    reach_ = LevelReach::of<D, ContactPairs>(used);
    cells_.resize(static_cast<std::size_t>(reach_.levels));
    // A little longer, so that rounding never leaves out a bond.
    constexpr double beyond = 1.0 + 1e-9;
    for (auto& row : reach_.longest)
      for (double& longest : row) {
        longest *= beyond;
        longest_ = std::max(longest_, longest);
      }
  }

  void sort_into_cells(const std::vector<Index>& members, const Vector<D, double>& low,
                       const Vector<D, double>& high, std::size_t a) {
    LevelCells& cells = cells_[a];
    const auto n = static_cast<Index>(members.size());
    // Cells half as wide as the longest bond: fewer candidates are tested in vain.
    cells.grid = Grid<D>::covering(low, high, 0.5 * reach_.longest[a][a], 4.0 * n + 64.0);
    cells.begin.assign(cells.grid.count() + 1, 0);
    for (const Index i : members) ++cells.begin[cells.grid.number(layout_.reference[i]) + 1];
    for (Index c = 0; c < cells.grid.count(); ++c) cells.begin[c + 1] += cells.begin[c];
    std::vector<Index> next(cells.begin.begin(), cells.begin.end() - 1);
    cells.member.resize(n);
    for (const Index i : members) cells.member[next[cells.grid.number(layout_.reference[i])]++] = i;
  }

  // Appends bonds to particles, and to mirror images where those are part of the same piece.
  void append_images(Index i, std::vector<Index>& neighbours) const {
    const auto& x = layout_.reference[i];
    const MirrorCode joined = layout_.media[layout_.medium_index[i]].joined_mirrors;
    for (int image = 0; image < MirrorPlanes<D>::images; ++image) {
      MirrorCode code;
      if (!layout_.mirrors.find_image(image, code) || (code & ~joined) != 0) continue;
      if (layout_.mirrors.is_near(code, x, longest_))
        append_bonds(i, code, layout_.mirrors.image_position(code, x), neighbours);
    }
  }

  // Appends the bonds in the cells around x, the position of i or of its image.
  void append_bonds(Index i, MirrorCode code, const Vector<D, double>& x,
                    std::vector<Index>& neighbours) const {
    for (std::size_t b = 0; b < cells_.size(); ++b) {
      const LevelCells& cells = cells_[b];
      if (cells.member.empty()) continue;
      const double limit = reach_.longest[level(i)][b];
      const auto reach = Vector<D, double>::filled(limit);
      const auto append = [&](Index begin, Index end) {
        for (Index m = begin; m < end; ++m)
          if (is_bond(i, cells.member[m], code, limit))
            neighbours.push_back(cells.member[m] | code);
      };
      cells.grid.for_each_row(x - reach, x + reach,
                              ParticlesOfRow<decltype(append)>{cells.begin.data(), append});
    }
  }

  bool is_bond(Index i, Index j, MirrorCode code, double limit) const {
    if (i == j && code == 0) return false;
    const auto apart = layout_.mirrors.separation(code, layout_.reference[i], layout_.reference[j]);
    if (dot(apart, apart) >= limit * limit) return false;
    return scales_(layout_.medium_index[i], layout_.medium_index[j]).weight(norm(apart)) > 0.0;
  }

  const SolidLayout<D>& layout_;
  BondScales<D> scales_;
  LevelReach reach_;               // of the bonds between two levels
  double longest_ = 0.0;           // m, of all
  std::vector<LevelCells> cells_;  // per level
};

}  // namespace kerf
