// SPDX-License-Identifier: Apache-2.0
// NeighbourList is a Verlet list with a skin: for each particle the others within the cutoff and
// the skin, at the positions where the list was built. neighbours/list_validity.hpp decides how
// long it is valid. Each particle has its neighbours in a fixed order, so that sums over them do
// not depend on the number of threads: on request class by class (neighbours/pair_range.hpp), first
// those of the same fluid, then those unlike it, then those of the same body; then the others; then
// mirror images (core/mirror_planes.hpp), at the end those of `PairClass::image`.
#pragma once

#include "core/error.hpp"
#include "neighbours/list_in_passes.hpp"
#include "neighbours/list_validity.hpp"

namespace kerf {

// The neighbours that a pair loop skips.
enum class Skips : std::uint8_t { nothing, of_fluids, of_fluids_and_body };

struct NeighbourView {
  const Index *begin, *end;  // begin[i] .. end[i] of `neighbour` are particle i's
  const Index* neighbour;    // indices, with a mirror code in the highest bits
  // How many of them, one class after the other; the images are the last ones.
  const Index *same_fluid, *unlike, *same_body, *images;
  Skips skips;
  // 1 where a particle has intact bonds to all its neighbours of the same body, which then have no
  // contact with it: a pair loop that skips pairs of fluids skips them too. Or null.
  const std::uint8_t* fully_bonded;

  KERF_FUNCTION Index first(Index i) const {
    if (skips == Skips::nothing) return begin[i];
    const bool skips_body =
        skips == Skips::of_fluids_and_body || (fully_bonded != nullptr && fully_bonded[i] != 0);
    return first_of_body(i) + (skips_body ? same_body[i] : 0);
  }
  KERF_FUNCTION Index last(Index i) const {
    return skips == Skips::nothing ? end[i] : end[i] - images[i];
  }
  // Where those of the same body begin.
  KERF_FUNCTION Index first_of_body(Index i) const { return begin[i] + same_fluid[i] + unlike[i]; }
};

template <int D, class P, class Scheme>
class NeighbourList {
 public:
  NeighbourList() = default;
  // `longest`: the longest cutoff of a pair, m; `skin` in m.
  NeighbourList(const Vector<D, double>& minimum, const Vector<D, double>& maximum, double longest,
                double skin)
      : NeighbourList(minimum, maximum, LevelReach::one(longest), skin) {}
  NeighbourList(const Vector<D, double>& minimum, const Vector<D, double>& maximum,
                const LevelReach& reach, double skin)
      : grids_(LevelGrids<D>::covering(minimum, maximum, reach, skin)),
        validity_(grids_, skin),
        skin_(skin) {}

  // Moves the domain: that is where its lowest corner is then, m. build() must follow.
  void move_to(const Vector<D, double>& minimum) {
    for (int level = 0; level < grids_.levels; ++level) grids_.grid[level].origin = minimum;
    validity_ = ListValidity<D, P>(grids_, skin_);
  }

  // Makes the lists go class by class.
  void sort_neighbours_by_class() { splits_ = true; }

  // Returns the cell numbers of the build positions, the sort key of the particles.
  const Array<Index>& cell_numbers(Particles<D, P>& particles) {
    key_.resize(particles.size());
    for_each_index(particles.size(), CellNumber<D, P>{particles.view(), grids_, pointer(key_)});
    return key_;
  }

  // Particles must already be in the order of their cell numbers.
  void build(Particles<D, P>& particles) {
    const Index n = particles.size();
    require(particles.mirrors.faces == 0 || n <= MirrorPlanes<D>::most_particles,
            "as many particles as have indices beside the codes of mirrors");
    cell_numbers(particles);
    const Index cells = grids_.count();
    cell_begin_.resize(cells + 1);
    for_each_index(n + 1, BeginCells{pointer(key_), n, cells, pointer(cell_begin_)});
    begin_.resize(n + 1);
    for (auto* array : {&end_, &same_fluid_, &unlike_, &same_body_, &images_}) array->resize(n);
    const FindNeighbours<D, P, Scheme> find{particles.view(),          grids_, pointer(key_),
                                            pointer(cell_begin_),      skin_,  splits_,
                                            pack_for_search(particles)};
    const ListRanges ranges{pointer(begin_),  pointer(end_),       pointer(same_fluid_),
                            pointer(unlike_), pointer(same_body_), pointer(images_)};
    if constexpr (simd_exists)
      list_in_blocks(find, ranges, n);
    else
      list_in_passes(find, ranges, n);
    validity_.restart(cell_begin_);
  }

