// SPDX-License-Identifier: Apache-2.0
#include "analysis/kerf_sections.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace kerf {
namespace {

// Returns the value that is reached over the breadth of the probe: of one value per sample across,
// the lowest of that many largest ones; 0 if there are fewer.
double reached_by_breadth(std::vector<double> values, const KerfMap& map,
                          const SectionProbe& probe) {
  const auto needed =
      static_cast<std::size_t>(std::max(1.0, std::round(probe.breadth / map.grid.step)));
  if (values.size() < needed) return 0.0;
  const auto least = values.begin() + static_cast<std::ptrdiff_t>(needed - 1);
  std::nth_element(values.begin(), least, values.end(), std::greater<>());
  return *least;
}

}  // namespace

double beside_tube(const KerfMap& map, std::size_t i, const SectionProbe& probe) {
  const double across = map.grid.at(0, i);
  return std::max(probe.tube_low - across, across - probe.tube_high);
}

double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

KerfSection measure_section(const KerfMap& map, std::size_t j, const SectionProbe& probe) {
  const double rounding = 1e-6 * map.grid.step;  // of a column on the edge of the tube
  std::vector<double> depths, thicknesses;
  for (std::size_t i = 0; i < map.grid.count[0]; ++i) {
    const KerfColumn& column = map.column(i, j);
    const double beside = beside_tube(map, i, probe);
    if (!column.exists || beside > probe.reach) continue;
    depths.push_back(column.depth);
    if (beside <= rounding) thicknesses.push_back(column.bottom - column.top);
  }
  return {j, map.grid.at(1, j), reached_by_breadth(std::move(depths), map, probe),
          median(std::move(thicknesses))};
}

double opening_below_top(const KerfMap& map, std::size_t j, const SectionProbe& probe,
                         double below) {
  std::vector<double> taken;
  for (std::size_t i = 0; i < map.grid.count[0]; ++i)
    if (beside_tube(map, i, probe) <= probe.reach)
      taken.push_back(map.taken_below_top(i, j, below));
  return reached_by_breadth(std::move(taken), map, probe);
}

}  // namespace kerf
