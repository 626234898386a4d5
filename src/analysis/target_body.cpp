// SPDX-License-Identifier: Apache-2.0
#include "analysis/target_body.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "analysis/jet_axis.hpp"
#include "core/boundary_between.hpp"
#include "geometry/shapes.hpp"
#include "model/case.hpp"

namespace kerf {
namespace {

constexpr double endless = std::numeric_limits<double>::infinity();

// A line along the water of a jet, from the exit of its nozzle on.
struct WaterLine {
  Point origin{}, direction{};  // m, unit vector

  Point at(double way) const {
    Point x = origin;
    for (std::size_t a = 0; a < 3; ++a) x[a] += way * direction[a];
    return x;
  }
};

// Returns the bodies that a jet or a moving body can hit.
std::vector<const Body*> targets_of(const Case& description) {
  std::vector<const Body*> free, fixed;
  for (const Body& body : description.bodies)
    if (body.role == Role::elastic) (body.fixed ? fixed : free).push_back(&body);
  return free.empty() ? fixed : free;
}

// Returns the way along the line until it enters a body, m; infinite where it passes beside it.
double way_into(const Body& body, const WaterLine& line, int dimension) {
  constexpr double most_steps = 2000.0, per_spacing = 4.0;
  const Box box = bounding_box(body.shape, dimension);
  double from = 0.0, to = endless;
  for (std::size_t a = 0; a < static_cast<std::size_t>(dimension); ++a) {
    const double rounding = 1e-9 * (box.maximum[a] - box.minimum[a]);
    if (std::abs(line.direction[a]) < 1e-12) {
      if (line.origin[a] < box.minimum[a] - rounding || line.origin[a] > box.maximum[a] + rounding)
        return endless;
      continue;
    }
    const double one = (box.minimum[a] - line.origin[a]) / line.direction[a];
    const double other = (box.maximum[a] - line.origin[a]) / line.direction[a];
    from = std::max(from, std::min(one, other));
    to = std::min(to, std::max(one, other));
  }
  if (!(from <= to)) return endless;
  const auto is_inside = [&](double way) { return contains(body.shape, line.at(way), dimension); };
  if (is_inside(from)) return from;
  const double step = std::max(body.spacing / per_spacing, (to - from) / most_steps);
  double outside = from;
  while (!is_inside(std::min(outside + step, to)))
    if ((outside += step) >= to) return endless;
  return boundary_between(outside, std::min(outside + step, to), is_inside);
}

// Returns the body that a line enters first, the softest of those at one depth; null without any.
const Body* first_on(const WaterLine& line, const std::vector<const Body*>& bodies,
                     const Case& description) {
  const auto stiffness = [&](const Body& body) {
    return description.materials.at(static_cast<std::size_t>(body.material)).youngs_modulus;
  };
  const Body* first = nullptr;
  double least = endless;
  for (const Body* body : bodies) {
    const double way = way_into(*body, line, description.dimension);
    if (std::isinf(way)) continue;
    const double same = 1e-3 * body->spacing;
    const bool is_nearer = way < least - same;
    const bool is_softer =
        first != nullptr && way < least + same && stiffness(*body) < stiffness(*first);
    if (!is_nearer && !is_softer) continue;
    first = body;
    least = std::min(least, way);
  }
  return first;
}

// Returns the lines at the edge of a jet.
std::vector<WaterLine> lines_at_edge(const WaterLine& axis, const JetAxis& jet) {
  const int count = jet.sideways == Point{} ? 2 : 8;
  std::vector<WaterLine> lines(static_cast<std::size_t>(count), axis);
  for (int n = 0; n < count; ++n) {
    const double turn = 2.0 * std::numbers::pi * n / count;
    for (std::size_t a = 0; a < 3; ++a)
      lines[static_cast<std::size_t>(n)].origin[a] +=
          jet.width / 2.0 * (std::cos(turn) * jet.across[a] + std::sin(turn) * jet.sideways[a]);
  }
  return lines;
}

// Returns the axes of a nozzle that travels until the end of the run, from the start on.
std::vector<WaterLine> lines_on_way(const WaterLine& axis, const JetAxis& jet, double end) {
  constexpr int count = 200;
  std::vector<WaterLine> lines;
  if (jet.travel == Point{} || !std::isfinite(end)) return lines;
  const double moving = std::max(0.0, end - jet.moves_from);
  for (int n = 1; n <= count; ++n) {
    lines.push_back(axis);
    for (std::size_t a = 0; a < 3; ++a)
      lines.back().origin[a] += moving * n / count * jet.travel[a];
  }
  return lines;
}

}  // namespace

const Body* target_body(const Case& description) {
  const std::vector<const Body*> bodies = targets_of(description);
  if (bodies.size() < 2 || description.jets.empty())
    return bodies.empty() ? nullptr : bodies.front();
  const auto fastest =
      std::max_element(description.jets.begin(), description.jets.end(),
                       [](const Jet& a, const Jet& b) { return a.speed < b.speed; });
  const JetAxis jet(*fastest, description.dimension);
  const WaterLine axis{jet.point_at(-jet.standoff, 0.0), jet.along};
  std::vector<WaterLine> lines{axis};
  for (const WaterLine& line : lines_at_edge(axis, jet)) lines.push_back(line);
  for (const WaterLine& line : lines_on_way(axis, jet, description.time.end)) lines.push_back(line);
  for (const WaterLine& line : lines)
    if (const Body* body = first_on(line, bodies, description)) return body;
  return bodies.front();
}

}  // namespace kerf
