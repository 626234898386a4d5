// SPDX-License-Identifier: Apache-2.0
// NeighbourList is a Verlet list with a skin: for each particle the others within the cutoff and
// the skin, at their build positions. neighbours/list_validity.hpp decides how long it is valid,
// neighbours/refresh_list.hpp how it is refreshed where particles have moved. Each particle has its
// neighbours in a fixed order, so that sums over them do not depend on the number of threads: on
// request class by class (neighbours/pair_range.hpp), first those of the same fluid, then those
// unlike it, then those of the same body; then the others; then mirror images
// (core/mirror_planes.hpp), at the end those of `PairClass::image`.
#pragma once

#include "core/error.hpp"
#include "neighbours/list_entries.hpp"
#include "neighbours/list_validity.hpp"
#include "neighbours/refresh_list.hpp"

namespace kerf {

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

  const LevelGrids<D>& grids() const { return grids_; }

  // Returns the cell numbers of the build positions, the sort key of the particles.
  const Array<Index>& cell_numbers(Particles<D, P>& particles) {
    return cells_.number(particles, grids_);
  }

  // Finds all lists but those of ghosts, of particles in any order: best in that of their cell
  // numbers.
  void build(Particles<D, P>& particles) {
    const Index n = particles.size();
    require(particles.mirrors.faces == 0 || n <= MirrorPlanes<D>::most_particles,
            "as many particles as have indices beside the codes of mirrors");
    cells_.build(particles, grids_);
    entries_.list(find(particles), particles.owned());
    listed_as_ = particles.fractured;
    validity_.restart(cells_.view());
  }

  // Refreshes the list, which has no newcomers yet, the particles at the end, and is outdated if
  // they have moved (is_outdated()). Returns false where the particles must be sorted and listed
  // anew: too many have moved or come, or the list would not hold for `horizon` seconds; and on a
  // GPU, where that takes no longer.
  bool refresh(Particles<D, P>& particles, double horizon, bool have_moved) {
    if (!mark_for_refresh(particles, have_moved)) return false;
    refresh_marked(particles, true);
    return is_usable(particles, horizon);
  }
  // The same in parts, for several ranks, which fetch their ghosts anew in between. It marks the
  // particles that have moved or come, unless that are too many.
  bool mark_for_refresh(Particles<D, P>& particles, bool have_moved) {
    if (on_gpu) return false;
    constexpr double share = 0.3;  // of the skin; two that have moved less apart need no refresh
    const Index n = particles.size(), listed = this->listed();
    moved_.resize(n);
    thrust::fill(moved_.begin(), moved_.begin() + listed, std::uint8_t(0));
    thrust::fill(moved_.begin() + listed, moved_.end(), std::uint8_t(1));
    if (have_moved) validity_.mark_moved(cells_.view(), share, pointer(moved_));
    const IsMarked<D, P> is_marked{particles.view(), pointer(moved_)};
    return ranks::total(count_indices(n, is_marked)) <= ranks::total(particles.owned()) / 2;
  }
  // Marks those whose lists may change, before the ghosts are dropped, and gives the moved ones new
  // build positions.
  void leave_ghosts(Particles<D, P>& particles) {
    start_marks(particles);
    mark_around(particles, listed(), true);
    ghost_names_.note(particles);
    for (auto* marks : {&moved_, &listed_anew_}) {
      const auto ghosts = marks->begin() + particles.ghosts.first;
      marks->erase(ghosts, ghosts + particles.ghosts.count);
    }
  }
  // The marks of the particles that have moved or come: those of new ghosts must be those at their
  // owners.
  Array<std::uint8_t>& moved(Index particles) {
    moved_.resize(particles);
    return moved_;
  }
  // Finds the lists that may have changed, when the new ghosts are there.
  void take_ghosts(Particles<D, P>& particles) {
    listed_anew_.resize(particles.size(), std::uint8_t(0));
    cells_.build(particles, grids_);
    validity_.restart(cells_.view());
    mark_around(particles, particles.size(), false);
    ghost_names_.find(particles);
    entries_.name_ghosts(ghost_names_, particles.mirrors, listed_anew_);
    list_marked(particles);
  }
  // Returns whether the particles are still in order and the list will hold.
  bool is_usable(Particles<D, P>& particles, double horizon) {
    return ranks::total(disorder(particles)) <= ranks::total(particles.owned()) / 8 &&
           validity_.holds(particles, cells_.view(), horizon);
  }
  // Refreshes it around the particles that have become fluid.
  void refresh_fractured(Particles<D, P>& particles) {
    moved_.resize(particles.size());
    for_each_index(particles.size(),
                   MarkFractured<D, P>{particles.view(), pointer(listed_as_), pointer(moved_)});
    refresh_marked(particles, false);
  }
  // 1 for the particles whose list the last refresh has found again.
  const std::uint8_t* listed_anew() const { return pointer(listed_anew_); }
  // How many particles are listed.
  Index listed() const { return static_cast<Index>(listed_as_.size()); }

