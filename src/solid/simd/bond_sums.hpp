// SPDX-License-Identifier: Apache-2.0
// SimdBondSums runs the SIMD kernels over bonds for all particles whose bonds are within one body
// and to no mirror image. The general loops (solid/deformation_gradient.hpp, solid/bond_force.hpp)
// compute the other particles, and on a GPU all.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "simd/run_in_blocks.hpp"
#include "solid/share_lists.hpp"
#include "solid/simd/bond_kernels.hpp"
#include "solid/solid_fields.hpp"
#include "solid/stored_energy.hpp"

namespace kerf {

template <int D, class P>
class SimdBondSums {
 public:
  using Real = typename P::Real;

  void set_up(const SolidLayout<D>& layout, const StoredBonds& bonds, const SolidView<D, P>& solid,
              bool can_break) {
    if constexpr (!simd_exists) return;
    can_break_ = can_break;
    has_levels_ = !layout.body.empty();
    kernels_ = bond_kernels().template get<D, Real>();
    double longest = 0.0;  // m, of bonds
    for (const auto& medium : layout.media) {
      laws_.push_back(law_of(medium));
      longest = std::max(longest, 2.0 * medium.smoothing_length);
    }
    unit_ = FixedPointScale<Real>::of_spacing(longest / 16.0);  // differences up to eight bonds
    for_each_index(solid.count, PackReferences{solid, unit_});
    shared_entries_ = bonds.shared;
    for (std::vector<Real>* numbers : all_shared()) numbers->assign(bonds.shared, Real(0));
    for (const Index i : bonds.owner) set_shared_bonds(i, layout, solid);
  }

  std::size_t bytes() const { return shared_entries_ * (D + 2) * sizeof(Real); }

  // Calls `loop`, a Deform, for all particles with their sums at the current displacements.
  template <class Loop>
  void sum_gradients(const SolidView<D, P>& solid, const Loop& loop) const {
    run<BondGradientSum>(solid, kernels_.sum_gradients, loop, false);
  }
  // Calls `loop`, a BondForce, for all particles with their sums over all bonds.
  template <class Loop>
  void sum_forces(const SolidView<D, P>& solid, const Loop& loop, bool viscous) const {
    run<BondForceSum>(solid, kernels_.sum_forces, loop, viscous);
  }
  // Calls `loop`, a KeepMisfit, for all particles with their sums at the current deformation, which
  // those that it leaves out lack.
  void sum_misfits(const SolidView<D, P>& solid, const KeepMisfit<D, P>& loop) const {
    run<BondMisfitSum>(solid, kernels_.sum_misfits, loop, false, loop.left_out);
  }

 private:
  // Sets the bonds of a shared list to those of its owner, rounded to fixed-point coordinates, so
  // that they are the same in both directions but for their sign.
  void set_shared_bonds(Index i, const SolidLayout<D>& layout, const SolidView<D, P>& solid) {
    const auto& scale = laws_[layout.medium_index[i]].scale;
    for (Index k = solid.bonds.first(i); k < solid.bonds.last(i); ++k) {
      const auto difference = layout.reference[solid.bonds.end(i, k)] - layout.reference[i];
      Vector<D, Real> bond;
      for (int a = 0; a < D; ++a) bond_[a][k] = bond[a] = unit_.rounded(difference[a]);
      weight_[k] = scale.weight(norm(bond));
      per_length_[k] = Real(1) / norm(bond);
    }
  }
  std::vector<std::vector<Real>*> all_shared() {
    std::vector<std::vector<Real>*> all{&weight_, &per_length_};
    for (auto& numbers : bond_) all.push_back(&numbers);
    return all;
  }
  static BondLaw<Real> law_of(const Medium<double>& medium) {
    return {BondScale<Real>::template of<D>(medium, medium),
            {static_cast<Real>(medium.density), static_cast<Real>(medium.smoothing_length),
             static_cast<Real>(medium.artificial_linear * medium.bond_wave_speed()),
             static_cast<Real>(medium.artificial_quadratic)}};
  }

 public:  // nvcc has no loop bodies that are private
  struct PackReferences {
    SolidView<D, P> solid;
    FixedPointScale<Real> unit;

    KERF_FUNCTION void operator()(Index i) const {
      for (int a = 0; a < D; ++a) solid.ends[i].reference[a] = unit.pack(solid.reference[i][a]);
      solid.ends[i].length = solid.medium(i).smoothing_length;
    }
  };

 private:
  template <template <int, class> class Result, class Loop>
  void run(const SolidView<D, P>& solid, BondKernel<D, Real, Result> kernel, const Loop& loop,
           bool viscous, const std::uint8_t* left_out = nullptr) const {
    if constexpr (!simd_exists) {
      for_each_index(solid.count, loop);
    } else {
      BondKernelTask<D, Real, Result> task;
      task.ends = solid.ends;
      task.begin = solid.bonds.begin;
      task.count = solid.bonds.count;
      task.entry = reinterpret_cast<const std::int32_t*>(solid.bonds.entry);
      task.shared_entries = shared_entries_;
      for (int a = 0; a < D; ++a) task.shared.bond[a] = bond_[a].data();
      task.shared.weight = weight_.data();
      task.shared.per_length = per_length_.data();
      task.bond_intact = solid.bond_intact;
      task.words = solid.words;
      task.correction = solid.bond_correction;
      task.gradient = solid.gradient;
      task.several_bodies = solid.several_bodies;
      task.has_levels = has_levels_;
      task.detached = solid.detached;
      task.asleep = left_out != nullptr ? left_out : solid.asleep;
      task.has_broken_bonds = solid.has_broken_bonds;
      task.medium = solid.medium_index;
      task.laws = laws_.data();
      task.breakable = can_break_;
      task.viscous = viscous;
      task.unit = static_cast<Real>(unit_.unit);
      run_in_blocks<Result<D, Real>>(task, kernel, solid.count, loop);
    }
  }

  BondKernelsOf<D, Real> kernels_{};
  FixedPointScale<Real> unit_{};
  std::vector<BondLaw<Real>> laws_;
  Index shared_entries_ = 0;
  std::array<std::vector<Real>, D> bond_;  // of them, see SharedBonds
  std::vector<Real> weight_, per_length_;
  bool can_break_ = false, has_levels_ = false;
};

}  // namespace kerf
