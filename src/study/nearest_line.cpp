// SPDX-License-Identifier: Apache-2.0
#include "study/nearest_line.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace kerf {

Fit nearest_line(const MetricByKey& runs, double root) {
  std::vector<std::pair<double, double>> points(runs.begin(), runs.end());
  std::sort(points.begin(), points.end(), [&](const auto& a, const auto& b) {
    return std::abs(a.first - root) < std::abs(b.first - root);
  });
  Fit fit;
  for (std::size_t count = std::min<std::size_t>(5, points.size()); count <= points.size();
       ++count) {
    fit = fit_line({points.begin(), points.begin() + static_cast<std::ptrdiff_t>(count)}, root);
    if (fit.problem.empty() && has_slope(fit, 0.5)) break;
  }
  return fit;
}

bool has_slope(const Fit& line, double share) {
  return share * std::abs(line.parameters[1]) > line.half_interval(1, 0.95);
}

}  // namespace kerf
