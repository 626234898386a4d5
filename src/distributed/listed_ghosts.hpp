// SPDX-License-Identifier: Apache-2.0
// ListedGhosts updates the ghosts that are in neighbour lists. A rank has ghosts of whole patches
// around its own particles (distributed/patches_around.hpp), and pairs read about half of them.
#pragma once

#include <vector>

#include "distributed/messages.hpp"
#include "neighbours/list_entries.hpp"
#include "parallel/loops.hpp"

namespace kerf {

// Marks the particles in the list of each particle.
template <int D>
struct MarkListed {
  NeighbourView list;
  MirrorPlanes<D> mirrors;
  std::uint8_t* marks;  // out

  KERF_FUNCTION void operator()(Index i) const {
    for (Index k = list.begin[i]; k < list.end[i]; ++k) {
      std::uint8_t& mark = marks[mirrors.particle(list.neighbour[k])];
      if (load_flag(mark) == 0) set_flag(mark);
    }
  }
};

template <int D, class P>
class ListedGhosts {
 public:
  using Chosen = std::vector<std::vector<Index>>;  // particles, for each rank

  // Takes new lists of the particles that are not ghosts. `send`: those that are ghosts of each
  // rank, in the order of its ghosts; `ghosts`: how many are here of each rank.
  void find(const Particles<D, P>& particles, const NeighbourView& list, const Chosen& send,
            const std::vector<std::size_t>& ghosts) {
    marks_.resize(particles.size());
    thrust::fill(marks_.begin(), marks_.end(), std::uint8_t(0));
    for_each_index(particles.owned(), MarkListed<D>{list, particles.mirrors, pointer(marks_)});
    std::vector<ranks::Bytes> to(send.size()), from(send.size());
    awaited_.assign(send.size(), {});
    Index next = particles.ghosts.first;
    for (std::size_t r = 0; r < send.size(); ++r) {
      from[r].resize(send[r].size());
      for (std::size_t n = 0; n < ghosts[r]; ++n, ++next) {
        to[r].push_back(std::byte(marks_[next]));
        if (marks_[next] != 0) awaited_[r].push_back(next);
      }
    }
    ranks::exchange_known(to, from);
    sent_.assign(send.size(), {});
    for (std::size_t r = 0; r < send.size(); ++r)
      for (std::size_t n = 0; n < send[r].size(); ++n)
        if (from[r][n] != std::byte(0)) sent_[r].push_back(send[r][n]);
    to_.resize(send.size());
    from_.resize(send.size());
    for (std::size_t r = 0; r < send.size(); ++r)
      from_[r].resize(awaited_[r].size() * bytes_in_message<PairedFields>(particles));
  }

  // Sets the fields that pair loops read to those at the owners.
  void update(Particles<D, P>& particles) {
    for (std::size_t r = 0; r < sent_.size(); ++r) pack<PairedFields>(particles, sent_[r], to_[r]);
    ranks::exchange_known(to_, from_);
    for (std::size_t r = 0; r < awaited_.size(); ++r)
      unpack<PairedFields>(from_[r], particles, awaited_[r]);
  }

 private:
  Chosen sent_, awaited_;
  std::vector<ranks::Bytes> to_, from_;  // messages of an update
  Array<std::uint8_t> marks_;            // scratch
};

}  // namespace kerf
