// SPDX-License-Identifier: Apache-2.0
// carry_over() takes the state of a solid into another one that shares some of its particles, as
// where a window of a long block moves on: particles and bonds that are in both keep their state;
// new particles are undeformed and bonded to all others but the detached ones.
#pragma once

#include <vector>

#include "core/error.hpp"
#include "solid/total_lagrangian.hpp"

namespace kerf {

// The bonds of a solid and their state, on the host.
template <int D, class P>
class BondsOnHost {
 public:
  BondsOnHost(const SolidFields<D, P>& fields, std::vector<std::uint32_t>& intact)
      : begin_(to_host(fields.bond_begin)),
        count_(to_host(fields.bond_count)),
        entry_(to_host(fields.bond_entry)),
        intact_(intact),
        words_(fields.words),
        mirrors_(fields.mirrors) {}
  BondsOnHost(const BondsOnHost&) = delete;

  BondTable<D> table() const { return {begin_.data(), count_.data(), entry_.data(), mirrors_}; }
  bool is_intact(Index i, Index k) const { return (intact_[word(i, k)] & bit(i, k)) != 0; }
  void break_bond(Index i, Index k) { intact_[word(i, k)] &= ~bit(i, k); }

 private:
  std::size_t word(Index i, Index k) const {
    return std::size_t(i) * words_ + (k - begin_[i]) / bonds_per_word;
  }
  std::uint32_t bit(Index i, Index k) const {
    return std::uint32_t(1) << ((k - begin_[i]) % bonds_per_word);
  }

  std::vector<Index> begin_;
  std::vector<std::uint16_t> count_;
  std::vector<Index> entry_;
  std::vector<std::uint32_t>& intact_;
  Index words_;
  MirrorPlanes<D> mirrors_;
};

inline constexpr Index not_carried = 0xffffffffu;

// Returns the state of the solid `now`. `earlier`: for each of its particles the number that it has
// in the solid `before`, or not_carried.
template <int D, class P>
SolidState<D, P> carry_over(const TotalLagrangian<D, P>& before, const TotalLagrangian<D, P>& now,
                            const std::vector<Index>& earlier) {
  SolidState<D, P> old = before.save(), state = now.save();
  const auto copy = [&](const auto& from, auto& to) {
    if (to.empty()) return;
    for (std::size_t s = 0; s < earlier.size(); ++s)
      if (earlier[s] != not_carried) to[s] = from[earlier[s]];
  };
  copy(old.elastic_share, state.elastic_share);
  copy(old.acceleration, state.acceleration);
  copy(old.mirror_acceleration, state.mirror_acceleration);
  copy(old.flow, state.flow);
  copy(old.strain, state.strain);
  copy(old.flaws, state.flaws);
  copy(old.loading, state.loading);

  const auto detached = to_host(before.fields().detached);
  const auto& mirrors = now.fields().mirrors;
  const BondsOnHost<D, P> kept(before.fields(), old.bond_intact);
  BondsOnHost<D, P> bonds(now.fields(), state.bond_intact);
  const BondTable<D> table = bonds.table(), old_table = kept.table();
  for (Index s = 0; s < static_cast<Index>(earlier.size()); ++s)
    for (Index k = table.first(s); k < table.last(s); ++k) {
      const Index end = table.end(s, k);
      const Index a = earlier[s], b = earlier[mirrors.particle(end)];
      bool is_intact = true;
      if (a != not_carried && b != not_carried) {
        const Index bond = bond_between(old_table, a, b | mirrors.code(end));
        require(bond != no_bond, "particles of a window keep their bonds");
        is_intact = kept.is_intact(a, bond);
      } else if (a != not_carried || b != not_carried) {
        is_intact = detached[a != not_carried ? a : b] == 0;
      }
      if (!is_intact) bonds.break_bond(s, k);
    }
  return state;
}

}  // namespace kerf
