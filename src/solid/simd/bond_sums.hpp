// SPDX-License-Identifier: Apache-2.0
// SimdBondSums runs the SIMD kernels over bonds for all particles whose bonds are within one body
// and to no mirror image; on a GPU solid/packed_bond_loop.hpp takes their place. The general loops
// (solid/deformation_gradient.hpp, solid/bond_force.hpp) compute the other particles.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "simd/run_in_blocks.hpp"
#include "solid/packed_bond_loop.hpp"
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
    can_break_ = can_break;
    has_levels_ = !layout.body.empty();
    if constexpr (simd_exists) kernels_ = bond_kernels().template get<D, Real>();
    double longest = 0.0;  // m, of bonds
    std::vector<BondLaw<Real>> laws;
    for (const auto& medium : layout.media) {
      laws.push_back(law_of(medium));
      longest = std::max(longest, 2.0 * medium.smoothing_length);
    }
    to_device(laws, laws_);
    unit_ = FixedPointScale<Real>::of_spacing(longest / 16.0);  // differences up to eight bonds
    for_each_index(solid.count, PackReferences{solid, unit_});
    shared_entries_ = bonds.shared;
    SharedNumbers shared;
    for (auto& numbers : shared) numbers.assign(bonds.shared, Real(0));
    for (const Index i : bonds.owner)
      set_shared_bonds(i, layout, bonds, laws[layout.medium_index[i]].scale, shared);
    if constexpr (simd_exists)
      for (std::size_t n = 0; n < shared.size(); ++n) to_device(shared[n], shared_[n]);
    else
      set_shared_records(bonds, shared);
  }

  std::size_t bytes() const {
    return shared_entries_ * (D + 2) * sizeof(Real) + end_parts_.size() * sizeof(RecordPart);
  }

  // Calls `loop`, a Deform, for all particles with their sums at the current displacements.
  template <class Loop>
  void sum_gradients(const SolidView<D, P>& solid, const Loop& loop) const {
    run<BondGradientSum>(solid, kernels_.sum_gradients, loop, false);
  }
  // Calls `loop`, a Correct, for all particles with their moments, which those that `left_out`
  // marks lack.
  template <class Loop>
  void sum_moments(const SolidView<D, P>& solid, const Loop& loop,
                   const std::uint8_t* left_out) const {
    run<BondMoments>(solid, kernels_.sum_moments, loop, false, left_out);
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
  // R, w and 1 / R of the bonds of shared lists (SharedBonds).
  static constexpr std::size_t weight_at = D, per_length_at = D + 1;
  using SharedNumbers = std::array<std::vector<Real>, D + 2>;

  // Sets the bonds of a shared list to those of its owner, rounded to fixed-point coordinates, so
  // that they are the same in both directions but for their sign.
  void set_shared_bonds(Index i, const SolidLayout<D>& layout, const StoredBonds& bonds,
                        const BondScale<Real>& scale, SharedNumbers& shared) const {
    for (Index k = bonds.begin[i]; k < bonds.begin[i] + bonds.count[i]; ++k) {
      const auto difference = layout.reference[i + bonds.entry[k]] - layout.reference[i];
      Vector<D, Real> bond;
      for (int a = 0; a < D; ++a)
        shared[static_cast<std::size_t>(a)][k] = bond[a] = unit_.rounded(difference[a]);
      shared[weight_at][k] = scale.weight(norm(bond));
      shared[per_length_at][k] = Real(1) / norm(bond);
    }
  }
  void set_shared_records(const StoredBonds& bonds, const SharedNumbers& shared) {
    std::vector<SharedBond<D, Real>> records(bonds.shared);
    for (Index k = 0; k < bonds.shared; ++k) {
      for (std::size_t a = 0; a < D; ++a) records[k].bond[a] = shared[a][k];
      records[k].weight = shared[weight_at][k];
      records[k].per_length = shared[per_length_at][k];
      records[k].entry = static_cast<std::int32_t>(bonds.entry[k]);
    }
    to_device(records, shared_records_);
  }
  static BondLaw<Real> law_of(const Medium<double>& medium) {
    return {BondScale<Real>::template of<D>(medium, medium),
            {static_cast<Real>(medium.density), static_cast<Real>(medium.smoothing_length),
             static_cast<Real>(medium.artificial_linear * medium.bond_wave_speed()),
             static_cast<Real>(medium.artificial_quadratic)},
            hourglass_of_pair(Medium<Real>::from(medium))};
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
    BondKernelTask<D, Real, Result> task;
    task.ends = solid.ends;
    task.begin = solid.bonds.begin;
    task.count = solid.bonds.count;
    task.entry = reinterpret_cast<const std::int32_t*>(solid.bonds.entry);
    task.shared_entries = shared_entries_;
    for (std::size_t a = 0; a < D; ++a) task.shared.bond[a] = pointer(shared_[a]);
    task.shared.weight = pointer(shared_[weight_at]);
    task.shared.per_length = pointer(shared_[per_length_at]);
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
    task.laws = pointer(laws_);
    task.breakable = can_break_;
    task.viscous = viscous;
    task.unit = static_cast<Real>(unit_.unit);
    using Sum = Result<D, Real>;
    if constexpr (simd_exists) {
      run_in_blocks<Sum>(task, kernel, solid.share, loop);
    } else {
      using PackedLoop = PackedBondLoop<D, Real>;
      constexpr std::uint32_t parts = std::is_same_v<Sum, BondForceSum<D, Real>>
                                          ? PackedLoop::parts_of_force
                                          : PackedLoop::parts_of_geometry;
      end_parts_.resize(std::size_t(PackedLoop::parts_of_force) * solid.count);
      task.end_parts = pointer(end_parts_);
      task.shared_records = pointer(shared_records_);
      task.ends_count = solid.count;
      for_each_index(solid.count, SplitRecords<PackedBondEnd<D, Real>>{solid.ends, solid.count,
                                                                       parts, pointer(end_parts_)});
      for_each_index(solid.count,
                     SumBondsThen<BondKernelTask<D, Real, Result>, Sum, Loop>{task, loop});
    }
  }

  BondKernelsOf<D, Real> kernels_{};
  FixedPointScale<Real> unit_{};
  Array<BondLaw<Real>> laws_;
  mutable Array<RecordPart> end_parts_;  // of a GPU's loops
  Index shared_entries_ = 0;
  std::array<Array<Real>, D + 2> shared_;      // SharedNumbers of them
  Array<SharedBond<D, Real>> shared_records_;  // instead of these, on a GPU
  bool can_break_ = false, has_levels_ = false;
};

}  // namespace kerf
