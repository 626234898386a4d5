// SPDX-License-Identifier: Apache-2.0
// FindNeighbours finds the neighbours of each particle in the rows of cells around it, by the SIMD
// search where there is one, else one candidate after another.
#pragma once

#include "neighbours/cell_order.hpp"
#include "neighbours/neighbour_sections.hpp"
#include "neighbours/search_memory.hpp"
#include "neighbours/search_view.hpp"

namespace kerf {

// Tests the candidates of particle i and puts its neighbours into sections
// (neighbours/neighbour_sections.hpp).
template <int D, class P, class Scheme>
struct FindNeighbours {
  ParticleView<D, P> particles;
  LevelGrids<D> grids;
  CellOrder order;
  double skin;
  bool splits;           // neighbours are listed class by class
  SearchView<D> packed;  // without a search: one by one

  using Viewer = ListViewer<D>;

  // `memory`: null, or that of earlier calls with the same particles.
  template <class Sections>
  KERF_FUNCTION void operator()(Index i, Sections& found, SearchMemory* memory = nullptr) const {
    if (!(Scheme::reach(particles, i, i) > 0.0)) return;  // it has no neighbours
    const auto& x = particles.build_position[i];
    for (int level = 0; level < grids.levels; ++level) {
      const Viewer from{i, 0, x, limit_of(i, level)};
      if constexpr (simd_exists) {
        if (memory != nullptr && packed.search != nullptr) {
          search_level(from, level, *memory, found);
          continue;
        }
      } else if (packed.kind != nullptr) {
        scan_packed_level(from, level, found);
        continue;
      }
      scan_level(from, level, found);
    }
    if (particles.mirrors.faces != 0) find_among_images(i, memory != nullptr, found);
  }

  // Tests the candidates of a range one by one, in their order.
  template <class Sections>
  KERF_FUNCTION void scan(const Viewer& from, PlaceRange range, Sections& found) const {
    const Index i = from.i;
    for (Index place = range.begin; place < range.end; ++place) {
      const Index j = order.particle(place);
      const auto& x = particles.build_position[j];
      const double square = squared_distance<D, double>(DifferenceTo<D>{from.x, x});
      if (square >= from.limit * from.limit) continue;
      if (j == i && from.code == 0) continue;
      // A solid particle may have crossed the plane: then one that sees its image is seen by it.
      if (from.code != 0 && !particles.mirrors.is_near(from.code, x, from.limit)) continue;
      const double reach = Scheme::reach(particles, i, j, from.code);
      if (reach == 0.0 || square >= (reach + skin) * (reach + skin)) continue;
      PairClass pair_class = PairClass::other;
      if (splits)
        pair_class = from.code == 0 ? Scheme::pair_class(particles, i, j)
                                    : Scheme::image_class(particles, i, j, from.code);
      if (Index* const next = found.room(pair_class, 1)) *next = j | from.code;
      found.took(pair_class, 1);
    }
  }

 private:
  // The image of j is as far from i as j is from the image of i.
  template <class Sections>
  KERF_FUNCTION void find_among_images(Index i, bool may_search, Sections& found) const {
    const auto& mirrors = particles.mirrors;
    const auto& x = particles.build_position[i];
    double longest = 0.0;
    for (int level = 0; level < grids.levels; ++level)
      longest = longest > limit_of(i, level) ? longest : limit_of(i, level);
    if (!mirrors.is_near_any(x, longest)) return;
    for (int image = 1; image < MirrorPlanes<D>::images; ++image) {
      MirrorCode code;
      if (!mirrors.find_image(image, code)) continue;
      for (int level = 0; level < grids.levels; ++level) {
        const double limit = limit_of(i, level);
        if (!mirrors.is_near(code, x, limit)) continue;
        find_images({i, code, mirrors.image_position(code, x), limit}, level, may_search, found);
      }
    }
  }
  template <class Sections>
  KERF_FUNCTION void find_images(const Viewer& from, int level, bool may_search,
                                 Sections& found) const {
    if constexpr (simd_exists)
      if (may_search && packed.search != nullptr) return search_images(from, level, found);
    scan_level(from, level, found);
  }
  KERF_FUNCTION double limit_of(Index i, int level) const {
    return grids.limit[particles.medium(i).level][level];
  }

