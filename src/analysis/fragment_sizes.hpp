// SPDX-License-Identifier: Apache-2.0
// This measurement describes the size and speed of the fragments that have come off a workpiece.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "analysis/kerf_scene.hpp"
#include "analysis/metric.hpp"

namespace kerf {

inline constexpr std::array<double, 3> fragment_shares{0.1, 0.5, 0.9};

// The fragments that are too small for a counted piece. Each array holds the values below which a
// tenth, half and nine tenths of their mass lie; all are 0 without such fragments.
struct FragmentSizes {
  std::size_t count = 0;
  double total_mass = 0.0;           // kg (2D: kg/m)
  double largest_mass = 0.0;         // kg (2D: kg/m)
  std::array<double, 3> mass{};      // kg (2D: kg/m)
  std::array<double, 3> diameter{};  // m, of the disc or sphere of the same volume
  std::array<double, 3> speed{};     // m/s, of the centre

  static FragmentSizes measure(const KerfScene& scene);
  static const MetricList<FragmentSizes>& metrics();
};

// The sizes of a list of fragments. `total_mass` is that of the workpiece at the start, kg (2D:
// kg/m).
FragmentSizes measure_fragments(const std::vector<Fragment>& fragments, double total_mass,
                                int dimension);

}  // namespace kerf
