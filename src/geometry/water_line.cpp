// SPDX-License-Identifier: Apache-2.0
#include "geometry/water_line.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/boundary_between.hpp"
#include "geometry/jet_direction.hpp"
#include "geometry/shapes.hpp"
#include "model/body.hpp"

namespace kerf {
namespace {

constexpr double endless = std::numeric_limits<double>::infinity();

bool meets_any(const WaterLine& line, const std::vector<const Body*>& bodies, int dimension) {
  return std::any_of(bodies.begin(), bodies.end(), [&](const Body* body) {
    return std::isfinite(way_into(*body, line, dimension));
  });
}

}  // namespace

Point WaterLine::at(double way) const {
  Point x = origin;
  for (std::size_t a = 0; a < 3; ++a) x[a] += way * direction[a];
  return x;
}

WaterLine axis_line(const Jet& jet, double moved) {
  WaterLine line{jet.position, jet_direction(jet)};
  for (std::size_t a = 0; a < 3; ++a)
    line.origin[a] += moved * jet.traverse[a] - jet.standoff * line.direction[a];
  return line;
}

std::vector<WaterLine> lines_at_edge(const Jet& jet, int dimension) {
  const JetAxes axes = axes_of(jet);
  const int count = dimension == 2 ? 2 : 8;
  std::vector<WaterLine> lines(static_cast<std::size_t>(count), axis_line(jet));
  for (int n = 0; n < count; ++n) {
    const double turn = 2.0 * std::numbers::pi * n / count;
    const double across = jet.width / 2.0 * std::cos(turn);
    const double aside = dimension == 2 ? 0.0 : jet.width / 2.0 * std::sin(turn);
    for (std::size_t a = 0; a < 3; ++a)
      lines[static_cast<std::size_t>(n)].origin[a] +=
          across * axes.across[a] + aside * axes.sideways[a];
  }
  return lines;
}

WayPart way_within(const Box& box, const WaterLine& line, int dimension) {
  double from = 0.0, to = endless;
  for (std::size_t a = 0; a < static_cast<std::size_t>(dimension); ++a) {
    const double rounding = 1e-9 * (box.maximum[a] - box.minimum[a]);
    if (std::abs(line.direction[a]) < 1e-12) {
      if (line.origin[a] < box.minimum[a] - rounding || line.origin[a] > box.maximum[a] + rounding)
        return {0.0, -endless};
      continue;
    }
    const double one = (box.minimum[a] - line.origin[a]) / line.direction[a];
    const double other = (box.maximum[a] - line.origin[a]) / line.direction[a];
    from = std::max(from, std::min(one, other));
    to = std::min(to, std::max(one, other));
  }
  return {from, to};
}

double way_into(const Body& body, const WaterLine& line, int dimension) {
  constexpr double most_steps = 2000.0, per_spacing = 4.0;
  const WayPart part = way_within(bounding_box(body.shape, dimension), line, dimension);
  const double from = part.begin, to = part.end;
  if (!(from <= to)) return endless;
  const auto is_inside = [&](double way) { return contains(body.shape, line.at(way), dimension); };
  if (is_inside(from)) return from;
  const double step = std::max(body.spacing / per_spacing, (to - from) / most_steps);
  double outside = from;
  while (!is_inside(std::min(outside + step, to)))
    if ((outside += step) >= to) return endless;
  return boundary_between(outside, std::min(outside + step, to), is_inside);
}

double time_beside(const Jet& jet, const std::vector<const Body*>& bodies, double longest,
                   int dimension) {
  constexpr double per_width = 4.0, most_steps = 1000.0;
  const double speed = traverse_speed(jet);
  if (!(speed > 0.0) || bodies.empty()) return 0.0;
  std::vector<WaterLine> first = lines_at_edge(jet, dimension);
  first.push_back(axis_line(jet));
  for (const WaterLine& line : first)
    if (meets_any(line, bodies, dimension)) return 0.0;
  const auto is_over = [&](double time) {
    return meets_any(axis_line(jet, time), bodies, dimension);
  };
  const double step = std::max(jet.width / per_width / speed, longest / most_steps);
  double time = 0.0;
  while (!is_over(std::min(time + step, longest)))
    if ((time += step) >= longest) return 0.0;
  const double edge = boundary_between(time, std::min(time + step, longest), is_over);
  double spacing = endless;
  for (const Body* body : bodies) spacing = std::min(spacing, body->spacing);
  const double behind = std::min(edge + 0.5 * spacing / speed, longest);
  return is_over(behind) ? behind : edge;  // it may only graze a body
}

}  // namespace kerf
