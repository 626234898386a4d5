// SPDX-License-Identifier: Apache-2.0
// This measurement computes the width of the damaged solid beside a kerf.
#pragma once

#include "analysis/kerf_scene.hpp"
#include "analysis/metric.hpp"

namespace kerf {

// Material is damaged if it does not stand, or if one of the columns "damage" (broken bonds) and
// "flaw_damage" of the frame exceeds this value.
inline constexpr double least_damage = 0.1;
// The zone ends where the next stretch outwards holds less than this share of damaged material.
inline constexpr double damaged_part = 0.1;

struct DamagedZone {
  double width = 0.0;  // m, beside the kerf at half its depth, mean of both sides; 0 without a kerf

  static DamagedZone measure(const KerfScene& scene);
  static const MetricList<DamagedZone>& metrics();
};

}  // namespace kerf
