// SPDX-License-Identifier: Apache-2.0
// This criterion compares the largest principal strain with a limit. A bond breaks in two cases.
// Its own strain ln(lambda) passes the limit, as no bond does in a uniform strain below it; at the
// tip of a crack such bonds break first. Or the largest principal strain, the mean of its ends,
// passes the limit, and the bond runs across the crack that opens there: it has at least a quarter
// of that strain (within 60 degrees of the axis, for a uniaxial strain) and is opening
// (bond_strain.hpp). So slanting bonds break along with the straight ones and do not bridge the
// crack.
// The limit is in Hencky's measure, because strains of successive stretches add up and a tensile
// test calls it true strain.
#pragma once

#include <string_view>

#include "fracture/bond_strain.hpp"
#include "fracture/breakable_solid.hpp"
#include "fracture/crack_band.hpp"

namespace kerf {

template <class T>
struct PrincipalStrain {
  static constexpr std::string_view sentence =
      "The largest principal strain, Hencky's, passes the failure_strain";
  static constexpr CriterionKeys keys{};
  static FractureLimits limits(const FractureInput& input) { return brittle_limits(input); }
  KERF_FUNCTION bool can_break(bool has_limit) const { return has_limit; }

  // lambda^2 - 1 of the largest principal stretch.
  template <class Particle>
  KERF_FUNCTION T prepare(const Particle& particle) const {
    if (!(particle.solid.failure_strain > T(0))) return T(0);
    const Vector<3, T> values = principal_values(particle.green);
    T largest = values[0] > values[1] ? values[0] : values[1];
    largest = largest > values[2] ? largest : values[2];
    return T(2) * largest;
  }

  // Whether a bound, at a tenth of the cost, shows that prepare() does not pass.
  template <int D>
  KERF_FUNCTION bool stays_below(const BreakableSolid<T>& solid,
                                 const SymmetricTensor<D, T>& green) const {
    return !passes(T(2) * possible_values(green).most + T(1e-5), solid);
  }

  KERF_FUNCTION bool passes(T prepared, const BreakableSolid<T>& solid) const {
    return is_above(prepared, solid.failure_strain);
  }

  KERF_FUNCTION bool breaks(const BondStrain<T>& bond, const BreakableSolid<T>& solid) const {
    if (is_above(bond.own, solid.failure_strain)) return true;
    return passes(bond.prepared, solid) && bond.mean > T(0.25) * bond.prepared && bond.is_opening();
  }

  template <class Other>
  KERF_FUNCTION static PrincipalStrain from(const PrincipalStrain<Other>&) {
    return {};
  }
  bool operator==(const PrincipalStrain&) const = default;
};

}  // namespace kerf
