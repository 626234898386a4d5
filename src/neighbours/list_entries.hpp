// SPDX-License-Identifier: Apache-2.0
// ListEntries holds the neighbour lists of all particles: whole ones are found for all of them, or
// only those of some, while the others keep theirs.
#pragma once

#include "neighbours/compact_lists.hpp"
#include "neighbours/ghost_names.hpp"
#include "neighbours/list_in_passes.hpp"

namespace kerf {

// The neighbours that a pair loop skips.
enum class Skips : std::uint8_t { nothing, same_fluid, of_fluids, of_fluids_and_body };

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
    if (skips == Skips::same_fluid && unlike[i] != 0) return begin[i] + same_fluid[i];
    const bool skips_body =
        skips == Skips::of_fluids_and_body || (fully_bonded != nullptr && fully_bonded[i] != 0);
    return first_of_body(i) + (skips_body ? same_body[i] : 0);
  }
  KERF_FUNCTION Index last(Index i) const {
    return skips == Skips::nothing || skips == Skips::same_fluid ? end[i] : end[i] - images[i];
  }
  // Where those of the same body begin.
  KERF_FUNCTION Index first_of_body(Index i) const { return begin[i] + same_fluid[i] + unlike[i]; }
};

// The length of a list, for sums.
struct ListLength {
  const Index *begin, *end;
  KERF_FUNCTION Index operator()(Index i) const { return end[i] - begin[i]; }
};
struct Plus {
  KERF_FUNCTION Index operator()(Index a, Index b) const { return a + b; }
};
template <int D, class P, class Scheme>
class ListEntries {
 public:
  using Find = FindNeighbours<D, P, Scheme>;

  // Finds the lists of `count` particles.
  void list(const Find& find, Index count) {
    make_room(count);
    if constexpr (simd_exists) {
      used_ = 0;
      list_in_blocks(find, count, {});
      if (used_ > neighbour_.size()) {
        neighbour_.resize(used_ + used_ / 16);
        used_ = 0;
        list_in_blocks(find, count, {});
      }
    } else {
      list_in_passes(find, count);
    }
    sum_up(count);
  }
  // Finds those of the particles that are marked with 1, and marks others whose lists it finds too.
  void list_anew(const Find& find, Index count, Array<std::uint8_t>& marks) {
    if constexpr (simd_exists) {
      make_room(count);
      no_room_.assign(capacity_.size(), std::uint8_t(0));
      ListMarks of{pointer(marks), no_room_.data()};
      list_in_blocks(find, count, of);
      if (used_ > neighbour_.size()) {
        compact(count);
        of.again = true;
        list_in_blocks(find, count, of);
      }
      sum_up(count);
    } else {
      thrust::fill(marks.begin(), marks.end(), std::uint8_t(1));
      list(find, count);
    }
  }

  // Names the new ghosts in the lists that are kept, of the particles without a mark.
  template <int D_>
  void name_ghosts(const GhostNames& names, const MirrorPlanes<D_>& mirrors,
                   const Array<std::uint8_t>& marks) {
    const auto kept = static_cast<Index>(end_.size());
    for_each_index(kept, NameGhosts<D_>{pointer(begin_), pointer(end_), pointer(marks), mirrors,
                                        names.names(), names.first(), pointer(neighbour_)});
  }

  NeighbourView view() const {
    return {pointer(begin_),      pointer(end_),    pointer(neighbour_),
            pointer(same_fluid_), pointer(unlike_), pointer(same_body_),
            pointer(images_),     Skips::nothing,   nullptr};
  }
  Index pairs() const { return pairs_; }  // list entries, each pair twice
  std::size_t entries() const {           // of all arrays
    return neighbour_.size() + begin_.size() + end_.size() + same_fluid_.size() + unlike_.size() +
           same_body_.size() + images_.size() + capacity_.size() + no_room_.size() / sizeof(Index);
  }

 private:
  ListRanges ranges() {
    return {pointer(begin_),  pointer(end_),       pointer(same_fluid_),
            pointer(unlike_), pointer(same_body_), pointer(images_)};
  }

  using Block = ListBlock<D, P, Scheme>;

  void make_room(Index count) {
    begin_.resize(count + 1);
    for (auto* array : {&end_, &same_fluid_, &unlike_, &same_body_, &images_}) array->resize(count);
    if constexpr (simd_exists) capacity_.resize(ListBlocks{count, Block::length}.number());
  }
  ListMemory memory(std::atomic<Index>& used) {
    return {pointer(neighbour_), static_cast<Index>(neighbour_.size()), &used, pointer(capacity_)};
  }
  void list_in_blocks(const Find& find, Index count, const ListMarks& marks) {
    const ListBlocks blocks{count, Block::length};
    std::atomic<Index> used = used_;
    for_each_index(blocks.number(), Block{find, blocks, ranges(), memory(used), marks});
    used_ = used;
  }
  // Makes room for the blocks that had none.
  void compact(Index count) {
    const ListBlocks blocks{count, Block::length};
    Index wanted = 0;
    for (Index block = 0; block < blocks.number(); ++block)
      if (no_room_[block] != 0) wanted += capacity_[block];
    std::atomic<Index> none = 0;
    used_ = compact_lists(blocks, ranges(), memory(none));
    if (used_ + wanted > neighbour_.size()) neighbour_.resize(used_ + wanted + used_ / 16);
  }

  void list_in_passes(const Find& find, Index count) {
    for_each_index(count, CountNeighbours<D, P, Scheme>{find, ranges()});
    thrust::fill_n(loop_policy(), begin_.begin() + count, 1, Index(0));
    thrust::exclusive_scan(loop_policy(), begin_.begin(), begin_.end(), begin_.begin());
    used_ = begin_[count];
    if (neighbour_.size() < used_) neighbour_.resize(used_ + used_ / 8);
    for_each_index(count, WriteNeighbours<D, P, Scheme>{find, ranges(), pointer(neighbour_)});
  }

  void sum_up(Index count) {
    pairs_ = reduce_unordered(count, ListLength{pointer(begin_), pointer(end_)}, Index(0), Plus{});
  }

  Index pairs_ = 0, used_ = 0;
  Array<Index> begin_, end_, same_fluid_, unlike_, same_body_, images_, neighbour_, capacity_;
  std::vector<std::uint8_t> no_room_;  // of each block, scratch
};

}  // namespace kerf
