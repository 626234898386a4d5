// SPDX-License-Identifier: Apache-2.0
// BrittleBand is the criterion brittle_band, the brittle limit of the crack band for a material
// that gives a fracture energy and no strength. Its stress softens (softening.hpp) over the
// shortest span of strains that lets a crack run in any direction of the lattice (brittle_softening
// of crack_band.hpp).
//
// A crack opens in one of two ways, depending on how it lies in the lattice. Between two rows of
// particles one bond takes the whole opening, and the particles beside it see half of that as
// strain. Along a row the opening is shared by the bonds on its two sides, and the particles of the
// row see most of it. A bond breaks when it is opening (bond_strain.hpp) and
//   - its own strain has reached 0.9 e_f, or
//   - one of its ends has reached 0.7 e_f, and a quarter of e_f is along the bond.
// With these shares the crack takes the same energy either way, so that no direction is easier than
// another. Both are fitted: the test is tests/unit/solid/crack_direction_test.cpp.
#pragma once

#include <string_view>

#include "fracture/bond_strain.hpp"
#include "fracture/breakable_solid.hpp"
#include "fracture/crack_band.hpp"

namespace kerf {

template <class T>
struct BrittleBand {
  static constexpr std::string_view sentence =
      "Stress softens over the shortest band whose cracks run in any direction, and which takes "
      "the "
      "fracture_energy";
  static constexpr CriterionKeys keys{StrainOrEnergy::energy, true, "the fracture_energy alone"};
  static constexpr bool softens = true;
  static constexpr T own_share = T(0.9), end_share = T(0.7);  // of e_f

  static FractureLimits limits(const FractureInput& input) {
    return brittle_band_of(input.fracture_energy, carried_youngs_modulus(input.moduli),
                           input.spacing);
  }
  KERF_FUNCTION bool can_break(bool has_limit) const { return has_limit; }

  // The tensile strain k; beyond the share of e_f such that the mean with any other end passes.
  template <class Particle>
  KERF_FUNCTION T prepare(const Particle& particle) const {
    const T end = particle.solid.failure_strain, strain = particle.tensile_strain();
    return strain < end_share * end ? strain : T(3) * end;
  }

  KERF_FUNCTION bool passes(T prepared, const BreakableSolid<T>& solid) const {
    return solid.fails_at(prepared);
  }

  KERF_FUNCTION bool breaks(const BondStrain<T>& bond, const BreakableSolid<T>& solid) const {
    const T end = solid.failure_strain, own = own_share * end;
    if (!(end > T(0))) return false;
    return bond.own > own * (T(2) + own) ||
           (passes(bond.prepared, solid) && bond.mean > T(0.5) * end && bond.is_opening());
  }

  template <class Other>
  KERF_FUNCTION static BrittleBand from(const BrittleBand<Other>&) {
    return {};
  }
  bool operator==(const BrittleBand&) const = default;
};

}  // namespace kerf
