// SPDX-License-Identifier: Apache-2.0
// LimitBreakEnergy keeps breaks from supplying energy. A particle that loses bonds gets another
// gradient, fitted over the bonds that are left, and this may store more than the one before: bonds
// that break are stretched, and those that are left tell more of what is compressed. So what it
// stores, and its forces with it, has a factor s, the share of the elastic response that is left:
//   E_i = s_i [V_i psi(F_i) + 1/2 mu_i sum_j w_ij |F_i R - x_ij|^2],
// 1 at first. At a break
//   s_i <- s_i min(1, E_before / E_after),
// E_before that before the break and E_after that after it, without a change of s_i. Between breaks
// s_i is constant, so that the forces remain the gradient of the energy. Only particles that lose
// bonds change what they store, so that the sum over all of them never rises
// (docs/theory/total_lagrangian.md).
#pragma once

#include <limits>

#include "fracture/unstretched_failure.hpp"
#include "solid/bond_break_energy.hpp"

namespace kerf {

// Calls `deform`, a Deform, for the particles that lost bonds; limits their share; and marks those
// as detached that fail in compression by the deformation over the remaining bonds.
template <int D, class P, class Loop>
struct LimitBreakEnergy {
  using Real = typename P::Real;
  Loop deform;
  BreakRecords<D, P> records;

  KERF_FUNCTION void operator()(Index i) const {
    const auto& solid = deform.solid;
    if (!records.of[i].is_recorded) return;
    deform(i);
    if (solid.detached[i]) return;
    if (fails_in_compression(solid.medium(i), solid.gradient[i])) {
      solid.detached[i] = 1;
      solid.changed[i] = 1;
      return;
    }
    const double left = share_left(i);
    if (!(left < 1.0)) return;
    // Rounded down, by more than the rounding of the share and of the modulus.
    const double less = 1.0 - 8.0 * double(std::numeric_limits<Real>::epsilon());
    solid.elastic_share[i] = static_cast<Real>(double(solid.elastic_share[i]) * left * less);
    solid.ends[i].hourglass = hourglass_of(solid, i);
    deform(i);
  }

 private:
  KERF_FUNCTION double share_left(Index i) const {
    const BreakEnergy before = records.of[i].energy;
    const BreakEnergy after = most_break_energy_of(deform.solid, i, records.half_step);
    const double start = ratio(before.start, after.start);
    const double middle = ratio(before.middle, after.middle);
    return start < middle ? start : middle;
  }
  KERF_FUNCTION static double ratio(double before, double after) {
    if (!(after > before)) return 1.0;
    return before > 0.0 ? before / after : 0.0;
  }
};

}  // namespace kerf
