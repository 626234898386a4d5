// SPDX-License-Identifier: Apache-2.0
// BondHolders tells which ranks need a particle of a solid (docs/mpi.md): the rank that computes it
// by its share of the numbers, and those that have a ghost of it, since a particle of theirs has a
// bond to it.
#pragma once

#include <algorithm>
#include <vector>

#include "parallel/index_share.hpp"
#include "solid/bond_table.hpp"

namespace kerf {

template <int D>
class BondHolders {
 public:
  // Finds the shares of so many ranks and the holders of `count` particles.
  void find(const BondTable<D>& bonds, Index count, int ranks) {
    shares_.clear();
    for (int r = 0; r < ranks; ++r) shares_.push_back(IndexShare::of(count, r, ranks));
    holder_.clear();
    first_holder_.assign(1, 0);
    for (Index s = 0; s < count; ++s) {
      find_holders(bonds, s);
      first_holder_.push_back(static_cast<Index>(holder_.size()));
    }
  }

  const IndexShare& share(int rank) const { return shares_[static_cast<std::size_t>(rank)]; }
  int owner(Index s) const {
    const auto ends_before = [](const IndexShare& share, Index number) {
      return share.last <= number;
    };
    return static_cast<int>(std::lower_bound(shares_.begin(), shares_.end(), s, ends_before) -
                            shares_.begin());
  }
  // Calls act(rank) for all ranks that compute a particle or have a ghost of it, its owner first.
  template <class Act>
  void for_each(Index s, const Act& act) const {
    for (Index k = first_holder_[s]; k < first_holder_[s + 1]; ++k) act(holder_[k]);
  }

  std::size_t bytes() const {
    return (holder_.capacity() + first_holder_.capacity()) * sizeof(Index);
  }

 private:
  void find_holders(const BondTable<D>& bonds, Index s) {
    const auto before = static_cast<std::ptrdiff_t>(holder_.size());
    const int own = owner(s);
    holder_.push_back(own);
    for (Index k = bonds.first(s); k < bonds.last(s); ++k) {
      const Index end = bonds.mirrors.particle(bonds.end(s, k));
      if (share(own).has(end)) continue;
      const int other = owner(end);
      if (std::find(holder_.begin() + before, holder_.end(), other) == holder_.end())
        holder_.push_back(other);
    }
  }

  std::vector<IndexShare> shares_;
  std::vector<Index> first_holder_;  // of each particle, in the list of
  std::vector<int> holder_;          // the ranks that have it, its owner first
};

}  // namespace kerf