  // Calls take(begin, end) for each row of the cells of a level that meet the box.
  template <class Take>
  KERF_FUNCTION void for_each_row(const Vector<D, double>& minimum,
                                  const Vector<D, double>& maximum, int level,
                                  const Take& take) const {
    grids.grid[level].for_each_row(minimum, maximum,
                                   ParticlesOfRow<Take>{order.begin + grids.first[level], take});
  }

  // Tests the candidates of a level one by one.
  template <class Sections>
  struct ScanRow {
    const FindNeighbours& find;
    const Viewer& from;
    Sections& found;
    KERF_FUNCTION void operator()(Index begin, Index end) const {
      find.scan(from, {begin, end}, found);
    }
  };
  template <class Sections>
  KERF_FUNCTION void scan_level(const Viewer& from, int level, Sections& found) const {
    const auto reach = Vector<D, double>::filled(from.limit);
    for_each_row(from.x - reach, from.x + reach, level, ScanRow<Sections>{*this, from, found});
  }

  template <class Sections>
  KERF_FUNCTION void scan_packed_level(const Viewer& from, int level, Sections& found) const {
    const auto reach = Vector<D, double>::filled(from.limit);
    const double limit = (1.0 + 1e-6) * from.limit / packed.unit.unit,
                 same = (Scheme::reach(particles, from.i, from.i) + skin) / packed.unit.unit;
    // Particles of no kind have no neighbours of their own kind.
    const std::uint32_t kind = Scheme::kind(particles, from.i);
    ScanPackedRow<FindNeighbours, D, Sections> scan_row{
        *this,
        from,
        {},
        kind != 0 ? kind : ~std::uint32_t(0),
        static_cast<float>(limit * limit),
        static_cast<float>(same * same),
        splits ? Scheme::pair_class(particles, from.i, from.i) : PairClass::other,
        found};
    for (int a = 0; a < D; ++a) scan_row.position[a] = packed.unit.pack(from.x[a]);
    for_each_row(from.x - reach, from.x + reach, level, scan_row);
  }

  // Tests the candidates of a level by the SIMD search.
  template <class Sections>
  void search_level(const Viewer& from, int level, SearchMemory& memory, Sections& found) const {
    CellRows& known = memory.of_level[level];
    if (known.cell == order.cell[from.i]) {
      search(from, known.rows, memory.kinds, found);
      return;
    }
    const auto reach = Vector<D, double>::filled(from.limit);
    auto minimum = from.x, maximum = from.x;
    const int own_level = particles.medium(from.i).level;
    const bool of_cell = grids.grid[own_level].find_box(from.x, minimum, maximum);
    known.rows.count = 0;
    known.rows.candidates = 0;
    bool fits = true;
    for_each_row(minimum - reach, maximum + reach, level, [&](Index begin, Index end) {
      while (begin < end) {
        if (known.rows.is_full()) {
          search(from, known.rows, memory.kinds, found);
          known.rows.count = 0;
          known.rows.candidates = 0;
          fits = false;
        }
        begin += known.rows.take(begin, end);
      }
    });
    search(from, known.rows, memory.kinds, found);
    known.cell = of_cell && fits ? order.cell[from.i] : CellRows::no_cell;
  }

