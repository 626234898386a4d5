// SPDX-License-Identifier: Apache-2.0
#include "analysis/wake.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "analysis/kerf_shape.hpp"

namespace kerf {

namespace {

// Returns the mean depth of the deeper half of the points.
double deeper_half(const std::vector<ProfilePoint>& points) {
  std::vector<double> depths;
  for (const ProfilePoint& point : points) depths.push_back(point.depth);
  std::sort(depths.begin(), depths.end(), std::greater<>());
  const std::size_t count = (depths.size() + 1) / 2;
  double sum = 0.0;
  for (std::size_t n = 0; n < count; ++n) sum += depths[n];
  return count > 0 ? sum / static_cast<double>(count) : 0.0;
}

// Returns where the points, in order, first reach a depth, m.
double first_reach(const std::vector<ProfilePoint>& points, double depth) {
  const auto found = std::find_if(points.begin(), points.end(), [depth](const ProfilePoint& point) {
    return point.depth >= depth;
  });
  if (found == points.begin()) return found->position;
  if (found == points.end()) return points.back().position;
  const ProfilePoint &last = *(found - 1), &next = *found;
  return last.position +
         (depth - last.depth) / (next.depth - last.depth) * (next.position - last.position);
}

}  // namespace

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
    if (const double lag = nozzle - sign * point.position; lag >= 0.0 && lag <= nozzle)
      behind.push_back({lag, point.depth});
  std::sort(behind.begin(), behind.end(),
            [](const auto& a, const auto& b) { return a.position < b.position; });
  wake.depth = deeper_half(behind);
  if (wake.depth == 0.0) return wake;
  for (int level = 0; level < front_levels; ++level) {
    const double share = (level + 0.5) / front_levels;
    const double deep = front_low + share * (front_high - front_low);
    wake.lag += first_reach(behind, deep * wake.depth) / front_levels;
  }
  if (map.grid.dimension == 3 && shape.middle.width > 0.0) wake.width = shape.middle.width;
  return wake;
}

}  // namespace kerf
