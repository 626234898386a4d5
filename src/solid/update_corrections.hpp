// SPDX-License-Identifier: Apache-2.0
// CorrectionUpdate computes the gradient corrections of particles whose bonds have changed. A
// particle that becomes detached takes bonds from others, which may become detached in turn.
#pragma once

#include "solid/bond_halo.hpp"
#include "solid/gradient_correction.hpp"
#include "solid/simd/bond_sums.hpp"

namespace kerf {

// Marks the other ends of the bonds of particles that have become detached, and these themselves.
template <int D, class P>
struct MarkBesideDetached {
  SolidView<D, P> solid;
  std::uint8_t* beside;

  KERF_FUNCTION void operator()(Index i) const {
    if (!solid.changed[i] || !solid.detached[i]) return;
    set_flag(beside[i]);
    for (Index k = solid.bonds.first(i); k < solid.bonds.last(i); ++k)
      if (solid.is_intact(i, k)) set_flag(beside[solid.bond_end(i, k).particle]);
  }
};

// Breaks all bonds of detached particles from both ends; `beside` is cleared.
template <int D, class P>
struct BreakBesideDetached {
  BreakAllBonds<D, P> break_all;
  std::uint8_t* beside;

  KERF_FUNCTION void operator()(Index i) const {
    if (!beside[i]) return;
    beside[i] = 0;
    break_all(i);
  }
};

template <int D, class P>
class CorrectionUpdate {
 public:
  // `halo`: of several ranks. `sums` has the moments of the bonds.
  void operator()(SolidFields<D, P>& fields, const BondHalo<D>& halo,
                  const BreakRecords<D, P>& records, const SimdBondSums<D, P>& sums) {
    const SolidView<D, P> solid = fields.view();
    beside_.resize(solid.count, std::uint8_t(0));
    correct(solid, sums);
    while (any_changed(solid)) {
      for_each_index(solid.share, MarkBesideDetached<D, P>{solid, pointer(beside_)});
      if constexpr (ranks::exist)
        if (solid.share.is_part) {
          halo.to_owners(beside_);
          halo.to_ghosts(fields.detached);
        }
      for_each_index(solid.share,
                     BreakBesideDetached<D, P>{{solid, solid.detached, records}, pointer(beside_)});
      correct(solid, sums);
    }
  }
  static bool any_changed(const SolidView<D, P>& solid) {
    const bool own = reduce_unordered(solid.share, IsSet{solid.changed}, false, Either{});
    return solid.share.is_part ? ranks::any(own) : own;
  }
  std::size_t bytes() const { return beside_.size(); }

 private:
  void correct(const SolidView<D, P>& solid, const SimdBondSums<D, P>& sums) {
    // No mark is set at this time, so that their memory serves for what is left out.
    for_each_index(solid.share, PrepareCorrection<D, P>{solid, pointer(beside_)});
    sums.sum_moments(solid, Correct<D, P>{solid}, pointer(beside_));
    thrust::fill(loop_policy(), beside_.begin(), beside_.end(), std::uint8_t(0));
  }

  Array<std::uint8_t> beside_;  // marks of MarkBesideDetached
};

}  // namespace kerf
