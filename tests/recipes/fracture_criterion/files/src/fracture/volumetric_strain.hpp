// SPDX-License-Identifier: Apache-2.0
// This criterion breaks the bonds that open where the volumetric strain ln J, the trace of Hencky's
// strain, passes the failure strain.
#pragma once

#include <cmath>
#include <string_view>

#include "fracture/bond_strain.hpp"
#include "fracture/breakable_solid.hpp"
#include "fracture/crack_band.hpp"

namespace kerf {

template <class T>
struct VolumetricStrain {
  static constexpr std::string_view sentence =
      "The volumetric strain ln J passes the failure_strain";
  static constexpr CriterionKeys keys{};
  static FractureLimits limits(const FractureInput& input) { return brittle_limits(input); }
  KERF_FUNCTION bool can_break(bool has_limit) const { return has_limit; }

  template <class Particle>
  KERF_FUNCTION T prepare(const Particle& particle) const {
    return T(0.5) * std::log1p(volume_square_less_one(particle.green));
  }
  KERF_FUNCTION bool passes(T prepared, const BreakableSolid<T>& solid) const {
    return solid.fails_at(prepared);
  }
  KERF_FUNCTION bool breaks(const BondStrain<T>& bond, const BreakableSolid<T>& solid) const {
    return passes(bond.prepared, solid) && bond.is_opening();
  }

  template <class Other>
  KERF_FUNCTION static VolumetricStrain from(const VolumetricStrain<Other>&) {
    return {};
  }
  bool operator==(const VolumetricStrain&) const = default;
};

}  // namespace kerf
