// SPDX-License-Identifier: Apache-2.0
// BondHalo divides the particles of a solid among ranks (docs/mpi.md). Each rank computes a share
// of the numbers, which follow the reference configuration, and has ghosts of the particles to
// which those of its share have bonds. Since bonds are found once, so is what is exchanged.
#pragma once

#include <algorithm>
#include <vector>

#include "parallel/entry_messages.hpp"
#include "parallel/index_share.hpp"
#include "solid/bond_table.hpp"

namespace kerf {

template <int D>
class BondHalo {
 public:
  using Numbers = std::vector<Index>;

  // Finds the shares of all ranks and the ghosts, which each rank finds for all of them.
  void set_up(const BondTable<D>& bonds, Index count) {
    const auto all = static_cast<std::size_t>(ranks::count());
    ghosts_.assign(all, {});
    sent_.assign(all, {});
    for (int r = 0; r < ranks::count(); ++r)
      shares_.push_back(IndexShare::of(count, r, ranks::count()));
    first_holder_.assign(1, 0);
    for (Index s = 0; s < count; ++s) {
      const std::size_t before = holder_.size();
      holder_.push_back(owner(s));
      for (Index k = bonds.first(s); k < bonds.last(s); ++k) {
        const Index end = bonds.mirrors.particle(bonds.end(s, k));
        if (shares_[static_cast<std::size_t>(holder_[before])].has(end)) continue;
        const int other = owner(end);
        if (std::find(holder_.begin() + static_cast<std::ptrdiff_t>(before), holder_.end(),
                      other) == holder_.end())
          holder_.push_back(other);
      }
      first_holder_.push_back(static_cast<Index>(holder_.size()));
      note_ghost(s);
    }
  }

  const IndexShare& share() const { return shares_[static_cast<std::size_t>(ranks::number())]; }
  int owner(Index s) const {
    int rank = 0;
    while (!shares_[static_cast<std::size_t>(rank)].has(s)) ++rank;
    return rank;
  }
  // Calls act(rank) for all ranks that compute a particle or have a ghost of it.
  template <class Act>
  void for_each_holder(Index s, const Act& act) const {
    for (Index k = first_holder_[s]; k < first_holder_[s + 1]; ++k) act(holder_[k]);
  }
  // The numbers of the share.
  Numbers own() const {
    Numbers numbers(share().size());
    for (Index k = 0; k < share().size(); ++k) numbers[k] = share().first + k;
    return numbers;
  }

  // Sets the fields of the ghosts to those of their owners. Empty fields are left out.
  template <class... T>
  void to_ghosts(Array<T>&... field) const {
    exchange_entries(sent_, ghosts_, field...);
  }
  // Sets a flag of a particle where it is set of one of its ghosts, whose flags are cleared.
  void to_owners(Array<std::uint8_t>& flags) const {
    std::vector<ranks::Bytes> to(ghosts_.size());
    for (std::size_t r = 0; r < to.size(); ++r) {
      put_entries(flags, ghosts_[r], to[r]);
      for (const Index s : ghosts_[r]) flags[s] = 0;
    }
    std::vector<ranks::Bytes> from(ghosts_.size());
    for (std::size_t r = 0; r < to.size(); ++r) from[r].resize(sent_[r].size());
    ranks::exchange_known(to, from);
    for (std::size_t r = 0; r < to.size(); ++r)
      for (std::size_t n = 0; n < sent_[r].size(); ++n)
        if (from[r][n] != std::byte(0)) flags[sent_[r][n]] = 1;
  }

  std::size_t bytes() const {
    return (holder_.capacity() + first_holder_.capacity()) * sizeof(Index);
  }

 private:
  // `s`: the particle whose holders were found last.
  void note_ghost(Index s) {
    const int own = ranks::number(), of = owner(s);
    for_each_holder(s, [&](int rank) {
      if (rank == own && of != own) ghosts_[static_cast<std::size_t>(of)].push_back(s);
      if (rank != own && of == own) sent_[static_cast<std::size_t>(rank)].push_back(s);
    });
  }

  std::vector<IndexShare> shares_;
  std::vector<Index> first_holder_;     // of each particle, in the list of
  std::vector<int> holder_;             // the ranks that have it, its owner first
  std::vector<Numbers> ghosts_, sent_;  // of each rank: ghosts of its particles here, and of the
                                        // particles here at that rank
};

}  // namespace kerf
