// SPDX-License-Identifier: Apache-2.0
// ListBlock finds the neighbour lists of a block of particles on one thread and copies them to the
// memory of the block: where they were before, or at the end of the used memory, which depends on
// which block was ready first. The entries of a list do not.
#pragma once

#include <algorithm>
#include <atomic>

#include "neighbours/find_neighbours.hpp"

namespace kerf {

// Where each list begins and ends, and how many entries are of a class.
struct ListRanges {
  Index *begin, *end, *same_fluid, *unlike, *same_body, *images;
};

// The memory of the lists.
struct ListMemory {
  Index* neighbour;  // room for `room` entries
  Index room;
  std::atomic<Index>* used;  // out: number of entries, also where there is no room for all
  Index* capacity;           // of each block, entries, with the spare ones
};

// The blocks of `length` of `count` particles.
struct ListBlocks {
  Index count, length;

  Index number() const { return (count + length - 1) / length; }
  Index first(Index block) const { return block * length; }
  Index last(Index block) const { return std::min(count, (block + 1) * length); }
};

// Which lists are found: all, or those of the particles that are marked. The others of their blocks
// keep theirs, at another place of the memory. Where there is no room for a block all its particles
// get the mark, and no list: they are found again once there is.
struct ListMarks {
  std::uint8_t* of = nullptr;       // 1: the list of the particle is found; null: all are
  std::uint8_t* no_room = nullptr;  // of each block, out: 1 where there was none
  bool again = false;               // only the blocks without room

  bool any(Index block, Index first, Index last) const {
    if (again) return no_room[block] != 0;
    return of == nullptr || std::find(of + first, of + last, std::uint8_t(1)) != of + last;
  }
  bool is_wanted(Index i) const { return of == nullptr || of[i] != 0; }
  void set_room(Index block, Index first, Index last, bool there) const {
    if (of == nullptr) return;
    no_room[block] = there ? 0 : 1;
    if (!there) std::fill(of + first, of + last, std::uint8_t(1));
  }
};

template <int D, class P, class Scheme>
struct ListBlock {
  static constexpr Index length = 64;  // particles

  FindNeighbours<D, P, Scheme> find;
  ListBlocks blocks;
  ListRanges ranges;
  ListMemory memory;
  ListMarks marks;

  void operator()(Index number) const {
    const Block block{number, blocks.first(number), blocks.last(number)};
    if (!marks.any(number, block.first, block.last)) return;
    thread_local GrownSections found;
    thread_local SearchMemory of_cells;
    const Index before = ranges.begin[block.first];
    found.start_block();
    of_cells.forget();
    for (Index i = block.first; i < block.last; ++i) {
      if (marks.is_wanted(i))
        list(i, found, of_cells);
      else
        keep(i, found);
    }
    place(found, block, before);
  }

 private:
  struct Block {
    Index number, first, last;
  };

  void keep(Index i, GrownSections& found) const {
    const Index begin = ranges.begin[i], end = ranges.end[i];
    ranges.begin[i] = found.size();
    found.append_list(memory.neighbour + begin, end - begin);
    ranges.end[i] = found.size();
  }
  void list(Index i, GrownSections& found, SearchMemory& of_cells) const {
    ranges.begin[i] = found.start_particle();
    find(i, found, &of_cells);
    found.end_particle();
    ranges.end[i] = found.size();
    ranges.same_fluid[i] = found.count(PairClass::same_fluid);
    ranges.unlike[i] = found.count(PairClass::unlike);
    ranges.same_body[i] = found.count(PairClass::same_body);
    ranges.images[i] = found.count(PairClass::image);
  }
  // `before`: where the lists of the block were.
  void place(const GrownSections& found, const Block& block, Index before) const {
    Index& capacity = memory.capacity[block.number];
    Index at = before;
    const bool fits = marks.of != nullptr && !marks.again && found.size() <= capacity;
    if (!fits) {
      capacity = found.size() + found.size() / 16;
      at = memory.used->fetch_add(capacity);
    }
    const bool has_room = at + found.size() <= memory.room;
    marks.set_room(block.number, block.first, block.last, has_room);
    if (has_room) std::copy_n(found.begin(), found.size(), memory.neighbour + at);
    for (Index i = block.first; i < block.last; ++i) {
      ranges.begin[i] = has_room ? ranges.begin[i] + at : 0;
      ranges.end[i] = has_room ? ranges.end[i] + at : 0;
    }
  }
};

}  // namespace kerf
