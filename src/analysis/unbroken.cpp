// SPDX-License-Identifier: Apache-2.0
#include "analysis/unbroken.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/kerf_sections.hpp"

namespace kerf {
namespace {

// Spacings, of rounding: the sizes of particles have single precision, over many particles.
constexpr double nothing = 1e-4;
// A window at the edge of a body, which has less than this share of the columns that others have,
// is not judged: the outermost row of particles has few bonds, and water beside the body erodes it.
constexpr double least_covered = 0.75;

// A grid of columns across the jet, each with a length along it.
struct Columns {
  std::array<double, 2> low{};  // m, edges of the first column
  std::array<std::size_t, 2> count{1, 1};
  std::array<std::size_t, 2> window{1, 1};  // columns
  double step = 0.0;                        // m
  std::vector<double> laid_out;
  std::vector<double> counted, standing, unbroken;  // of the bodies that count as unbroken
  std::vector<double> covered;                      // 1 where such a body was laid out, else 0
};

// Means over the window that begins at each column.
struct Windows {
  std::vector<double> laid_out, counted, standing, unbroken, covered;
};

Columns make_columns(const KerfView& view, const KerfAxes& axes, const KerfPath& path) {
  const double spacing = view.workpiece.axis_spacing, width = axes.jet.width;
  const double breadth = std::max(depth_breadth_fraction * width, 2.0 * spacing);
  Columns columns;
  columns.step = spacing / samples_per_spacing;
  for (std::size_t a = 0; a < (view.frame.dimension == 3 ? 2u : 1u); ++a) {
    const double low = std::min(path.begin[a], path.end[a]) - width / 2.0;
    const double high = std::max(path.begin[a], path.end[a]) + width / 2.0;
    const double length = std::max(high - low, breadth);
    columns.window[a] = static_cast<std::size_t>(std::lround(breadth / columns.step));
    columns.count[a] =
        std::max(columns.window[a], static_cast<std::size_t>(std::lround(length / columns.step)));
    columns.low[a] = (low + high - static_cast<double>(columns.count[a]) * columns.step) / 2.0;
  }
  columns.laid_out.assign(columns.count[0] * columns.count[1], 0.0);
  columns.counted = columns.standing = columns.unbroken = columns.laid_out;
  return columns;
}

// The columns of one direction that a particle covers, and the part that it covers of each.
struct Cover {
  std::size_t first = 0;
  std::vector<double> part;
};

Cover cover(const Columns& columns, std::size_t axis, double centre, double size) {
  const double begin = (centre - size / 2.0 - columns.low[axis]) / columns.step;
  const double end = begin + size / columns.step;
  Cover result;
  const double first = std::max(0.0, std::floor(begin));
  const double last = std::min(end, static_cast<double>(columns.count[axis]));
  result.first = static_cast<std::size_t>(first);
  for (double n = first; n < last; n += 1.0)
    result.part.push_back(std::min(n + 1.0, end) - std::max(n, begin));
  return result;
}

void add(const Columns& columns, const SolidPoint& point, int dimension,
         std::vector<double>& lengths) {
  const Cover across = cover(columns, 0, point.position[0], point.size);
  const Cover along =
      dimension == 3 ? cover(columns, 1, point.position[1], point.size) : Cover{0, {1.0}};
  const double height = point.volume / std::pow(point.size, dimension - 1);
  for (std::size_t i = 0; i < across.part.size(); ++i)
    for (std::size_t j = 0; j < along.part.size(); ++j)
      lengths[(across.first + i) * columns.count[1] + along.first + j] +=
          height * across.part[i] * along.part[j];
}

// Returns whether a particle covers no column.
bool is_outside(const Columns& columns, const SolidPoint& point, int dimension) {
  for (std::size_t a = 0; a < (dimension == 3 ? 2u : 1u); ++a) {
    const double high = columns.low[a] + static_cast<double>(columns.count[a]) * columns.step;
    if (point.position[a] + point.size / 2.0 < columns.low[a] ||
        point.position[a] - point.size / 2.0 > high)
      return true;
  }
  return false;
}

// Returns the means of the lengths over the windows.
std::vector<double> window_means(const Columns& columns, const std::vector<double>& lengths) {
  const auto [rows, aside] = columns.count;
  const auto [high, broad] = columns.window;
  std::vector<double> sums((rows + 1) * (aside + 1), 0.0), means;
  for (std::size_t i = 0; i < rows; ++i)
    for (std::size_t j = 0; j < aside; ++j)
      sums[(i + 1) * (aside + 1) + j + 1] = lengths[i * aside + j] + sums[i * (aside + 1) + j + 1] +
                                            sums[(i + 1) * (aside + 1) + j] -
                                            sums[i * (aside + 1) + j];
  for (std::size_t i = 0; i + high <= rows; ++i)
    for (std::size_t j = 0; j + broad <= aside; ++j)
      means.push_back((sums[(i + high) * (aside + 1) + j + broad] -
                       sums[i * (aside + 1) + j + broad] - sums[(i + high) * (aside + 1) + j] +
                       sums[i * (aside + 1) + j]) /
                      static_cast<double>(high * broad));
  return means;
}

// Which bodies are measured, by index into Case::bodies (measure_unbroken).
using Counts = std::vector<BodyCount>;

Counts only(int body) {
  Counts counts(static_cast<std::size_t>(body) + 1, BodyCount::not_at_all);
  counts.back() = BodyCount::in_full;
  return counts;
}

BodyCount count_of(const Counts& counts, std::size_t body) {
  return body < counts.size() ? counts[body] : BodyCount::not_at_all;
}

// Fills the columns with the bodies that count.
void fill(const KerfView& view, const KerfAxes& axes, const Counts& counts, Columns& columns) {
  const std::vector<std::uint8_t> torn = find_torn(view.workpiece, view.frame, view.rows);
  const Workpiece& workpiece = view.workpiece;
  const int dimension = view.frame.dimension;
  for (std::size_t slot = 0; slot < workpiece.position.size(); ++slot) {
    const BodyCount count = count_of(counts, workpiece.body[slot]);
    if (count == BodyCount::not_at_all) continue;
    const SolidPoint point{axes.local(workpiece.position[slot]), workpiece.volume[slot],
                           workpiece.size[slot]};
    if (is_outside(columns, point, dimension)) continue;
    add(columns, point, dimension, columns.laid_out);
    if (count != BodyCount::in_full) continue;
    add(columns, point, dimension, columns.counted);
    if (!view.standing[slot]) continue;
    add(columns, point, dimension, columns.standing);
    if (view.standing[slot] == stands_as_laid_out || !torn[slot])
      add(columns, point, dimension, columns.unbroken);
  }
  for (const double length : columns.counted)
    columns.covered.push_back(length < workpiece.axis_spacing / 2.0 ? 0.0 : 1.0);
  for (std::size_t n = 0; n < columns.laid_out.size(); ++n)
    columns.laid_out[n] *= columns.covered[n];
}

const Column* damage_column(const Frame& frame) {
  const Column* damage = find_column(frame, "body_damage");
  return damage != nullptr ? damage : find_column(frame, "damage");
}

// Returns the share of its bonds that each slot has lost, 0 of one without a row.
std::vector<double> lost_bonds(const Workpiece& workpiece, const Frame& frame,
                               const std::vector<std::uint32_t>& rows) {
  std::vector<double> lost(rows.size(), 0.0);
  const Column *within = damage_column(frame), *all = find_column(frame, "damage");
  if (within == nullptr) return lost;
  if (all == nullptr) all = within;
  for (std::size_t slot = 0; slot < rows.size(); ++slot) {
    if (rows[slot] == Workpiece::none) continue;
    const Column& damage = workpiece.is_in_united(slot) ? *all : *within;
    lost[slot] = static_cast<double>(damage.values[rows[slot]]);
  }
  return lost;
}

Windows windows_of(const Columns& columns) {
  return {window_means(columns, columns.laid_out), window_means(columns, columns.counted),
          window_means(columns, columns.standing), window_means(columns, columns.unbroken),
          window_means(columns, columns.covered)};
}

}  // namespace

bool tells_torn(const Frame& frame) {
  return damage_column(frame) != nullptr;
}

std::vector<std::uint8_t> find_torn(const Workpiece& workpiece, const Frame& frame,
                                    const std::vector<std::uint32_t>& rows) {
  std::vector<std::uint8_t> torn(rows.size(), 0);
  const std::vector<double> lost = lost_bonds(workpiece, frame, rows);
  for (std::size_t slot = 0; slot < rows.size(); ++slot) torn[slot] = lost[slot] > torn_share;
  return torn;
}

std::vector<double> find_bond_loss(const Workpiece& workpiece, const Frame& frame,
                                   const std::vector<std::uint32_t>& rows) {
  std::vector<double> loss = lost_bonds(workpiece, frame, rows);
  const Column* flaws = find_column(frame, "flaw_damage");
  for (std::size_t slot = 0; flaws != nullptr && slot < rows.size(); ++slot)
    if (rows[slot] != Workpiece::none && flaws->values[rows[slot]] >= 1.0f) loss[slot] = 1.0;
  return loss;
}

UnbrokenThickness measure_unbroken(const KerfView& view, const KerfAxes& axes,
                                   const KerfPath& path) {
  return measure_unbroken(view, axes, path, only(view.body));
}

UnbrokenThickness measure_unbroken(const KerfView& view, const KerfAxes& axes, const KerfPath& path,
                                   const Counts& counts) {
  Columns columns = make_columns(view, axes, path);
  fill(view, axes, counts, columns);
  const auto [laid_out, counted, standing, unbroken, covered] = windows_of(columns);
  const Workpiece& workpiece = view.workpiece;
  const double spacing = workpiece.axis_spacing, none = nothing * spacing;
  UnbrokenThickness found;
  found.least = std::numeric_limits<double>::infinity();
  double share = 2.0;
  const double most_covered = *std::max_element(covered.begin(), covered.end());
  for (std::size_t n = 0; n < laid_out.size(); ++n) {
    if (counted[n] < spacing / 2.0) continue;
    // Beyond the edge of a body there is no thickness that could be unbroken.
    const double part = covered[n] > 0.0 ? covered[n] : 1.0;
    if (covered[n] > least_covered * most_covered) {
      found.is_open = found.is_open || standing[n] <= none;
      found.is_torn_through = found.is_torn_through || unbroken[n] <= none;
      found.least = std::min(found.least, unbroken[n] / part);
    }
    const double here = unbroken[n] / laid_out[n];
    if (here > share || (here == share && laid_out[n] / part <= found.laid_out)) continue;
    share = here;
    found.laid_out = laid_out[n] / part;
    found.unbroken = unbroken[n] / part;
  }
  if (std::isinf(found.least)) found.least = found.unbroken;
  double below = 0.0;
  for (const WorkpieceBody& body : workpiece.bodies)
    if (count_of(counts, body.body) == BodyCount::in_full) below += body.below;
  if (below > 0.0) {
    found.is_open = found.is_torn_through = false;
    for (double* length : {&found.laid_out, &found.unbroken, &found.least}) *length += below;
  }
  return found;
}

std::vector<double> torn_places(const KerfView& view, const KerfAxes& axes, const KerfPath& path) {
  Columns columns = make_columns(view, axes, path);
  fill(view, axes, only(view.body), columns);
  const Windows windows = windows_of(columns);
  const double spacing = view.workpiece.axis_spacing, none = nothing * spacing;
  const auto is_torn = [&](std::size_t n) {
    return windows.laid_out[n] >= spacing / 2.0 && windows.unbroken[n] <= none;
  };
  std::vector<double> places;
  for (std::size_t n = 0, first = 0; n < windows.laid_out.size(); first = ++n) {
    if (!is_torn(n)) continue;
    while (n + 1 < windows.laid_out.size() && is_torn(n + 1)) ++n;
    const double middle = static_cast<double>(first + n + columns.window[0]) / 2.0;
    places.push_back(columns.low[0] + middle * columns.step);
  }
  return places;
}

}  // namespace kerf
