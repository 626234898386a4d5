// SPDX-License-Identifier: Apache-2.0
#include "analysis/kerf_map.hpp"

#include <algorithm>
#include <cmath>

namespace kerf {
namespace {

constexpr float face = 0.5f;  // level of a field at which the solid ends

struct Limits {
  std::array<double, 3> low{}, high{};  // m, local
  bool hold(const std::array<double, 3>& x) const {
    return x[0] >= low[0] && x[0] <= high[0] && x[1] >= low[1] && x[1] <= high[1];
  }
};

Limits find_limits(const KerfAxes& axes, const KerfPath& path) {
  const double reach = map_reach * axes.jet.width;
  Limits limits;
  for (std::size_t a = 0; a < 2; ++a) {
    limits.low[a] = std::min(path.begin[a], path.end[a]) - reach;
    limits.high[a] = std::max(path.begin[a], path.end[a]) + reach;
  }
  limits.low[2] = -std::numeric_limits<double>::infinity();
  limits.high[2] = std::numeric_limits<double>::infinity();
  return limits;
}

// Fields of the initial solid, of its standing part, and of intact fragments that do not stand.
struct Solids {
  std::vector<SolidPoint> original, standing, fragments;
};

Solids gather_solids(const KerfView& view, const KerfAxes& axes, const Limits& limits) {
  Solids solids;
  const Workpiece& workpiece = view.workpiece;
  for (std::size_t slot = 0; slot < workpiece.position.size(); ++slot) {
    if (!view.holds(slot)) continue;
    SolidPoint point{axes.local(workpiece.position[slot]), workpiece.volume[slot],
                     workpiece.size[slot]};
    if (limits.hold(point.position)) solids.original.push_back(point);
    const std::uint32_t row = view.rows[slot];
    if (!view.standing[slot] && !is_intact(view.frame, row)) continue;
    if (view.positions == KerfPositions::current) {
      if (row == Workpiece::none) continue;
      point.position = axes.local(view.frame.position[row]);
    }
    if (!limits.hold(point.position)) continue;
    (view.standing[slot] ? solids.standing : solids.fragments).push_back(point);
  }
  return solids;
}

// Returns the share of space of the standing solid. A fragment that together with it fills its
// position is a part of the wall; other fragments do not narrow the kerf.
std::vector<float> share_of_standing(const SampleGrid& grid, Solids solids) {
  SolidField field(grid);
  field.add(solids.standing);
  std::erase_if(solids.fragments,
                [&](const SolidPoint& fragment) { return field.share_with(fragment) < face; });
  field.add(solids.fragments);
  return field.share();
}

// Returns the position between samples k - 1 and k at which a field crosses the level of a face.
double crossing(const SampleGrid& grid, std::size_t k, float before, float after,
                float level = face) {
  const double part =
      after == before ? 0.5 : static_cast<double>((level - before) / (after - before));
  return grid.at(2, k - 1) + std::clamp(part, 0.0, 1.0) * grid.step;
}

// Returns the greatest value of each column and of those within the reach of a spline of it, along
// one axis across the jet.
std::vector<float> greatest_near(const SampleGrid& grid, const std::vector<float>& values,
                                 std::size_t axis) {
  const auto reach = static_cast<std::size_t>(2.0 * samples_per_spacing);
  const std::size_t stride = axis == 0 ? grid.count[1] : 1;
  std::vector<float> greatest(values);
  for (std::size_t c = 0; c < values.size(); ++c) {
    const std::size_t place = c / stride % grid.count[axis];
    const std::size_t first = c - std::min(place, reach) * stride;
    const std::size_t last = c + std::min(grid.count[axis] - 1 - place, reach) * stride;
    for (std::size_t n = first; n <= last; n += stride)
      greatest[c] = std::max(greatest[c], values[n]);
  }
  return greatest;
}

// Returns the share at which the faces of each column are: half of that inside. At an edge of the
// workpiece beside the column this is less, as the space beyond it is empty, and without it the
// corners of the workpiece would be round. 0 where a column is beyond the edge.
std::vector<float> levels_of_faces(const SampleGrid& grid, const std::vector<float>& original) {
  constexpr float rounding = 1e-4f;  // of columns on the edge
  std::vector<float> inside(grid.count[0] * grid.count[1], 0.0f);
  for (std::size_t c = 0; c < inside.size(); ++c) {
    const auto first = original.begin() + static_cast<std::ptrdiff_t>(c * grid.count[2]);
    inside[c] = *std::max_element(first, first + static_cast<std::ptrdiff_t>(grid.count[2]));
  }
  const std::vector<float> near = greatest_near(grid, greatest_near(grid, inside, 0), 1);
  std::vector<float> levels(inside.size(), 0.0f);
  for (std::size_t c = 0; c < inside.size(); ++c)
    if (inside[c] >= face - rounding)
      levels[c] = face * std::min(1.0f, inside[c] / std::min(1.0f, near[c]));
  return levels;
}

// Returns the face of a column on the side of a nozzle at depth `-standoff`: above the nozzle where
// that is inside the solid, as beside a steeply tilted jet, else below it. `level`: the share
// there.
void find_faces(const SampleGrid& grid, const float* original, float level, double standoff,
                KerfColumn& column) {
  if (!(level > 0.0f)) return;
  const std::size_t count = grid.count[2];
  const double nozzle = std::round((-standoff - grid.low[2]) / grid.step);
  auto k = static_cast<std::size_t>(std::clamp(nozzle, 0.0, static_cast<double>(count - 1)));
  while (k < count && original[k] < level) ++k;
  if (k == count) return;
  while (k > 0 && original[k - 1] >= level) --k;
  column.exists = true;
  column.top = k == 0 ? grid.at(2, 0) : crossing(grid, k, original[k - 1], original[k], level);
  std::size_t last = count - 1;
  while (original[last] < level) --last;
  column.bottom = last + 1 == count
                      ? grid.at(2, last)
                      : crossing(grid, last + 1, original[last], original[last + 1], level);
}

double find_free_depth(const SampleGrid& grid, const float* taken, const KerfColumn& column) {
  const double first = std::ceil((column.top - grid.low[2]) / grid.step - 1e-9);
  for (auto k = static_cast<std::size_t>(first); k < grid.count[2]; ++k) {
    if (grid.at(2, k) > column.bottom) break;
    if (taken[k] > face) continue;
    if (k == static_cast<std::size_t>(first)) return 0.0;
    return std::max(0.0, crossing(grid, k, taken[k - 1], taken[k]) - column.top);
  }
  return column.bottom - column.top;
}

}  // namespace

std::vector<std::uint8_t> find_standing(const Workpiece& workpiece, const Frame& frame,
                                        const std::vector<std::uint32_t>& rows,
                                        const std::vector<std::uint8_t>& in_piece) {
  std::vector<std::uint8_t> standing(rows.size(), 0);
  for (std::size_t slot = 0; slot < rows.size(); ++slot)
    if (is_intact(frame, rows[slot]) && (in_piece[slot] || !workpiece.initially_in_piece[slot]))
      standing[slot] = 1;
  return standing;
}

double KerfMap::sample_below_top(const KerfColumn& column, double below) const {
  // The far face has the roughness of the lattice.
  const double roughness = samples_per_spacing * grid.step;
  if (!column.exists || column.top + below > column.bottom + roughness) return -1.0;
  const double depth = std::min(column.top + below, column.bottom);
  return std::clamp((depth - grid.low[2]) / grid.step, 0.0, static_cast<double>(grid.count[2] - 1));
}

double KerfMap::taken_below_top(std::size_t i, std::size_t j, double below) const {
  const double sample = sample_below_top(column(i, j), below);
  if (sample < 0.0) return 0.0;
  const auto k = static_cast<std::size_t>(sample);
  const double part = sample - static_cast<double>(k);
  const float* samples = &taken[grid.index(i, j, 0)];
  const std::size_t next = std::min(k + 1, grid.count[2] - 1);
  return (1.0 - part) * static_cast<double>(samples[k]) + part * static_cast<double>(samples[next]);
}

bool KerfMap::is_laid_out_below_top(std::size_t i, std::size_t j, double below) const {
  const double sample = sample_below_top(column(i, j), below);
  return sample >= 0.0 &&
         laid_out[grid.index(i, j, static_cast<std::size_t>(std::round(sample)))] != 0;
}

KerfMap make_kerf_map(const KerfView& view, const KerfAxes& axes, const KerfPath& path) {
  const Limits limits = find_limits(axes, path);
  const Solids solids = gather_solids(view, axes, limits);
  KerfMap map;
  map.grid = make_grid(solids.original, limits.low, limits.high,
                       view.workpiece.axis_spacing / samples_per_spacing, view.frame.dimension);
  SolidField field(map.grid);
  field.add(solids.original);
  const std::vector<float>& original = field.share();
  map.taken = share_of_standing(map.grid, solids);
  map.laid_out.resize(original.size());
  map.columns.resize(map.grid.count[0] * map.grid.count[1]);
  const std::vector<float> levels = levels_of_faces(map.grid, original);
  for (std::size_t n = 0; n < original.size(); ++n) {
    const float level = levels[n / map.grid.count[2]];
    // Beside a face of the workpiece the initial share is below 1.
    map.taken[n] = std::clamp(1.0f - map.taken[n] / std::max(original[n], face), 0.0f, 1.0f);
    map.laid_out[n] = level > 0.0f && original[n] >= level ? 1 : 0;
  }
  for (std::size_t c = 0; c < map.columns.size(); ++c) {
    const std::size_t first = c * map.grid.count[2];
    find_faces(map.grid, &original[first], levels[c], axes.jet.standoff, map.columns[c]);
    if (map.columns[c].exists)
      map.columns[c].depth = find_free_depth(map.grid, &map.taken[first], map.columns[c]);
  }
  return map;
}

}  // namespace kerf
