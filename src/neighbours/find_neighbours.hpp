// SPDX-License-Identifier: Apache-2.0
// Finds the neighbours of each particle in the rows of cells around it, several candidates at a
// time where lanes/ can, else one by one.
#pragma once

#include "lanes/walks.hpp"
#include "neighbours/level_grids.hpp"
#include "neighbours/pair_range.hpp"

namespace kerf {

template <int D, class P>
struct CellNumber {
  ParticleView<D, P> particles;
  LevelGrids<D> grids;
  Index* number;

  KERF_FUNCTION void operator()(Index i) const {
    number[i] = grids.number(particles.medium(i).level, particles.build_position[i]);
  }
};

// Where each cell begins in the order of particles, from their sorted cell numbers: particle i, or
// the end of them all, begins those after its predecessor's up to its own.
struct BeginCells {
  const Index* number;
  Index particles, cells;
  Index* begin;  // of cells + 1

  KERF_FUNCTION void operator()(Index i) const {
    const Index first = i == 0 ? 0 : number[i - 1] + 1;
    const Index last = i == particles ? cells : number[i];
    for (Index cell = first; cell <= last; ++cell) begin[cell] = i;
  }
};

// What the search of lanes/packed_search.hpp asks of particles.
template <int D>
struct SearchView {
  Search<D> search = nullptr;
  std::int32_t* place[D] = {};
  std::uint32_t* kind = nullptr;
  PlaceUnit<float> unit;
};
template <int D, class P, class Scheme>
struct PackForSearch {
  ParticleView<D, P> particles;
  SearchView<D> packed;

  KERF_FUNCTION void operator()(Index i) const {
    for (int a = 0; a < D; ++a)
      packed.place[a][i] = packed.unit.pack(particles.build_position[i][a]);
    packed.kind[i] = Scheme::kind(particles, i);
  }
};

// Walks the candidates of particle i; counts them, or writes them where `neighbour` is given.
template <int D, class P, class Scheme>
struct FindNeighbours {
  ParticleView<D, P> particles;
  LevelGrids<D> grids;
  const Index* cell_begin;
  double skin;
  bool splits;           // kin is listed first
  Index* count;          // out when neighbour is null
  Index *alike, *own;    // likewise
  SearchView<D> packed;  // null: one by one
  const Index* begin;
  Index* neighbour;

  KERF_FUNCTION void operator()(Index i) const {
    const auto& x = particles.build_position[i];
    Found found{};
    if (neighbour != nullptr) found = {0, alike[i], alike[i] + own[i]};
    if (Scheme::reach(particles, i, i) > 0.0) {  // else it sees nothing
      for (int level = 0; level < grids.levels; ++level)
        found = walk({i, 0, x, limit_of(i, level)}, level, found);
      if (particles.mirrors.faces != 0) found = walk_images(i, found);
    }
    if (neighbour != nullptr) return;
    count[i] = found.alike + found.own + found.others;
    alike[i] = found.alike;
    own[i] = found.own;
  }

 private:
  // Where the next one goes, in the list of i; when counting, how many there are so far.
  struct Found {
    Index alike, own, others;
  };
  // Particle i seen from where it is, or from its image x.
  struct Viewer {
    Index i;
    MirrorCode code;
    Vector<D, double> x;
    double limit;  // m, how far anything of a level can be seen
  };

  // An image of j is as far from i as j from that image of i.
  KERF_FUNCTION Found walk_images(Index i, Found found) const {
    const auto& mirrors = particles.mirrors;
    const auto& x = particles.build_position[i];
    for (int image = 1; image < MirrorPlanes<D>::images; ++image) {
      MirrorCode code;
      if (!mirrors.find_image(image, code)) continue;
      for (int level = 0; level < grids.levels; ++level) {
        const double limit = limit_of(i, level);
        if (mirrors.is_near(code, x, limit))
          found = walk({i, code, mirrors.image_place(code, x), limit}, level, found);
      }
    }
    return found;
  }
  KERF_FUNCTION double limit_of(Index i, int level) const {
    return grids.limit[particles.medium(i).level][level];
  }

