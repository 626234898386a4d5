// SPDX-License-Identifier: Apache-2.0
// The traits of the `standard` formulation: which particles interact, which fields they have, and
// what a solid particle stores by its density. What bonds store is a sum of the solid's own
// (standard/solid_part.hpp).
#pragma once

#include "fluid/density_pressure.hpp"
#include "neighbours/pair_range.hpp"
#include "simulation/balance_sums.hpp"

namespace kerf {

struct StandardTraits {
  using Pairs = ContactPairs;

  static FieldGroups field_groups(bool has_solids, bool smooth_walls, bool mirrored) {
    return {.rate_stress = false,
            .contact = has_solids,
            .mirrored = mirrored,
            .density_losses = true,
            .smooth_walls = smooth_walls,
            .sleep = has_solids};
  }

  template <int D, class P>
  KERF_FUNCTION static SolidStorage stored_by_solid(const ParticleView<D, P>& particles, Index i,
                                                    double mass) {
    return {mass * energy_by_density(particles, i, double(particles.compression[i])), 0.0};
  }
};

}  // namespace kerf
