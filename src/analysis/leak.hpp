// SPDX-License-Identifier: Apache-2.0
// This measurement computes the mass of water inside intact solid, whose gaps are too narrow for
// it.
#pragma once

#include "analysis/kerf_scene.hpp"
#include "analysis/metric.hpp"

namespace kerf {

struct Leak {
  double mass = 0.0;   // kg (2D: kg/m), of the jet's water inside the solid
  double water = 0.0;  // kg (2D: kg/m), of all of the jet's water that has left the nozzle
  double share() const { return water > 0.0 ? mass / water : 0.0; }

  static Leak measure(const KerfScene& scene);
  static const MetricList<Leak>& metrics();
};

// A point is inside the solid where intact solid fills more than this share of the space, averaged
// over one and a half spacings. The share is 1/2 on a face, 3/4 at three fifths of a spacing below
// it, and at most 3/5 in the middle of a gap of one spacing.
inline constexpr float leak_share = 0.75f;

}  // namespace kerf