  // Whether the notes of the last steps show that it will be valid (is_outdated()).
  bool holds_by_notes(double horizon) const { return validity_.holds_by_notes(horizon); }
  // Must be called for each step.
  void note(const StepMotion& motion) { validity_.note(motion); }
  // Returns whether a pair that is not listed may come within reach in the next `horizon` seconds.
  bool is_outdated(Particles<D, P>& particles, double horizon) {
    return !validity_.holds(particles, cells_.view(), horizon);
  }

  NeighbourView view() const { return entries_.view(); }
  Index pairs() const { return entries_.pairs(); }  // list entries, each pair twice
  std::size_t bytes() const {
    std::size_t entries =
        entries_.entries() + cells_.entries() + unmoved_.entries() + packed_kind_.size();
    for (const auto& coordinates : packed_position_) entries += coordinates.size();
    return sizeof(Index) * entries + moved_.size() + listed_anew_.size() + listed_as_.size() +
           validity_.bytes();  // packed coordinates are as long as an index
  }

 private:
  using Find = FindNeighbours<D, P, Scheme>;

  Index disorder(Particles<D, P>& particles) const {
    const GroupView groups = particles.sum_groups.view();
    const DisorderOfGroup of_group{groups, cells_.view().cell, pointer(particles.sorted_cell)};
    return reduce_unordered(groups.count, of_group, Index(0), AddCounts{});
  }

  // Lists the particles of `moved_`, at their positions if it `moves` them, and those around them.
  void refresh_marked(Particles<D, P>& particles, bool moves) {
    start_marks(particles);
    mark_around(particles, listed(), moves);
    if (moves) {
      cells_.build(particles, grids_);
      validity_.restart(cells_.view());
    }
    list_marked(particles);
  }
  void start_marks(const Particles<D, P>& particles) {
    listed_anew_.resize(particles.size());
    thrust::fill(listed_anew_.begin(), listed_anew_.end(), std::uint8_t(0));
  }
  // Marks the particles of `moved_` and those around them, of which the cells know the first
  // `places`, and moves their build positions if it `moves` them.
  void mark_around(Particles<D, P>& particles, Index places, bool moves) {
    const Index n = particles.size();
    const auto view = particles.view();
    unmoved_.find(cells_.view(), places, pointer(moved_));
    for_each_index(n, MarkAround<D, P>{view, grids_, cells_.view(), unmoved_.view(),
                                       pointer(moved_), moves, pointer(listed_anew_)});
    if (moves) for_each_index(n, MoveBuildPosition<D, P>{view, pointer(moved_)});
  }
  void list_marked(Particles<D, P>& particles) {
    entries_.list_anew(find(particles), particles.owned(), listed_anew_);
    listed_as_ = particles.fractured;
  }

  Find find(Particles<D, P>& particles) {
    return {particles.view(), grids_, cells_.view(), skin_, splits_, pack_for_search(particles)};
  }

  // Has no search where cells are so wide that wrapping fixed-point coordinates would be ambiguous.
  SearchView<D> pack_for_search(Particles<D, P>& particles) {
    SearchView<D> packed;
    constexpr double widest = 8.0;  // finest cutoffs that a cell and its cutoff may span
    const double finest = grids_.limit[0][0];
    for (int level = 0; level < grids_.levels; ++level)
      if (grids_.grid[level].cell + grids_.limit[level][level] > widest * finest) return packed;
    constexpr std::size_t beyond = 64;  // entries that a load may read past the end
    const std::size_t room = particles.size() + beyond;
    for (int a = 0; a < D; ++a) {
      packed_position_[a].resize(room);
      packed.position[a] = pointer(packed_position_[a]);
    }
    packed_kind_.resize(room);
    packed.kind = pointer(packed_kind_);
    packed.unit = FixedPointScale<float>::of_spacing(finest / widest);
    if constexpr (simd_exists) packed.search = search_kernels().template get<D>();
    for_each_index(particles.size(),
                   PackForSearch<D, P, Scheme>{particles.view(), cells_.view(), packed});
    return packed;
  }

  LevelGrids<D> grids_{};
  ListValidity<D, P> validity_;
  ListEntries<D, P, Scheme> entries_;
  CellTable<D, P> cells_;
  UnmovedParticles unmoved_;
  GhostNames ghost_names_;
  double skin_ = 0.0;
  bool splits_ = false;
  Array<std::uint8_t> listed_as_, moved_, listed_anew_;
  Array<std::int32_t> packed_position_[D];
  Array<std::uint32_t> packed_kind_;
};

}  // namespace kerf
