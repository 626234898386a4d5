// SPDX-License-Identifier: Apache-2.0
// This criterion compares the largest principal Kirchhoff stress with the tensile strength f_t
// (Rankine's criterion). Where a particle passes it, the bonds break that are opening
// (bond_strain.hpp) and stretched by at least a quarter of f_t / E, so that those along the crack
// hold. A bond whose own strain is above f_t / (2 G) breaks too: in a uniform tension or shear its
// particles pass no later. It is what breaks a solid that is squeezed and spreads, in a uniaxial
// compressive test at f_t (1 + nu) / nu (cf. Stacey, Int. J. Rock Mech. Min. Sci. 18 (1981) 469).
// The energy that a crack takes is in proportion to the spacing; only a fracture_energy makes it
// the material's.
#pragma once

#include <string_view>
#include <vector>

#include "core/case_key.hpp"
#include "fracture/bond_strain.hpp"
#include "fracture/breakable_solid.hpp"
#include "fracture/crack_band.hpp"

namespace kerf {

template <class T>
struct PrincipalStress {
  T tensile_strength = 0;  // f_t, Pa; 0 = never breaks

  static constexpr std::string_view sentence =
      "The largest principal stress, Kirchhoff's, passes the tensile_strength";
  static constexpr CriterionKeys keys{StrainOrEnergy::neither, false, "the stress"};
  static constexpr AcrossJoint across_joint = AcrossJoint::stress;
  static std::vector<Key> rows() {
    return {{"tensile_strength",
             ValueKind::quantity,
             "Pa",
             "",
             key_range::positive,
             {},
             "",
             "Largest principal stress that it bears",
             stored_in<&PrincipalStress<double>::tensile_strength>}};
  }
  static FractureLimits limits(const FractureInput&) { return {}; }
  KERF_FUNCTION bool can_break(bool) const { return tensile_strength > T(0); }

  KERF_FUNCTION T tensile_limit(const BreakableSolid<T>& solid) const {
    return tensile_strength / solid.young_modulus();
  }
  KERF_FUNCTION void strengthen(T factor) { tensile_strength *= factor; }

  // Pa.
  template <class Particle>
  KERF_FUNCTION T prepare(const Particle& particle) const {
    return tensile_strength > T(0) ? particle.largest_stress() : T(0);
  }

  KERF_FUNCTION bool passes(T prepared, const BreakableSolid<T>&) const {
    return tensile_strength > T(0) && prepared > tensile_strength;
  }

  KERF_FUNCTION bool breaks(const BondStrain<T>& bond, const BreakableSolid<T>& solid) const {
    if (!(tensile_strength > T(0))) return false;
    if (is_above(bond.own, tensile_strength / (T(2) * solid.shear_modulus))) return true;
    const T part = T(0.25) * tensile_strength / solid.young_modulus();
    return passes(bond.prepared, solid) && bond.mean > T(2) * part && bond.is_opening();
  }

  template <class Other>
  KERF_FUNCTION static PrincipalStress from(const PrincipalStress<Other>& other) {
    return {static_cast<T>(other.tensile_strength)};
  }
  bool operator==(const PrincipalStress&) const = default;
};

}  // namespace kerf
