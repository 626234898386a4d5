// SPDX-License-Identifier: Apache-2.0
// The hourglass control resists what a particle's gradient does not see, with a modulus mu =
// zeta E. Where the material flows that is flow too, and as soft: mu falls like the secant of a
// test in shear, and further,  mu = zeta E / (1 + 5 eps_p / eps_y),  eps_y = sigma_0 / (3 G). Where
// it softens, mu falls with the square of what is left, so that the control does not hold a crack
// together. Where cracks grow from flaws it falls with damage; a tenth is left for what is pressed
// together. The energy that the control then holds too much of is dissipated.
#pragma once

#include "solid/stored_energy.hpp"

namespace kerf {

template <class T>
KERF_FUNCTION T flowing_hourglass(const SolidMedium<T>& medium,
                                  const PlasticParameters<T>& parameters, T plastic_strain) {
  const T first_strain = parameters.first_strength() / (T(3) * medium.shear_modulus);
  return first_strain > T(0)
             ? medium.hourglass_modulus() * (first_strain / (first_strain + T(5) * plastic_strain))
             : T(0);
}

// mu of the state at the start of a step, Pa.
template <int D, class P>
KERF_FUNCTION typename P::Real hourglass_of(const SolidView<D, P>& solid, Index i) {
  using Real = typename P::Real;
  const auto& medium = solid.medium(i);
  if (solid.flows(i))
    return flowing_hourglass(medium, solid.plasticity(i), solid.flow_start[i].plastic_strain);
  if (solid.softens(i)) {
    const Real whole = whole_share(medium, solid.strain_start[i]);
    return whole * whole * medium.hourglass_modulus();
  }
  return medium.hourglass_modulus() * (Real(1) - Real(0.9) * solid.damage(i));
}

template <int D, class P>
struct SetHourglassModulus {
  SolidView<D, P> solid;
  KERF_FUNCTION void operator()(Index i) const { solid.ends[i].hourglass = hourglass_of(solid, i); }
};

// Once the state of a step's end is that of the next one's start: mu falls to what that allows. The
// energy that it held too much of, J (2D: J/m).
template <int D, class P>
KERF_FUNCTION double lower_hourglass(const SolidView<D, P>& solid, Index i) {
  const auto modulus = hourglass_of(solid, i);
  if (!(modulus < solid.ends[i].hourglass)) return 0.0;
  const double lost = 0.5 * double(solid.ends[i].hourglass - modulus) * misfit(solid, i);
  solid.ends[i].hourglass = modulus;
  return lost;
}

}  // namespace kerf
