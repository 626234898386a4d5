// SPDX-License-Identifier: Apache-2.0
#include "analysis/wake.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/kerf_shape.hpp"

namespace kerf {

Wake measure_wake(const KerfView& view, const KerfAxes& axes) {
  Wake wake;
  const KerfPath path{{}, axes.way(view.frame.time)};
  const KerfMap map = make_kerf_map(view, axes, path);
  const KerfShape shape = measure_shape(map, axes, path, view.workpiece.axis_spacing);
  const double along = axes.travel[0] + axes.travel[1];
  const double sign = along < 0.0 ? -1.0 : 1.0, nozzle = std::abs(path.end[0] + path.end[1]);
  // The profile from the nozzle backwards: how far each point is behind it, m, and its depth.
  std::vector<ProfilePoint> behind;
  for (const ProfilePoint& point : shape.profile)
    if (const double lag = nozzle - sign * point.position; lag >= -axes.jet.width)
      behind.push_back({lag, point.depth});
  std::sort(behind.begin(), behind.end(),
            [](const auto& a, const auto& b) { return a.position < b.position; });
  for (const ProfilePoint& point : behind) wake.depth = std::max(wake.depth, point.depth);
  if (wake.depth == 0.0) return wake;
  const double deep = front_share * wake.depth;
  for (std::size_t n = 0; n < behind.size(); ++n) {
    if (behind[n].depth < deep) continue;
    wake.lag = behind[n].position;
    if (n > 0 && behind[n].depth > behind[n - 1].depth)
      wake.lag -= (behind[n].depth - deep) / (behind[n].depth - behind[n - 1].depth) *
                  (behind[n].position - behind[n - 1].position);
    break;
  }
  if (map.grid.dimension == 3) wake.width = shape.middle.width;
  return wake;
}

}  // namespace kerf
