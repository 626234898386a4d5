// SPDX-License-Identifier: Apache-2.0
#include "analysis/damaged_zone.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/cell_share.hpp"

namespace kerf {
namespace {

constexpr double bins_per_spacing = 4.0;
// A stretch at the edge of the workpiece counts if it is filled to this share.
constexpr double least_filled = 0.25;

// Marks the rows of a frame whose particles stand and are damaged.
std::vector<std::uint8_t> find_damaged(const Frame& frame) {
  std::vector<std::uint8_t> damaged(frame.id.size(), 0);
  for (const Column& column : frame.columns) {
    if (column.name != "damage" && column.name != "flaw_damage") continue;
    for (std::size_t row = 0; row < damaged.size(); ++row)
      if (static_cast<double>(column.values[row]) > least_damage) damaged[row] = 1;
  }
  return damaged;
}

// A layer of the workpiece: its volume by offset across the kerf.
struct Layer {
  double middle = 0.0;               // m, below the face
  double thickness = 0.0;            // m, down the jet
  double centre = 0.0;               // m, along the kerf
  double length = 0.0;               // m, along the kerf; not in 2D
  double low = 0.0;                  // m, crosswise, where the first bin begins
  double bin = 0.0;                  // m
  std::vector<double> damaged, all;  // m^3 (2D: m^2), running sums up to the end of each bin
};

Layer make_layer(const KerfMap& map, const KerfAxes& axes, const KerfPath& path, double middle,
                 double spacing) {
  Layer layer;
  const double width = axes.jet.width;
  layer.middle = middle;
  layer.thickness = std::max(width, 4.0 * spacing);
  layer.centre = (path.begin[1] + path.end[1]) / 2.0;
  layer.length = std::max(width / 4.0, 2.0 * spacing) + path.end[1] - path.begin[1];
  layer.low = map.grid.low[0];
  layer.bin = spacing / bins_per_spacing;
  const double breadth = static_cast<double>(map.grid.count[0]) * map.grid.step;
  layer.all.resize(static_cast<std::size_t>(std::ceil(breadth / layer.bin)));
  layer.damaged = layer.all;
  return layer;
}

// Returns the volume of a particle that lies in the layer, m^3 (2D: m^2).
double volume_in_layer(const Layer& layer, const KerfMap& map, const SolidPoint& point) {
  const SampleGrid& grid = map.grid;
  const bool flat = grid.dimension == 2;
  const double across = std::round((point.position[0] - grid.low[0]) / grid.step);
  const double along = flat ? 0.0 : std::round((point.position[1] - grid.low[1]) / grid.step);
  if (across < 0.0 || across >= static_cast<double>(grid.count[0])) return 0.0;
  if (along < 0.0 || along >= static_cast<double>(grid.count[1])) return 0.0;
  const KerfColumn& column =
      map.column(static_cast<std::size_t>(across), static_cast<std::size_t>(along));
  if (!column.exists) return 0.0;
  const double below = point.position[2] - column.top - layer.middle;
  return point.volume * cell_share(below, point.size, layer.thickness) *
         (flat ? 1.0 : cell_share(point.position[1] - layer.centre, point.size, layer.length));
}

// Distributes a volume over the bins that the particle covers.
void spread(const Layer& layer, const SolidPoint& point, double volume, std::vector<double>& bins) {
  const double begin = (point.position[0] - point.size / 2.0 - layer.low) / layer.bin;
  const double end = begin + point.size / layer.bin;
  const double last = std::min(end, static_cast<double>(bins.size()));
  for (double n = std::max(0.0, std::floor(begin)); n < last; n += 1.0)
    bins[static_cast<std::size_t>(n)] +=
        volume * (std::min(n + 1.0, end) - std::max(n, begin)) / (end - begin);
}

void add_up(std::vector<double>& bins) {
  for (std::size_t n = 1; n < bins.size(); ++n) bins[n] += bins[n - 1];
}

void fill(Layer& layer, const KerfView& view, const KerfMap& map, const KerfAxes& axes) {
  const std::vector<std::uint8_t> damaged = find_damaged(view.frame);
  const Workpiece& workpiece = view.workpiece;
  for (std::size_t slot = 0; slot < workpiece.position.size(); ++slot) {
    if (!view.holds(slot)) continue;
    const SolidPoint point{axes.local(workpiece.position[slot]), workpiece.volume[slot],
                           workpiece.size[slot]};
    const double volume = volume_in_layer(layer, map, point);
    if (volume <= 0.0) continue;
    spread(layer, point, volume, layer.all);
    if (view.standing[slot] == stands_as_laid_out) continue;
    if (!view.standing[slot] || damaged[view.rows[slot]])
      spread(layer, point, volume, layer.damaged);
  }
  add_up(layer.all);
  add_up(layer.damaged);
}

// Returns the outer end of the damaged material, in bins from the first one towards the last: that
// of a full zone whose last tenth of a stretch lies in the last stretch that holds a tenth of
// damage.
double find_end(const Layer& layer, std::size_t stretch, double full) {
  const std::size_t count = layer.all.size();
  for (std::size_t n = count; n-- > 0;) {
    const std::size_t end = std::min(count - 1, n + stretch);
    const double all = layer.all[end] - layer.all[n];
    const double damaged = layer.damaged[end] - layer.damaged[n];
    if (all < least_filled * full || damaged < damaged_part * all) continue;
    return static_cast<double>(n) + 1.0 + damaged / all * static_cast<double>(stretch);
  }
  return 0.0;
}

void turn_round(std::vector<double>& sums) {
  const double whole = sums.back();
  std::reverse(sums.begin(), sums.end());
  for (std::size_t n = 0; n + 1 < sums.size(); ++n) sums[n] = whole - sums[n + 1];
  sums.back() = whole;
}

}  // namespace

const MetricList<DamagedZone>& DamagedZone::metrics() {
  static const MetricList<DamagedZone> list{{"damaged_zone", "m", "width of the damaged zone",
                                             "Width of the damaged material beside the kerf at "
                                             "half its depth, mean of both sides; null where "
                                             "that is in a gap between layers.",
                                             &DamagedZone::width}};
  return list;
}

DamagedZone DamagedZone::measure(const KerfScene& scene) {
  const auto& [view, map, axes, path, shape, fragments, conditions] = scene;
  if (std::isnan(shape.middle.width)) return {shape.middle.width};
  if (shape.middle.width <= 0.0) return {};
  const double spacing = view.workpiece.axis_spacing;
  Layer layer = make_layer(map, axes, path, shape.depth / 2.0, spacing);
  fill(layer, view, map, axes);
  const double breadth = std::max(axes.jet.width / 2.0, 3.0 * spacing);
  const auto stretch = static_cast<std::size_t>(std::lround(breadth / layer.bin));
  const double full = breadth * layer.thickness * (map.grid.dimension == 2 ? 1.0 : layer.length);
  const double right = find_end(layer, stretch, full);
  turn_round(layer.all);
  turn_round(layer.damaged);
  const double left = static_cast<double>(layer.all.size()) - find_end(layer, stretch, full);
  return {std::max(0.0, ((right - left) * layer.bin - shape.middle.width) / 2.0)};
}

}  // namespace kerf
