// SPDX-License-Identifier: Apache-2.0
// The sums over bonds by way of lanes/, for all particles whose bonds are within one medium and to
// no mirror image: walks over the bonds several at a time. The same formulas as in deform.hpp and
// bond_force.hpp, which do the others, and on a GPU all.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "lanes/walk_in_blocks.hpp"
#include "lanes/walks.hpp"
#include "solid/share_lists.hpp"
#include "solid/solid_fields.hpp"

namespace kerf {

template <int D, class P>
class BondLanes {
 public:
  using Real = typename P::Real;

  void set_up(const SolidLayout<D>& layout, const StoredBonds& bonds, const SolidView<D, P>& solid,
              bool can_break) {
    if constexpr (!lanes_exist) return;
    can_break_ = can_break;
    walks_ = walks().template get<D, Real>();
    double longest = 0.0;  // m, of bonds
    for (const auto& medium : layout.media) {
      laws_.push_back(law_of(medium));
      longest = std::max(longest, 2.0 * medium.smoothing_length);
    }
    unit_ = PlaceUnit<Real>::of_spacing(longest / 16.0);  // differences up to eight bonds
    for_each_index(solid.count, PackReferences{solid, unit_});
    shared_entries_ = bonds.shared;
    for (std::vector<Real>* numbers : all_shared()) numbers->assign(bonds.shared, Real(0));
    for (const Index i : bonds.owner) measure(i, layout, solid);
  }

  std::size_t bytes() const { return shared_entries_ * (D + 2) * sizeof(Real); }

  // `loop` of deform.hpp for all particles, with the sums of the displacements in force.
  template <class Loop>
  void gather(const SolidView<D, P>& solid, const Loop& loop) const {
    run<BondGradient>(solid, walks_.gather_bonds, loop, false);
  }
  // `loop` of bond_force.hpp likewise, by all bonds.
  template <class Loop>
  void push(const SolidView<D, P>& solid, const Loop& loop, bool viscous) const {
    run<BondPush>(solid, walks_.push_bonds, loop, viscous);
  }

 private:
  // The bonds of a shared list, as its owner has them. Rounded to the unit of places, so that they
  // are the same in both directions but for their sign.
  void measure(Index i, const SolidLayout<D>& layout, const SolidView<D, P>& solid) {
    const auto& scale = laws_[layout.medium_index[i]].scale;
    for (Index k = solid.bonds.first(i); k < solid.bonds.last(i); ++k) {
      const auto apart = layout.reference[solid.bonds.end(i, k)] - layout.reference[i];
      Vector<D, Real> bond;
      for (int a = 0; a < D; ++a) bond_[a][k] = bond[a] = unit_.rounded(apart[a]);
      weight_[k] = scale.weight(norm(bond));
      per_length_[k] = Real(1) / norm(bond);
    }
  }
  std::vector<std::vector<Real>*> all_shared() {
    std::vector<std::vector<Real>*> all{&weight_, &per_length_};
    for (auto& numbers : bond_) all.push_back(&numbers);
    return all;
  }
  static BondLaw<Real> law_of(const SolidMedium<double>& medium) {
    return {BondScale<Real>::template of<D>(medium, medium), static_cast<Real>(medium.density),
            static_cast<Real>(medium.smoothing_length),
            static_cast<Real>(medium.artificial_linear * medium.longitudinal_speed()),
            static_cast<Real>(medium.artificial_quadratic)};
  }

 public:  // nvcc has no loop bodies that are private
  struct PackReferences {
    SolidView<D, P> solid;
    PlaceUnit<Real> unit;

    KERF_FUNCTION void operator()(Index i) const {
      for (int a = 0; a < D; ++a) solid.ends[i].reference[a] = unit.pack(solid.reference[i][a]);
    }
  };

 private:
  template <template <int, class> class Result, class Loop>
  void run(const SolidView<D, P>& solid, BondWalk<D, Real, Result> walk, const Loop& loop,
           bool viscous) const {
    if constexpr (!lanes_exist) {
      for_each_index(solid.count, loop);
    } else {
      BondWalkTask<D, Real, Result> task;
      task.ends = solid.ends;
      task.begin = solid.bonds.begin;
      task.count = solid.bonds.count;
      task.entry = reinterpret_cast<const std::int32_t*>(solid.bonds.entry);
      task.shared_entries = shared_entries_;
      for (int a = 0; a < D; ++a) task.shared.bond[a] = bond_[a].data();
      task.shared.weight = weight_.data();
      task.shared.per_length = per_length_.data();
      task.whole = solid.whole;
      task.words = solid.words;
      task.fit = solid.bond_fit;
      task.mixed = solid.mixed;
      task.loose = solid.loose;
      task.torn = solid.torn;
      task.medium = solid.medium_index;
      task.laws = laws_.data();
      task.breakable = can_break_;
      task.viscous = viscous;
      task.unit = static_cast<Real>(unit_.unit);
      walk_in_blocks<Result<D, Real>>(task, walk, solid.count, loop);
    }
  }

  WalksOf<D, Real> walks_{};
  PlaceUnit<Real> unit_{};
  std::vector<BondLaw<Real>> laws_;
  Index shared_entries_ = 0;
  std::array<std::vector<Real>, D> bond_;  // of them, see SharedBonds
  std::vector<Real> weight_, per_length_;
  bool can_break_ = false;
};

}  // namespace kerf
