// SPDX-License-Identifier: Apache-2.0
// BreakTerms sums the energy that is released when bonds break. The energy that a particle stores
// depends on its own bonds and on the motion of others, but not on the bonds of others. So only
// particles that lose bonds are counted: before the first breaks, and after the last.
//
// Bonds break by the deformation in the middle of a step of the solid, and the whole kick of the
// step is without them, as if they had broken at its start. What they release is therefore what the
// particle stored at the start of the step, with its bonds less without them.
#pragma once

#include "solid/update_plasticity.hpp"
#include "solid/update_softening.hpp"

namespace kerf {

// What a particle holds at two instants of a step of the solid, J (2D: J/m).
struct BreakEnergy {
  double start;   // stored at the start of the step; `middle` where there is no step
  double middle;  // stored at the current deformation, and dissipated since the start of the step

  KERF_FUNCTION double less() const { return start < middle ? start : middle; }
};

// Returns what a particle stored at the start of the step, `half_step` ago, s.
template <int D, class P>
KERF_FUNCTION double stored_at_start(const SolidView<D, P>& solid, Index i, double half_step) {
  if (solid.detached[i]) return 0.0;
  return energy_of(solid, i, earlier_gradient(solid, i, half_step),
                   EnergyState<D, P>::at_start(solid, i), half_step)
      .total();
}

// Returns what particle i holds.
template <int D, class P>
KERF_FUNCTION BreakEnergy break_energy_of(const SolidView<D, P>& solid, Index i, double half_step) {
  const double softening =
      solid.detached[i] ? 0.0 : softening_work_of(solid, i) - softening_work_at_start(solid, i);
  const double middle = energy_of(solid, i).total() + flow_work_of(solid, i) + softening;
  return {half_step > 0.0 ? stored_at_start(solid, i, half_step) : middle, middle};
}

// Returns what particle i would hold if it had not softened in this step. It is proportional to the
// share s, and no less than what it holds: as k grows, what softening dissipates is less than what
// is stored no more.
template <int D, class P>
KERF_FUNCTION BreakEnergy most_break_energy_of(const SolidView<D, P>& solid, Index i,
                                               double half_step) {
  auto state = EnergyState<D, P>::now(solid, i);
  state.strain = EnergyState<D, P>::at_start(solid, i).strain;
  const double middle =
      energy_of(solid, i, Matrix<D, double>::from(solid.gradient[i]), state).total() +
      flow_work_of(solid, i);
  return {half_step > 0.0 ? stored_at_start(solid, i, half_step) : middle, middle};
}

// The state of a particle before its first bond breaks in this step.
struct BondBreakRecord {
  BreakEnergy energy;
  Index bonds;
  std::uint8_t detached, is_recorded;
};

template <int D, class P>
struct BreakRecords {
  BondBreakRecord* of = nullptr;  // per particle; null: not recorded
  double half_step = 0.0;         // s, since the start of the step

  // Must be called before a bond of particle i breaks, or it becomes detached.
  KERF_FUNCTION void record(const SolidView<D, P>& solid, Index i) const {
    if (of == nullptr || of[i].is_recorded) return;
    of[i] = {break_energy_of(solid, i, half_step), solid.intact_bonds(i), solid.detached[i], 1};
  }
};

// Sums the broken bonds, counted from both ends; the particles that became detached; the released
// energy, J. It clears the records, but for the energies.
template <int D, class P>
struct BreakTerms {
  SolidView<D, P> solid;
  BreakRecords<D, P> records;

  KERF_FUNCTION void add(Index i, Terms<3>& sum) const {
    auto& before = records.of[i];
    if (!before.is_recorded) return;
    before.is_recorded = 0;
    sum.value[0] += before.bonds - solid.intact_bonds(i);
    sum.value[1] += solid.detached[i] - before.detached;
    sum.value[2] += before.energy.start - break_energy_of(solid, i, records.half_step).start;
  }
};

}  // namespace kerf
