// SPDX-License-Identifier: Apache-2.0
// PlannedParticles divides the particles of a run of one rank as several ranks would
// (distributed/domain_decomposition.hpp), and counts what each would have.
#pragma once

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "distributed/messages.hpp"
#include "distributed/patches_around.hpp"
#include "distributed/pieces_of_rows.hpp"
#include "distributed/planned_messages.hpp"
#include "neighbours/list_entries.hpp"

namespace kerf {

template <int D, class P>
class PlannedParticles {
 public:
  // The particles must have been listed by `grids`; both must live as long as this object.
  PlannedParticles(const Particles<D, P>& particles, const LevelGrids<D>& grids, int ranks)
      : particles_(particles), grids_(grids), pieces_(particles, grids) {
    if (ranks == 1) {
      rank_ = pieces_.owners(nullptr);
      return;
    }
    const auto partition = make_partition(pieces_.points(), D, ranks);
    rank_ = pieces_.owners(partition.get());
  }
  // The rank of each particle.
  const std::vector<int>& ranks() const { return rank_; }

  // Adds the particles and ghosts of each rank, and the updates of the ghosts in a step, which are
  // those in lists (distributed/listed_ghosts.hpp).
  void add_to(std::vector<RankLoad>& loads, PlannedMessages& messages,
              const NeighbourView& list) const {
    for (Index i = 0; i < particles_.size(); ++i) {
      RankLoad& load = loads[static_cast<std::size_t>(rank_[i])];
      load.work += double(pieces_.work(i));
      ++load.particles;
    }
    for_each_ghosts([&](int of, int at, Index count) {
      if (of != at) loads[static_cast<std::size_t>(at)].ghosts += count;
    });
    const double bytes = static_cast<double>(bytes_in_message<PairedFields>(particles_));
    for_each_listed_ghost(list, [&](int of, int at) { messages.add(of, at, bytes); });
  }

 private:
  // Calls visit(of, at) for each ghost at a rank that is in a list there.
  template <class Visit>
  void for_each_listed_ghost(const NeighbourView& list, const Visit& visit) const {
    std::vector<Index> by_rank(rank_.size());
    std::iota(by_rank.begin(), by_rank.end(), Index(0));
    std::stable_sort(by_rank.begin(), by_rank.end(),
                     [this](Index i, Index j) { return rank_[i] < rank_[j]; });
    std::vector<int> last_reader(rank_.size(), -1);  // the last rank that has it in a list
    for (const Index i : by_rank)
      for (Index k = list.begin[i]; k < list.end[i]; ++k) {
        const Index j = particles_.mirrors.particle(list.neighbour[k]);
        if (std::exchange(last_reader[j], rank_[i]) != rank_[i] && rank_[j] != rank_[i])
          visit(rank_[j], rank_[i]);
      }
  }

  struct Share {
    int rank;
    Index count;
  };

  // The particles that each rank has of each patch: those of patch p begin at begin[p].
  struct Shares {
    std::vector<Share> of;
    std::vector<std::size_t> begin;
  };
  Shares shares_of(const PatchGrids<D>& patches) const {
    const std::vector<Index> patch = patches_of_particles(particles_, grids_, patches);
    std::vector<std::pair<Index, int>> all;
    for (std::size_t i = 0; i < patch.size(); ++i) all.emplace_back(patch[i], rank_[i]);
    std::sort(all.begin(), all.end());
    Shares shares;
    shares.begin.assign(patches.count() + 1, 0);
    for (std::size_t k = 0; k < all.size(); ++k) {
      if (k == 0 || all[k] != all[k - 1]) {
        shares.of.push_back({all[k].second, 0});
        ++shares.begin[all[k].first + 1];
      }
      ++shares.of.back().count;
    }
    for (std::size_t p = 1; p < shares.begin.size(); ++p) shares.begin[p] += shares.begin[p - 1];
    return shares;
  }

  // Calls visit(of, at, count) for the particles of each patch and each rank `of` that are needed
  // at a rank.
  template <class Visit>
  void for_each_ghosts(const Visit& visit) const {
    const auto patches = PatchGrids<D>::of(grids_);
    const Shares shares = shares_of(patches);
    for (Index p = 0; p < patches.count(); ++p) {
      if (shares.begin[p] == shares.begin[p + 1]) continue;
      const std::vector<int> around = ranks_around(p, patches, shares);
      for (std::size_t k = shares.begin[p]; k < shares.begin[p + 1]; ++k)
        for (const int at : around) visit(shares.of[k].rank, at, shares.of[k].count);
    }
  }
  // Returns the ranks that have particles of the patches around one.
  std::vector<int> ranks_around(Index patch, const PatchGrids<D>& patches,
                                const Shares& shares) const {
    std::vector<int> around;
    for_each_row_around(patch, grids_, patches, [&](Index first, Index last) {
      for (std::size_t k = shares.begin[first]; k < shares.begin[last + 1]; ++k)
        around.push_back(shares.of[k].rank);
    });
    std::sort(around.begin(), around.end());
    around.erase(std::unique(around.begin(), around.end()), around.end());
    return around;
  }

  const Particles<D, P>& particles_;
  const LevelGrids<D>& grids_;
  PiecesOfRows<D, P> pieces_;
  std::vector<int> rank_;
};

}  // namespace kerf
