// SPDX-License-Identifier: Apache-2.0
// PackedBondLoop sums over the bonds of a particle from packed records, with one thread per
// particle: on a GPU it takes the place of the SIMD kernels (solid/simd/bond_kernel.hpp), with the
// same formulas, of solid/bond_terms.hpp and solid/bond_weight.hpp. Particles that share a list of
// bonds read it together.
#pragma once

#include "core/select.hpp"
#include "parallel/load_record.hpp"
#include "parallel/loops.hpp"
#include "simd/run_in_blocks.hpp"
#include "solid/simd/packed_bonds.hpp"

namespace kerf {

template <int D, class Real>
class PackedBondLoop {
  using End = PackedBondEnd<D, Real>;
  using Task = Bonds<D, Real>;
  struct Bond {
    BondGeometry<D, Real> geometry;
    Real per_length;   // 1 / R, 1/m
    Real mean_length;  // h, m, of both ends, where the body has levels
    bool is_shared;    // its list
  };

 public:
  // The parts of the other ends that the sums need, of 16 bytes each.
  static constexpr std::uint32_t parts_of_geometry = (2 * D * sizeof(Real) + 15) / 16,
                                 parts_of_force = (End::reference_slot * sizeof(Real) + 15) / 16;

  KERF_FUNCTION PackedBondLoop(const Task& task, Index i)
      : task_(task), i_(i), law_(task.laws[task.medium[i]]), own_(load_record(task.ends + i)) {}

  KERF_FUNCTION void sum(BondGradientSum<D, Real>& result) const {
    result = {Matrix<D, Real>::zero(), Real(0)};
    for_each_bond<parts_of_geometry>([&](const Bond& bond, const End&) {
      add_bond_gradient(result.sum, bond.geometry);
      if (!task_.breakable) return;
      const Real growth = square_growth(bond.geometry.reference, bond.geometry.change);
      const Real ratio = growth * bond.per_length * bond.per_length;
      if (bond.geometry.weight > Real(0)) result.stretch = maximum(result.stretch, ratio);
    });
  }
  KERF_FUNCTION void sum(BondMisfitSum<D, Real>& result) const {
    const Matrix<D, Real> gradient = task_.gradient[i_];
    result = {Real(0)};
    for_each_bond<parts_of_geometry>([&](const Bond& bond, const End&) {
      Real square(0);
      for (int a = 0; a < D; ++a) {
        Real gamma = -bond.geometry.change[a];
        for (int b = 0; b < D; ++b) gamma += gradient(a, b) * bond.geometry.reference[b];
        square += gamma * gamma;
      }
      result.misfit += bond.geometry.weight * square;
    });
  }
  KERF_FUNCTION void sum(BondMoments<D, Real>& result) const {
    result = {Matrix<D, double>::zero(), Matrix<D, double>::zero()};
    const Real hourglass = law_.hourglass;
    for_each_bond<parts_of_geometry>([&](const Bond& bond, const End&) {
      const auto& [reference, change, weight] = bond.geometry;
      add_bond_moments(result, reference, weight * reference, weight * hourglass, hourglass);
    });
  }
  KERF_FUNCTION void sum(BondForceSum<D, Real>& result) const {
    result = {Vector<D, Real>::zero(), Real(0)};
    for_each_bond<parts_of_force>([&](const Bond& bond, const End& other) {
      add_bond_force(result.force, bond.geometry, own_.traction + other.traction,
                     own_.hourglass + other.hourglass);
      if (!task_.viscous) return;
      auto law = law_.viscosity;
      if (!bond.is_shared && task_.has_levels) law.length = bond.mean_length;
      add_bond_viscosity(result.force, result.power, bond.geometry, other.velocity - own_.velocity,
                         bond.per_length, law);
    });
  }

 private:
  // Calls body(bond, other end) for all bonds; broken ones have no weight. Only the first `parts`
  // of the other end are loaded.
  template <std::uint32_t parts, class Body>
  KERF_FUNCTION void for_each_bond(const Body& body) const {
    const Index begin = task_.begin[i_], count = task_.count[i_];
    const std::uint32_t* intact =
        task_.has_broken_bonds[i_] ? task_.bond_intact + i_ * task_.words : nullptr;
    const bool is_shared = begin < task_.shared_entries;
    for (Index n = 0; n < count; ++n) {
      const Index k = begin + n;
      End other;
      Bond bond;
      bond.is_shared = is_shared;
      Index j = i_;
      if (is_shared) {
        const SharedBond<D, Real> known = load_record(task_.shared_records + k);
        j += known.entry;
        for (int a = 0; a < D; ++a) bond.geometry.reference[a] = known.bond[a];
        bond.geometry.weight = known.weight;
        bond.per_length = known.per_length;
      } else {
        j += task_.entry[k];
        take_reference(k, task_.ends[j], bond);
      }
      load_parts<parts>(task_.end_parts, task_.ends_count, j, other);
      if (intact != nullptr && ((intact[n / bonds_per_word] >> (n % bonds_per_word)) & 1u) == 0)
        bond.geometry.weight = Real(0);
      for (int a = 0; a < D; ++a)
        bond.geometry.change[a] = displacement_difference(
            own_.displacement[a], own_.remainder[a], other.displacement[a], other.remainder[a]);
      body(bond, other);
    }
  }
  KERF_FUNCTION void take_reference(Index k, const End& end, Bond& bond) const {
    auto& reference = bond.geometry.reference;
    Real square(0);
    for (int a = 0; a < D; ++a) {
      reference[a] =
          task_.unit * static_cast<Real>(wrapping_difference(end.reference[a], own_.reference[a]));
      square += reference[a] * reference[a];
    }
    bond.per_length = reciprocal_square_root(select(square > Real(0), square, Real(1)));
    const Real distance = square * bond.per_length;
    bond.mean_length = Real(0.5) * (own_.length + end.length);
    bond.geometry.weight = task_.has_levels
                               ? weight_of_levels<D>(law_.scale, end.length / own_.length, distance)
                               : law_.scale.weight(distance);
    if (task_.correction != nullptr) bond.geometry.weight *= task_.correction[k];
  }

  const Task& task_;
  Index i_;
  const BondLaw<Real>& law_;
  End own_;
};

// Sums over the bonds of each particle whose bonds are all within one body, and calls the loop that
// uses these sums.
template <class Task, class Result, class Loop>
struct SumBondsThen {
  Task task;
  Loop loop;

  KERF_FUNCTION void operator()(Index i) const {
    if (task.several_bodies[i]) return loop(i);
    Result result{};
    if (!task.detached[i] && !task.asleep[i]) PackedBondLoop(task.bonds(), i).sum(result);
    Loop with_sums = loop;
    with_sums.take(BlockResults<Result>{&result, i});
    with_sums(i);
  }
};

}  // namespace kerf