  // The candidates of images come from the SIMD search and are tested one by one.
  template <class Sections>
  void search_images(const Viewer& from, int level, Sections& found) const {
    const auto reach = Vector<D, double>::filled(from.limit);
    SearchRows rows;
    const auto test = [&] {
      if (rows.count == 0) return;
      Index candidates[SearchRows::most_candidates + room_beside];
      SearchTask<D> task;
      for (int a = 0; a < D; ++a) {
        task.position[a] = packed.position[a];
        task.own_position[a] = packed.unit.pack(from.x[a]);
      }
      task.kind = packed.kind;
      task.own = task.own_kind = ~Index(0);  // it is of no kind
      const double limit = (1.0 + 1e-6) * from.limit / packed.unit.unit;
      task.limit_squared = static_cast<float>(limit * limit);
      task.same_squared = 0.0f;
      task.rows = &rows;
      Index none[room_beside];
      task.same = none;
      task.others = candidates;
      const auto counts = packed.search(task);
      for (Index n = 0; n < counts.others; ++n)
        scan(from, {candidates[n], candidates[n] + 1}, found);
      rows.count = 0;
      rows.candidates = 0;
    };
    for_each_row(from.x - reach, from.x + reach, level, [&](Index begin, Index end) {
      while (begin < end) {
        if (rows.is_full()) test();
        begin += rows.take(begin, end);
      }
    });
    test();
  }

  // The neighbours of its own kind come from the SIMD search; other candidates are tested one by
  // one.
  template <class Sections>
  void search(const Viewer& from, const SearchRows& rows, KindsOfPairs& kinds,
              Sections& found) const {
    if (rows.count == 0) return;
    const Index i = from.i;
    Index others[SearchRows::most_candidates + room_beside];
    SearchTask<D> task;
    for (int a = 0; a < D; ++a) {
      task.position[a] = packed.position[a];
      task.own_position[a] = packed.unit.pack(from.x[a]);
    }
    task.kind = packed.kind;
    task.own = order.particle_at == nullptr ? i : ~Index(0);
    // Particles of no kind have no neighbours of their own kind.
    const std::uint32_t kind = Scheme::kind(particles, i);
    task.own_kind = kind != 0 ? kind : ~std::uint32_t(0);
    const double limit = from.limit / packed.unit.unit;
    const double reach = Scheme::reach(particles, i, i);
    const double same = (reach + skin) / packed.unit.unit;
    task.limit_squared = static_cast<float>(limit * limit);
    task.same_squared = static_cast<float>(same * same);
    task.rows = &rows;
    const PairClass same_class = splits ? Scheme::pair_class(particles, i, i) : PairClass::other;
    task.same = found.room(same_class, rows.candidates);
    task.others = others;
    const auto counts = packed.search(task);
    found.took(same_class, name_others(i, task.same, counts.same));
    for (Index n = 0; n < counts.others; ++n) test_other(from, kind, others[n], kinds, found);
  }
  // Tests the candidate at a place, which is of another kind than i.
  template <class Sections>
  void test_other(const Viewer& from, std::uint32_t own_kind, Index place, KindsOfPairs& kinds,
                  Sections& found) const {
    const std::uint32_t other_kind = packed.kind[place];
    if (own_kind == 0 || other_kind == 0) return scan(from, {place, place + 1}, found);
    const Index i = from.i, j = order.particle(place);
    const std::uint32_t own = 2 * own_kind + (Scheme::has_own_classes(particles, i) ? 1 : 0);
    const auto& pair = kinds.of(own, other_kind, [&](KindsOfPairs::Entry& entry) {
      const double reach = Scheme::reach(particles, i, j);
      entry.square = reach == 0.0 ? 0.0 : (reach + skin) * (reach + skin);
      entry.pair_class = splits ? Scheme::pair_class(particles, i, j) : PairClass::other;
    });
    const auto& x = particles.build_position[j];
    if (!(squared_distance<D, double>(DifferenceTo<D>{from.x, x}) < pair.square)) return;
    *found.room(pair.pair_class, 1) = j;
    found.took(pair.pair_class, 1);
  }
  // Replaces places by the particles there, without particle i. Returns how many are left.
  Index name_others(Index i, Index* places, Index count) const {
    if (order.particle_at == nullptr) return count;
    Index left = 0;
    for (Index n = 0; n < count; ++n) {
      const Index j = order.particle_at[places[n]];
      places[left] = j;
      left += j != i ? 1 : 0;
    }
    return left;
  }
};

}  // namespace kerf
