// SPDX-License-Identifier: Apache-2.0
#include "analysis/target_body.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "geometry/jet_direction.hpp"
#include "geometry/water_line.hpp"
#include "model/case.hpp"

namespace kerf {
namespace {

constexpr double endless = std::numeric_limits<double>::infinity();

// Returns the bodies that a jet or a moving body can hit.
std::vector<const Body*> targets_of(const Case& description) {
  std::vector<const Body*> free, fixed;
  for (const Body& body : description.bodies)
    if (body.role == Role::elastic) (body.fixed ? fixed : free).push_back(&body);
  return free.empty() ? fixed : free;
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

// Returns the axes of a nozzle that travels until the end of the run, from the start on.
std::vector<WaterLine> lines_on_way(const Jet& jet, double end) {
  constexpr int count = 200;
  std::vector<WaterLine> lines;
  if (!(traverse_speed(jet) > 0.0) || !std::isfinite(end)) return lines;
  const double moving = std::max(0.0, end - jet.start - jet.dwell);
  for (int n = 1; n <= count; ++n) lines.push_back(axis_line(jet, moving * n / count));
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
  std::vector<WaterLine> lines{axis_line(*fastest)};
  for (const auto& more : {lines_at_edge(*fastest, description.dimension),
                           lines_on_way(*fastest, description.time.end)})
    lines.insert(lines.end(), more.begin(), more.end());
  for (const WaterLine& line : lines)
    if (const Body* body = first_on(line, bodies, description)) return body;
  return bodies.front();
}

}  // namespace kerf
