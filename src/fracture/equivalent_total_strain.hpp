// SPDX-License-Identifier: Apache-2.0
// This criterion compares the equivalent strain of the deformation gradient with a limit:
// sqrt(2/3 e' : e') of the deviator e' of Hencky's strain e = ln(C)/2, the finite-strain form of
// the criterion of Shinohara et al. (2004), section 2.3. It does not distinguish tension from
// compression: where a particle passes the limit, the bonds break that are opening
// (bond_strain.hpp). A bond whose own strain is above 3/2 of the limit breaks too, the strain at
// which the equivalent strain of a uniaxial strain, 2/3 e, passes it. This second limit breaks the
// tip of a crack no later than a uniform field, and is the only limit to hydrostatic tension.
#pragma once

#include <cmath>
#include <string_view>

#include "fracture/bond_strain.hpp"
#include "fracture/breakable_solid.hpp"
#include "fracture/crack_band.hpp"

namespace kerf {

template <class T>
struct EquivalentTotalStrain {
  static constexpr std::string_view sentence =
      "The equivalent strain of Hencky's strain passes the failure_strain";
  static constexpr CriterionKeys keys{};
  static FractureLimits limits(const FractureInput& input) { return brittle_limits(input); }
  KERF_FUNCTION bool can_break(bool has_limit) const { return has_limit; }

  template <class Particle>
  KERF_FUNCTION T prepare(const Particle& particle) const {
    if (!(particle.solid.failure_strain > T(0))) return T(0);
    Vector<3, T> strain = principal_values(particle.green);
    T mean = T(0), square = T(0);
    for (int a = 0; a < 3; ++a) {
      strain[a] = T(0.5) * std::log1p(T(2) * strain[a]);
      mean += strain[a] / T(3);
    }
    for (int a = 0; a < 3; ++a) square += (strain[a] - mean) * (strain[a] - mean);
    return std::sqrt(T(2) / T(3) * square);
  }

  KERF_FUNCTION bool passes(T prepared, const BreakableSolid<T>& solid) const {
    return solid.fails_at(prepared);
  }

  KERF_FUNCTION bool breaks(const BondStrain<T>& bond, const BreakableSolid<T>& solid) const {
    return is_above(bond.own, T(1.5) * solid.failure_strain) ||
           (passes(bond.prepared, solid) && bond.is_opening());
  }

  template <class Other>
  KERF_FUNCTION static EquivalentTotalStrain from(const EquivalentTotalStrain<Other>&) {
    return {};
  }
  bool operator==(const EquivalentTotalStrain&) const = default;
};

}  // namespace kerf
