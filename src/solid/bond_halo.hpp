// SPDX-License-Identifier: Apache-2.0
// BondHalo divides the particles of a solid among ranks (docs/mpi.md). Each rank computes a share
// of the numbers, which follow the reference configuration, and has ghosts of the particles to
// which those of its share have bonds. Since bonds are found once, so is what is exchanged.
#pragma once

#include <vector>

#include "parallel/entry_messages.hpp"
#include "solid/bond_holders.hpp"

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
    holders_.find(bonds, count, ranks::count());
    for (Index s = 0; s < count; ++s) note_ghost(s);
  }

  const IndexShare& share() const { return holders_.share(ranks::number()); }
  int owner(Index s) const { return holders_.owner(s); }
  // Calls act(rank) for all ranks that compute a particle or have a ghost of it.
  template <class Act>
  void for_each_holder(Index s, const Act& act) const {
    holders_.for_each(s, act);
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

  std::size_t bytes() const { return holders_.bytes(); }

 private:
  void note_ghost(Index s) {
    const int own = ranks::number(), of = owner(s);
    for_each_holder(s, [&](int rank) {
      if (rank == own && of != own) ghosts_[static_cast<std::size_t>(of)].push_back(s);
      if (rank != own && of == own) sent_[static_cast<std::size_t>(rank)].push_back(s);
    });
  }

  BondHolders<D> holders_;
  std::vector<Numbers> ghosts_, sent_;  // of each rank: ghosts of its particles here, and of the
                                        // particles here at that rank
};

}  // namespace kerf