  // The cells of a level that can be seen into.
  KERF_FUNCTION Found walk(const Viewer& from, int level, Found found) const {
    const auto& grid = grids.grid[level];
    const Index* const begin_of = cell_begin + grids.first[level];
    int low[D], high[D], row[D];
    for (int a = 0; a < D; ++a) {
      low[a] = grid.coordinate(from.x[a] - from.limit, a);
      high[a] = grid.coordinate(from.x[a] + from.limit, a);
      row[a] = low[a];
    }
    const bool at_once = packed.search != nullptr && from.code == 0;
    SearchRows rows;
    while (true) {
      row[0] = low[0];
      const Index first = grid.number(row);
      const Index last = first + static_cast<Index>(high[0] - low[0]);
      if (at_once)
        found = add_row(from, {begin_of[first], begin_of[last + 1]}, rows, found);
      else
        found = scan(from, begin_of[first], begin_of[last + 1], found);
      int a = 1;
      while (a < D && row[a] == high[a]) {
        row[a] = low[a];
        ++a;
      }
      if (a >= D) break;
      ++row[a];
    }
    return at_once ? search(from, rows, found) : found;
  }

  // Collects rows until they are many enough to look at.
  struct Places {
    Index begin, end;
  };
  KERF_FUNCTION Found add_row(const Viewer& from, Places row, SearchRows& rows, Found found) const {
    while (row.begin < row.end) {
      const Index room = SearchRows::most_candidates - rows.candidates;
      const Index taken = row.end - row.begin < room ? row.end - row.begin : room;
      rows.begin[rows.count] = row.begin;
      rows.end[rows.count++] = row.begin + taken;
      rows.candidates += taken;
      row.begin += taken;
      if (rows.count < SearchRows::most && rows.candidates < SearchRows::most_candidates) continue;
      found = search(from, rows, found);
      rows.count = 0;
      rows.candidates = 0;
    }
    return found;
  }

  // Those of its own kind come out of the search as they are; others are asked one by one.
  KERF_FUNCTION Found search(const Viewer& from, const SearchRows& rows, Found found) const {
    if (rows.count == 0) return found;
    const Index i = from.i;
    Index others[SearchRows::most_candidates + 16];
    SearchTask<D> task;
    for (int a = 0; a < D; ++a) {
      task.place[a] = packed.place[a];
      task.own_place[a] = packed.place[a][i];
    }
    task.kind = packed.kind;
    task.own = i;
    // Those of no kind are all others to one another.
    task.own_kind = packed.kind[i] != 0 ? packed.kind[i] : ~std::uint32_t(0);
    const double limit = from.limit / packed.unit.unit;
    const double reach = Scheme::reach(particles, i, i);
    const double same = (reach + skin) / packed.unit.unit;
    task.limit_squared = static_cast<float>(limit * limit);
    task.same_squared = static_cast<float>(same * same);
    task.rows = &rows;
    Index& section = section_of(splits ? Scheme::kinship(particles, i, i) : Kinship::other, found);
    task.same = neighbour != nullptr ? neighbour + begin[i] + section : nullptr;
    task.others = others;
    const auto seen = packed.search(task);
    section += seen.same;
    for (Index n = 0; n < seen.others; ++n) found = scan(from, others[n], others[n] + 1, found);
    return found;
  }
  KERF_FUNCTION static Index& section_of(Kinship kin, Found& found) {
    return kin == Kinship::alike ? found.alike : kin == Kinship::own ? found.own : found.others;
  }

  // Places `begin_at` to `end`, in the order of cells.
  KERF_FUNCTION Found scan(const Viewer& from, Index begin_at, Index end, Found found) const {
    const Index i = from.i;
    for (Index j = begin_at; j < end; ++j) {
      const auto r = from.x - particles.build_position[j];
      const double square = dot(r, r);
      if (square >= from.limit * from.limit) continue;
      if (j == i && from.code == 0) continue;
      const double reach = Scheme::reach(particles, i, j, from.code);
      if (reach == 0.0 || square >= (reach + skin) * (reach + skin)) continue;
      const Kinship kin =
          splits && from.code == 0 ? Scheme::kinship(particles, i, j) : Kinship::other;
      Index& place = section_of(kin, found);
      if (neighbour != nullptr) neighbour[begin[i] + place] = j | from.code;
      ++place;
    }
    return found;
  }
};

}  // namespace kerf
