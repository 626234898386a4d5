// SPDX-License-Identifier: Apache-2.0
#include "analysis/kerf_width.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/line_slope.hpp"

namespace kerf {
namespace {

// A width is the mean over a layer from the face down to twice this part of the depth, and to at
// least four spacings; the layers of the middle and the bottom have the same thickness. The layer
// of the bottom ends half a layer above the bottom of a blind kerf, which is round.
constexpr double edge_fraction = 0.05;
constexpr double least_edge = 2.0;  // spacings
// A kerf that is less deep than this, in spacings, has one level only.
constexpr double least_levels = 8.0;

// Returns the width removed at a depth below the face, m: of all connected openings that the tube
// meets, to the edge of the workpiece or of the map where no solid stands.
double width_below_top(const KerfMap& map, std::size_t j, const SectionProbe& probe, double below) {
  const std::size_t count = map.grid.count[0];
  double width = 0.0, before = 0.0, begin = map.grid.at(0, 0);
  for (std::size_t i = 0; i <= count; ++i) {
    // The map ends in solid half a step beyond its last sample, which is its edge.
    const double now = i < count ? map.taken_below_top(i, j, below) : 0.0;
    const bool opens = before < 0.5 && now >= 0.5, closes = before >= 0.5 && now < 0.5;
    if (opens || closes) {
      const double part = (0.5 - before) / (now - before);
      const double edge = map.grid.at(0, i) + (part - 1.0) * map.grid.step;
      if (opens) begin = edge;
      if (closes && begin <= probe.tube_high && edge >= probe.tube_low) width += edge - begin;
    }
    before = now;
  }
  return width;
}

// Whether solid was laid out there in the tube of the jet: a gap between two layers has no width.
bool crosses_solid(const KerfMap& map, std::size_t j, const SectionProbe& probe, double below) {
  for (std::size_t i = 0; i < map.grid.count[0]; ++i)
    if (beside_tube(map, i, probe) <= probe.reach && map.is_laid_out_below_top(i, j, below))
      return true;
  return false;
}

// Returns the median, over the sections that are that deep, of the mean width in a layer of twice
// `half`, where that has solid; nan where it has none.
KerfLevel measure_level(const KerfMap& map, const std::vector<KerfSection>& passed,
                        const SectionProbe& probe, double below, double half) {
  const int rows = 2 * static_cast<int>(std::max(1.0, std::round(half / map.grid.step)));
  std::vector<double> widths;
  bool is_deep = false;
  for (const KerfSection& section : passed) {
    if (section.depth < below) continue;
    is_deep = true;
    double sum = 0.0;
    int solid_rows = 0;
    for (int row = 0; row < rows; ++row) {
      const double at = below + half * ((2 * row + 1.0) / rows - 1.0);
      if (!crosses_solid(map, section.index, probe, at)) continue;
      sum += width_below_top(map, section.index, probe, at);
      ++solid_rows;
    }
    if (solid_rows > 0) widths.push_back(sum / solid_rows);
  }
  const bool is_gap = is_deep && widths.empty();
  return {below, half, is_gap ? std::nan("") : median(widths)};
}

// Returns the angle of one face, rad, from the least-squares line through widths over depth.
double find_taper(std::vector<KerfLevel> levels) {
  std::erase_if(levels, [](const KerfLevel& level) { return std::isnan(level.width); });
  if (levels.size() < 2) return 0.0;
  const double slope = line_slope(
      levels, [](const KerfLevel& level) { return level.below; },
      [](const KerfLevel& level) { return level.width; });
  return std::atan(-slope / 2.0);
}

}  // namespace

void measure_widths(const KerfMap& map, const std::vector<KerfSection>& passed,
                    const SectionProbe& probe, double spacing, KerfShape& shape) {
  if (shape.depth < spacing) return;
  const double edge = std::max(least_edge * spacing, edge_fraction * shape.depth);
  const bool deep = shape.depth >= least_levels * spacing;
  // The last half spacing before a face has the roughness of the lattice.
  const double half = deep ? edge - spacing / 2.0 : shape.depth / 4.0;
  const auto level = [&](double below) { return measure_level(map, passed, probe, below, half); };
  shape.middle = level(shape.depth / 2.0);
  shape.top = shape.bottom = shape.middle;
  if (!deep) return;
  const double lowest = shape.through ? shape.thickness - edge : shape.depth - 2.0 * edge;
  shape.top = level(edge);
  shape.bottom = level(std::min(lowest, shape.depth));
  std::vector<KerfLevel> levels;
  const double last = std::min(shape.bottom.below + half, shape.depth);
  for (double below = spacing; below <= last; below += spacing)
    levels.push_back(measure_level(map, passed, probe, below, spacing / 2.0));
  shape.taper = find_taper(levels);
}

}  // namespace kerf
