// SPDX-License-Identifier: Apache-2.0
#include "analysis/kerf_lag.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace kerf {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// A position on the path of the nozzle: a section in 3D, a column in 2D.
struct Station {
  std::size_t index = 0;
  double position = 0.0;  // m
};

// Returns the stations in the workpiece no further than two jet widths ahead of the nozzle, the
// foremost first.
std::vector<Station> stations_backwards(const KerfMap& map, const KerfAxes& axes,
                                        const KerfPath& path, const SectionProbe& probe) {
  const std::size_t axis = map.grid.dimension == 2 ? 0 : 1;
  const bool forwards = axes.travel[axis] > 0.0;
  const double ahead = path.end[axis] + (forwards ? 2.0 : -2.0) * axes.jet.width;
  const double middle =
      ((probe.tube_low + probe.tube_high) / 2.0 - map.grid.low[0]) / map.grid.step;
  const auto across = static_cast<std::size_t>(
      std::clamp(std::round(middle), 0.0, static_cast<double>(map.grid.count[0] - 1)));
  std::vector<Station> stations;
  for (std::size_t n = 0; n < map.grid.count[axis]; ++n) {
    const double position = map.grid.at(axis, n);
    if (forwards ? position > ahead : position < ahead) continue;
    if ((axis == 0 ? map.column(n, 0) : map.column(across, n)).exists)
      stations.push_back({n, position});
  }
  if (forwards) std::reverse(stations.begin(), stations.end());
  return stations;
}

// Returns the position at which the kerf first is open at a depth; nan where it never is, or where
// the first station is open.
double front_position(const KerfMap& map, const std::vector<Station>& stations,
                      const SectionProbe& probe, double below) {
  double before = 0.0;
  for (std::size_t n = 0; n < stations.size(); ++n) {
    const std::size_t index = stations[n].index;
    const double now = map.grid.dimension == 2 ? map.taken_below_top(index, 0, below)
                                               : opening_below_top(map, index, probe, below);
    if (now >= 0.5 && n == 0) break;
    if (now >= 0.5) {
      const double part = (0.5 - before) / (now - before), last = stations[n - 1].position;
      return last + part * (stations[n].position - last);
    }
    before = now;
  }
  return nan;
}

}  // namespace

double measure_lag(const KerfMap& map, const KerfAxes& axes, const KerfPath& path,
                   const SectionProbe& probe, const KerfShape& shape) {
  if (shape.middle.below <= 0.0) return nan;
  const auto stations = stations_backwards(map, axes, path, probe);
  const auto mean_position = [&](const KerfLevel& level) {
    const int rows = 2 * static_cast<int>(std::ceil(level.half / map.grid.step));
    double sum = 0.0;
    for (int row = 0; row < rows; ++row)
      sum += front_position(map, stations, probe,
                            level.below + level.half * ((2 * row + 1.0) / rows - 1.0));
    return sum / rows;
  };
  const bool forwards = axes.travel[0] + axes.travel[1] > 0.0;
  return (forwards ? 1.0 : -1.0) * (mean_position(shape.top) - mean_position(shape.bottom));
}

}  // namespace kerf
