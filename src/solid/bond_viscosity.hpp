// SPDX-License-Identifier: Apache-2.0
// bond_viscosity_between() gives the viscosity of bonds (solid/bond_terms.hpp) between two media.
#pragma once

#include <cmath>

#include "model/medium.hpp"
#include "solid/bond_terms.hpp"

namespace kerf {

// Between unlike media the impedances rho c and the densities have their harmonic means, as where
// a wave crosses an interface (fluid/riemann.hpp): the lighter end is damped at most twice as much
// as between its like, however heavy the other is.
template <class Real>
BondViscosityLaw<Real> bond_viscosity_between(const Medium<Real>& a, const Medium<Real>& b) {
  const auto harmonic = [](Real x, Real y) {
    return x + y > Real(0) ? Real(2) * x * (y / (x + y)) : Real(0);
  };
  const Real density = harmonic(a.density, b.density);
  const Real impedance = harmonic(a.density * a.bond_wave_speed(), b.density * b.bond_wave_speed());
  return {density, Real(0.5) * (a.smoothing_length + b.smoothing_length),
          std::sqrt(a.artificial_linear * b.artificial_linear) * (impedance / density),
          std::sqrt(a.artificial_quadratic * b.artificial_quadratic)};
}

}  // namespace kerf
