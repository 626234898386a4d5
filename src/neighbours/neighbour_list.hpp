// SPDX-License-Identifier: Apache-2.0
// Verlet list with a skin: for each particle the others within reach + skin of where the list was
// built. It holds until a particle has moved half the skin. Each particle lists its own neighbours
// in a fixed order, so sums over them do not depend on the number of threads. Mirror images
// (core/mirror_planes.hpp) come after all particles.
#pragma once

#include "core/error.hpp"
#include "neighbours/level_grids.hpp"
#include "neighbours/pair_range.hpp"

namespace kerf {

struct NeighbourView {
  const Index* begin;      // begin[i] .. begin[i + 1] of `neighbour` are particle i's
  const Index* neighbour;  // places, with a mirror code in the highest bits
};

template <int D, class P>
struct CellNumber {
  ParticleView<D, P> particles;
  LevelGrids<D> grids;
  Index* number;

  KERF_FUNCTION void operator()(Index i) const {
    number[i] = grids.number(particles.medium(i).level, particles.build_position[i]);
  }
};

// Walks the candidates of particle i; counts them, or writes them where `neighbour` is given.
template <int D, class P, class Scheme>
struct FindNeighbours {
  ParticleView<D, P> particles;
  LevelGrids<D> grids;
  const Index* cell_begin;
  double skin;
  Index* count;  // out when neighbour is null
  const Index* begin;
  Index* neighbour;

  KERF_FUNCTION void operator()(Index i) const {
    const auto& x = particles.build_position[i];
    Index found = 0;
    for (int level = 0; level < grids.levels; ++level) found = walk({i, 0, x}, level, found);
    if (particles.mirrors.faces != 0) found = walk_images(i, found);
    if (neighbour == nullptr) count[i] = found;
  }

 private:
  // Particle i seen from where it is, or from its image x.
  struct Seen {
    Index i;
    MirrorCode code;
    Vector<D, double> x;
  };

  // An image of j is as far from i as j from that image of i.
  KERF_FUNCTION Index walk_images(Index i, Index found) const {
    const auto& mirrors = particles.mirrors;
    const auto& x = particles.build_position[i];
    for (int image = 1; image < MirrorPlanes<D>::images; ++image) {
      MirrorCode code;
      if (!mirrors.find_image(image, code)) continue;
      for (int level = 0; level < grids.levels; ++level)
        if (mirrors.is_near(code, x, limit_of(i, level)))
          found = walk({i, code, mirrors.image_place(code, x)}, level, found);
    }
    return found;
  }
  KERF_FUNCTION double limit_of(Index i, int level) const {
    return grids.limit[particles.medium(i).level][level];
  }

  // The cells of a level that can be seen into.
  KERF_FUNCTION Index walk(const Seen& from, int level, Index found) const {
    const auto& grid = grids.grid[level];
    const Index* const begin_of = cell_begin + grids.first[level];
    const double limit = limit_of(from.i, level);
    int low[D], high[D], row[D];
    for (int a = 0; a < D; ++a) {
      low[a] = grid.coordinate(from.x[a] - limit, a);
      high[a] = grid.coordinate(from.x[a] + limit, a);
      row[a] = low[a];
    }
    while (true) {
      row[0] = low[0];
      const Index first = grid.number(row);
      const Index last = first + static_cast<Index>(high[0] - low[0]);
      found = scan(from, begin_of[first], begin_of[last + 1], found);
      int a = 1;
      while (a < D && row[a] == high[a]) {
        row[a] = low[a];
        ++a;
      }
      if (a >= D) break;
      ++row[a];
    }
    return found;
  }

  // Places `begin_at` to `end`, in the order of cells.
  KERF_FUNCTION Index scan(const Seen& from, Index begin_at, Index end, Index found) const {
    const Index i = from.i;
    for (Index j = begin_at; j < end; ++j) {
      if (j == i && from.code == 0) continue;
      const double reach = Scheme::reach(particles, i, j, from.code);
      if (reach == 0.0) continue;
      const auto r = from.x - particles.build_position[j];
      const double limit = reach + skin;
      if (dot(r, r) >= limit * limit) continue;
      if (neighbour != nullptr) neighbour[begin[i] + found] = j | from.code;
      ++found;
    }
    return found;
  }
};

template <int D, class P>
struct HasMovedFar {
  ParticleView<D, P> particles;
  double limit_square;  // m^2
  double horizon;       // s, looked ahead

  KERF_FUNCTION bool operator()(Index i) const {
    auto moved = particles.position[i] - particles.build_position[i];
    moved += horizon * Vector<D, double>::from(particles.velocity[i]);
    return !(dot(moved, moved) <= limit_square);
  }
};

template <int D, class P, class Scheme>
class NeighbourList {
 public:
  NeighbourList() = default;
  // `longest`: the longest pair reach there is; `skin` in m.
  NeighbourList(const Vector<D, double>& minimum, const Vector<D, double>& maximum, double longest,
                double skin)
      : NeighbourList(minimum, maximum, LevelReach::one(longest), skin) {}
  NeighbourList(const Vector<D, double>& minimum, const Vector<D, double>& maximum,
                const LevelReach& reach, double skin)
      : grids_(LevelGrids<D>::covering(minimum, maximum, reach, skin)), skin_(skin) {}

  // Cell numbers of the build positions, the sort key of the particles.
  const Array<Index>& cell_numbers(Particles<D, P>& particles) {
    key_.resize(particles.size());
    for_each_index(particles.size(), CellNumber<D, P>{particles.view(), grids_, pointer(key_)});
    return key_;
  }

  // Particles must already be in the order of their cell numbers.
  void build(Particles<D, P>& particles) {
    const Index n = particles.size();
    require(particles.mirrors.faces == 0 || n <= MirrorPlanes<D>::most_particles,
            "as many particles as have places beside the codes of mirrors");
    cell_numbers(particles);
    const Index cells = grids_.count();
    cell_begin_.resize(cells + 1);
    thrust::lower_bound(thrust::device, key_.begin(), key_.end(),
                        thrust::counting_iterator<Index>(0),
                        thrust::counting_iterator<Index>(cells + 1), cell_begin_.begin());
    begin_.resize(n + 1);
    FindNeighbours<D, P, Scheme> find{
        particles.view(), grids_, pointer(cell_begin_), skin_, pointer(begin_),
        pointer(begin_),  nullptr};
    for_each_index(n, find);
    thrust::fill_n(begin_.begin() + n, 1, Index(0));
    thrust::exclusive_scan(thrust::device, begin_.begin(), begin_.end(), begin_.begin());
    pairs_ = begin_[n];
    if (neighbour_.size() < pairs_) neighbour_.resize(pairs_ + pairs_ / 8);
    find.neighbour = pointer(neighbour_);
    if (n > 0) for_each_index(n, find);
  }

  // Will a particle have moved more than half the skin within the next `horizon` seconds?
  bool is_outdated(Particles<D, P>& particles, double horizon) const {
    const double half = 0.5 * skin_;
    return reduce_unordered(particles.size(),
                            HasMovedFar<D, P>{particles.view(), half * half, horizon}, false,
                            Either{});
  }

  NeighbourView view() const { return {pointer(begin_), pointer(neighbour_)}; }
  Index pairs() const { return pairs_; }  // list entries, each pair twice
  std::size_t bytes() const {
    return sizeof(Index) * (neighbour_.size() + begin_.size() + cell_begin_.size() + key_.size());
  }

 private:
  LevelGrids<D> grids_{};
  double skin_ = 0.0;
  Index pairs_ = 0;
  Array<Index> key_, cell_begin_, begin_, neighbour_;
};

}  // namespace kerf
