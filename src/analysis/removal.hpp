// SPDX-License-Identifier: Apache-2.0
// This measurement computes the volume that a jet has removed, the removal rate and the energy per
// volume.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "analysis/kerf_scene.hpp"
#include "analysis/metric.hpp"

namespace kerf {

struct Removal {
  double volume = 0.0;  // m^3 (2D: m^2), of the solid as laid out
  double rate = 0.0;    // m^3/s (2D: m^2/s), mean since contact; 0 before
  // J/m^3 (1e9 J/m^3 = 1 J/mm^3), energy of the jets since contact over the volume; nan without
  // either.
  double specific_energy = std::numeric_limits<double>::quiet_NaN();
  // 1, of the volume in the way of the jet below the depth of the kerf; nan where there is none. A
  // kerf that ends on a flap has lost no less of what lies below it.
  double share_below = std::numeric_limits<double>::quiet_NaN();
  static constexpr double least_share = 0.005;  // half a percent; less is none in words

  bool loses_below() const { return share_below >= least_share; }

  static Removal measure(const KerfScene& scene);
  static const MetricList<Removal>& metrics();
};

// Volume of the particles that do not stand, m^3 (2D: m^2), of one body or, for `body` = -1, of the
// whole workpiece. `standing` is the result of find_standing().
double removed_volume(const Workpiece& workpiece, const std::vector<std::uint8_t>& standing,
                      int body = -1);

}  // namespace kerf