  // Must be called for each step.
  void note(const StepMotion& motion) { validity_.note(motion); }
  // Returns whether a pair that is not listed may come within reach in the next `horizon` seconds.
  bool is_outdated(Particles<D, P>& particles, double horizon) {
    return !validity_.holds(particles, cell_begin_, horizon);
  }

  NeighbourView view() const {
    return {pointer(begin_),      pointer(end_),    pointer(neighbour_),
            pointer(same_fluid_), pointer(unlike_), pointer(same_body_),
            pointer(images_),     Skips::nothing,   nullptr};
  }
  Index pairs() const { return pairs_; }  // list entries, each pair twice
  std::size_t bytes() const {
    std::size_t entries = neighbour_.size() + begin_.size() + end_.size() + same_fluid_.size() +
                          unlike_.size() + same_body_.size() + images_.size() + cell_begin_.size() +
                          key_.size() + packed_kind_.size();
    for (const auto& coordinates : packed_position_) entries += coordinates.size();
    return sizeof(Index) * entries + validity_.bytes();  // packed coordinates are as long
  }

 private:
  using Find = FindNeighbours<D, P, Scheme>;

  void list_in_blocks(const Find& find, const ListRanges& ranges, Index count) {
    using Block = ListBlock<D, P, Scheme>;
    std::atomic<Index> used = 0;
    const auto list = [&] {
      used = 0;
      const auto room = static_cast<Index>(neighbour_.size());
      for_each_index((count + Block::length - 1) / Block::length,
                     Block{find, count, ranges, pointer(neighbour_), room, &used});
      pairs_ = used;
      return pairs_ <= room;
    };
    if (list()) return;
    neighbour_.resize(pairs_ + pairs_ / 8);
    list();
  }

  void list_in_passes(const Find& find, const ListRanges& ranges, Index count) {
    for_each_index(count, CountNeighbours<D, P, Scheme>{find, ranges});
    thrust::fill_n(begin_.begin() + count, 1, Index(0));
    thrust::exclusive_scan(loop_policy(), begin_.begin(), begin_.end(), begin_.begin());
    pairs_ = begin_[count];
    if (neighbour_.size() < pairs_) neighbour_.resize(pairs_ + pairs_ / 8);
    for_each_index(count, WriteNeighbours<D, P, Scheme>{find, ranges, pointer(neighbour_)});
  }

  // Has no search where cells are so wide that wrapping fixed-point coordinates would be ambiguous.
  SearchView<D> pack_for_search(Particles<D, P>& particles) {
    SearchView<D> packed;
    if constexpr (!simd_exists) return packed;
    constexpr double widest = 8.0;  // finest cutoffs that a cell and its cutoff may span
    const double finest = grids_.limit[0][0];
    for (int level = 0; level < grids_.levels; ++level)
      if (grids_.grid[level].cell + grids_.limit[level][level] > widest * finest) return packed;
    constexpr std::size_t beyond = 64;  // entries that a load may read past the end
    const std::size_t room = particles.size() + beyond;
    for (int a = 0; a < D; ++a) {
      packed_position_[a].resize(room);
      packed.position[a] = packed_position_[a].data();
    }
    packed_kind_.resize(room);
    packed.kind = packed_kind_.data();
    packed.unit = FixedPointScale<float>::of_spacing(finest / widest);
    packed.search = search_kernels().template get<D>();
    for_each_index(particles.size(), PackForSearch<D, P, Scheme>{particles.view(), packed});
    return packed;
  }

  LevelGrids<D> grids_{};
  ListValidity<D, P> validity_;
  double skin_ = 0.0;
  Index pairs_ = 0;
  bool splits_ = false;
  Array<Index> key_, cell_begin_, begin_, end_, same_fluid_, unlike_, same_body_, images_,
      neighbour_;
  std::vector<std::int32_t> packed_position_[D];
  std::vector<std::uint32_t> packed_kind_;
};

}  // namespace kerf
