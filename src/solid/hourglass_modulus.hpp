// SPDX-License-Identifier: Apache-2.0
// The hourglass control resists the motion that a particle's gradient does not represent, with a
// modulus mu = zeta E. Where the material flows that motion is flow too: mu falls like the secant
// modulus of a shear test, and further,  mu = zeta E / (1 + 5 eps_p / eps_y),  eps_y = sigma_0 / (3
// G). Where it softens, mu falls with the square of the remaining share, so that the control does
// not close a crack. Where cracks grow from flaws it falls with damage; a tenth is left for
// compression. It has the share s of the elastic response that breaks leave
// (solid/limit_break_energy.hpp). The excess of the control's energy is dissipated. The force is in
// solid/bond_force.hpp.
// At the surface of the layout mu has a factor
//   b_i = 1 + 4.5 (G / E) min(1, max(0, tr B_i / D - 1)),
// B_i the correction of solid/gradient_correction.hpp with all bonds: a gradient that is fitted to
// neighbours on one side takes the strain of bending from below the surface, and the control makes
// up for it there (docs/theory/total_lagrangian.md). b never changes, so that the force remains the
// gradient of the energy. Where bonds can break b = 1: more control would hold cracks that reach a
// surface.
#pragma once

#include "solid/stored_energy.hpp"

namespace kerf {

inline constexpr double surface_control_gain = 4.5;  // b - 1 per G / E

template <class T>
KERF_FUNCTION T flowing_hourglass(const Medium<T>& medium, const PlasticParameters<T>& parameters,
                                  T plastic_strain) {
  const T first_strain = parameters.first_strength() / (T(3) * medium.shear_modulus);
  return first_strain > T(0)
             ? medium.hourglass_modulus() * (first_strain / (first_strain + T(5) * plastic_strain))
             : T(0);
}

// Returns mu of the state at the start of a step, Pa.
template <int D, class P>
KERF_FUNCTION typename P::Real hourglass_of(const SolidView<D, P>& solid, Index i) {
  using Real = typename P::Real;
  const auto& medium = solid.medium(i);
  const Real share = solid.elastic_share[i] * solid.surface_control[i];
  if (solid.flows(i))
    return share *
           flowing_hourglass(medium, solid.plasticity(i), solid.flow_start[i].plastic_strain);
  if (solid.softens(i)) {
    const Real undamaged = undamaged_share(medium, solid.strain_start[i]);
    return share * undamaged * undamaged * medium.hourglass_modulus();
  }
  return share * medium.hourglass_modulus() * (Real(1) - Real(0.9) * solid.damage(i));
}

template <int D, class P>
struct SetHourglassModulus {
  SolidView<D, P> solid;
  KERF_FUNCTION void operator()(Index i) const { solid.ends[i].hourglass = hourglass_of(solid, i); }
};

// Sets b, and mu with it, from the corrections of a layout whose bonds are all intact.
template <int D, class P>
struct SetSurfaceControl {
  using Real = typename P::Real;
  SolidView<D, P> solid;

  KERF_FUNCTION void operator()(Index i) const {
    const auto& medium = solid.medium(i);
    if (solid.detached[i] || medium.can_break()) return;
    double trace = 0.0;
    for (int a = 0; a < D; ++a) trace += double(solid.correction[i](a, a));
    const double mean = double(medium.reference_volume()) * trace / D;
    const double missing = mean < 1.0 ? 0.0 : mean > 2.0 ? 1.0 : mean - 1.0;
    const double gain =
        surface_control_gain * double(medium.shear_modulus / medium.young_modulus());
    solid.surface_control[i] = static_cast<Real>(1.0 + gain * missing);
    solid.ends[i].hourglass = hourglass_of(solid, i);
  }
};

// Lowers mu to the value of the state at the end of a step, which is that at the start of the next.
// Returns the energy that the hourglass control loses, J (2D: J/m).
template <int D, class P>
KERF_FUNCTION double lower_hourglass(const SolidView<D, P>& solid, Index i) {
  const auto modulus = hourglass_of(solid, i);
  if (!(modulus < solid.ends[i].hourglass)) return 0.0;
  const double lost = 0.5 * double(solid.ends[i].hourglass - modulus) * misfit(solid, i);
  solid.ends[i].hourglass = modulus;
  return lost;
}

}  // namespace kerf
