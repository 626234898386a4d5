// SPDX-License-Identifier: Apache-2.0
// The cross-sections of a kerf, one for each sample along it, have a depth and widths.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "analysis/kerf_map.hpp"

namespace kerf {

// A section is as deep as this part of a jet width of it (or two spacings, if that is more): the
// lower part of a rounded bottom counts, and a crack or the gap of a particle does not.
inline constexpr double depth_breadth_fraction = 0.25;

// The ranges across a section that its depth and widths refer to.
struct SectionProbe {
  double breadth = 0.0;    // m, over which a kerf must reach its depth
  double tube_low = 0.0;   // m, crosswise, the space of the jet or of its path in the section
  double tube_high = 0.0;  // m
  double reach = 0.0;      // m, distance beside the tube up to which the depth is measured
};

// Returns the distance of a sample from the tube across it, m; not positive inside.
double beside_tube(const KerfMap& map, std::size_t i, const SectionProbe& probe);

struct KerfSection {
  std::size_t index = 0;   // of the samples along the kerf
  double position = 0.0;   // m, along the kerf
  double depth = 0.0;      // m
  double thickness = 0.0;  // m, median within the tube; 0 = no solid was laid out here
};

KerfSection measure_section(const KerfMap& map, std::size_t j, const SectionProbe& probe);

// Returns the share removed at a depth below the face that at least the breadth of the probe has, 0
// to 1.
double opening_below_top(const KerfMap& map, std::size_t j, const SectionProbe& probe,
                         double below);

// Returns the median of the values, 0 without any.
double median(std::vector<double> values);

}  // namespace kerf
