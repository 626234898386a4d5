// SPDX-License-Identifier: Apache-2.0
// CrackBandStrain is the criterion crack_band: the stress softens over a crack band
// (softening.hpp), whose strains e_0 and e_f follow from the fracture energy (crack_band.hpp).
// A bond breaks in two cases. Its own strain has reached the end of softening e_f: a crack opens in
// one bond, and the particles beside it have about half of its strain. Or the tensile strain of its
// particles has passed e_f, so that they carry no stress, and the bond is opening (bond_strain.hpp)
// with at least a quarter of that strain.
#pragma once

#include <string_view>

#include "fracture/bond_strain.hpp"
#include "fracture/breakable_solid.hpp"
#include "fracture/crack_band.hpp"

namespace kerf {

template <class T>
struct CrackBandStrain {
  static constexpr std::string_view sentence =
      "Stress softens from the failure_strain on, over a band that takes the fracture_energy";
  static constexpr CriterionKeys keys{StrainOrEnergy::both, true, ""};
  static constexpr bool softens = true;
  // With the modulus E that bonds carry.
  static FractureLimits limits(const FractureInput& input) {
    return softening_law_of(input.fracture_energy, carried_youngs_modulus(input.moduli),
                            input.failure_strain, input.spacing);
  }
  KERF_FUNCTION bool can_break(bool has_limit) const { return has_limit; }

  // The tensile strain k = sqrt(2 psi_t / E); of a solid that softens, the largest so far.
  template <class Particle>
  KERF_FUNCTION T prepare(const Particle& particle) const {
    return particle.tensile_strain();
  }

  KERF_FUNCTION bool passes(T prepared, const BreakableSolid<T>& solid) const {
    return solid.fails_at(prepared);
  }

  KERF_FUNCTION bool breaks(const BondStrain<T>& bond, const BreakableSolid<T>& solid) const {
    const T end = solid.failure_strain;  // e_f, the end of softening
    if (!(end > T(0))) return false;
    return bond.own > end * (T(2) + end) ||
           (passes(bond.prepared, solid) && bond.mean > T(0.5) * end && bond.is_opening());
  }

  template <class Other>
  KERF_FUNCTION static CrackBandStrain from(const CrackBandStrain<Other>&) {
    return {};
  }
  bool operator==(const CrackBandStrain&) const = default;
};

}  // namespace kerf
