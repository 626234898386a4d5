// SPDX-License-Identifier: Apache-2.0
// The hourglass control resists the motion that a particle's gradient does not represent, with a
// modulus mu = zeta E. Where the material flows that motion is flow too: mu falls like the secant
// modulus of a shear test, and further,  mu = zeta E / (1 + 5 eps_p / eps_y),  eps_y = sigma_0 / (3
// G). Where it softens, mu falls with the square of the remaining share, so that the control does
// not close a crack. Where cracks grow from flaws it falls with damage; a tenth is left for
// compression. It has the share s of the elastic response that breaks leave
// (solid/limit_break_energy.hpp). The excess of the control's energy is dissipated. The force is in
// solid/bond_force.hpp.
#pragma once

#include "solid/stored_energy.hpp"

namespace kerf {

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
  const Real share = solid.elastic_share[i];
  if (solid.flows(i))
    return share *
           flowing_hourglass(medium, solid.plasticity(i), solid.flow_start[i].plastic_strain);
  if (solid.softens(i)) {
    const Real undamaged = undamaged_share(medium, solid.softening_strain_at_start(i));
    return share * undamaged * undamaged * medium.hourglass_modulus();
  }
  return share * medium.hourglass_modulus() * (Real(1) - Real(0.9) * solid.damage(i));
}

template <int D, class P>
struct SetHourglassModulus {
  SolidView<D, P> solid;
  KERF_FUNCTION void operator()(Index i) const { solid.ends[i].hourglass = hourglass_of(solid, i); }
};

// Whether mu of the state at the end of a step, which is that at the start of the next, is lower.
template <int D, class P>
KERF_FUNCTION bool is_hourglass_falling(const SolidView<D, P>& solid, Index i) {
  return hourglass_of(solid, i) < solid.ends[i].hourglass;
}
// Lowers mu to that value. Returns the energy that the hourglass control loses at a `misfit`, J
// (2D: J/m).
template <int D, class P>
KERF_FUNCTION double lower_hourglass(const SolidView<D, P>& solid, Index i, double misfit) {
  const auto modulus = hourglass_of(solid, i);
  const double lost = 0.5 * double(solid.ends[i].hourglass - modulus) * misfit;
  solid.ends[i].hourglass = modulus;
  return lost;
}
template <int D, class P>
KERF_FUNCTION double lower_hourglass(const SolidView<D, P>& solid, Index i) {
  return is_hourglass_falling(solid, i) ? lower_hourglass(solid, i, misfit(solid, i)) : 0.0;
}

}  // namespace kerf
