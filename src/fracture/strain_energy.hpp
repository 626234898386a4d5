// SPDX-License-Identifier: Apache-2.0
// This criterion compares the energy that tension stores per volume,
//   psi_+ = (K - 2/3 G)/2 <tr e>^2 + G sum <e_k>^2,   <x> = max(x, 0),   e = ln(C)/2
// (Miehe, Hofacker & Welschinger, Comput. Methods Appl. Mech. Engrg. 199 (2010) 2765), with that of
// a crack over the crack band,  psi_+ w d = Gc  (crack_band.hpp), or, in terms of the failure
// strain that stands for it, M limit^2 / 2. Bonds break that are opening (bond_strain.hpp) with at
// least a quarter of that strain. A bond whose own strain is above the limit breaks too: in a
// uniform strain its particles pass no later.
#pragma once

#include <cmath>
#include <string_view>

#include "fracture/bond_strain.hpp"
#include "fracture/breakable_solid.hpp"
#include "fracture/crack_band.hpp"

namespace kerf {

template <class T>
struct StrainEnergy {
  static constexpr std::string_view sentence =
      "The energy that tension stores passes that of a crack over its band";
  static constexpr CriterionKeys keys{};
  static FractureLimits limits(const FractureInput& input) { return brittle_limits(input); }
  KERF_FUNCTION bool can_break(bool has_limit) const { return has_limit; }

  // sqrt(2 psi_+ / M): the uniaxial strain that stores as much.
  template <class Particle>
  KERF_FUNCTION T prepare(const Particle& particle) const {
    if (!(particle.solid.failure_strain > T(0))) return T(0);
    const auto law = TensionLaw<T>::of(particle.solid);
    const T twice = T(2) * law.energy(principal_values(particle.green));
    return twice > T(0) ? std::sqrt(twice / (law.lame + T(2) * law.shear)) : T(0);
  }

  KERF_FUNCTION bool passes(T prepared, const BreakableSolid<T>& solid) const {
    return solid.fails_at(prepared);
  }

  KERF_FUNCTION bool breaks(const BondStrain<T>& bond, const BreakableSolid<T>& solid) const {
    return is_above(bond.own, solid.failure_strain) ||
           (passes(bond.prepared, solid) && bond.mean > T(0.5) * solid.failure_strain &&
            bond.is_opening());
  }

  template <class Other>
  KERF_FUNCTION static StrainEnergy from(const StrainEnergy<Other>&) {
    return {};
  }
  bool operator==(const StrainEnergy&) const = default;
};

}  // namespace kerf
