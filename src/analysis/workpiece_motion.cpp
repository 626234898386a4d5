// SPDX-License-Identifier: Apache-2.0
#include "analysis/workpiece_motion.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/workpiece.hpp"
#include "geometry/shapes.hpp"
#include "model/case.hpp"
#include "model/expression.hpp"

namespace kerf {
namespace {

// Returns where a body has moved until a time, s; m from its place at the start.
Point displacement_of(const Body& body, int dimension, double time) {
  const Point velocity = first_velocity(body, dimension);
  const bool is_driven = std::any_of(body.displacement.begin(), body.displacement.end(),
                                     [](const std::string& text) { return !text.empty(); });
  Point moved{};
  for (std::size_t a = 0; a < 3; ++a)
    if (!is_driven)
      moved[a] = velocity[a] * time;
    else if (!body.displacement[a].empty())
      moved[a] = Expression(body.displacement[a], {"t"}).evaluate(time);
  return moved;
}

}  // namespace

std::array<double, 3> first_velocity(const Body& body, int dimension) {
  const Box box = bounding_box(body.shape, dimension);
  Point middle{}, velocity{};
  for (std::size_t a = 0; a < 3; ++a) middle[a] = (box.minimum[a] + box.maximum[a]) / 2.0;
  for (std::size_t a = 0; a < 3; ++a)
    velocity[a] = Expression(body.velocity[a], {"x", "y", "z"})(middle);
  return velocity;
}

std::array<double, 3> drift_of(const Case& description, const Workpiece& workpiece) {
  Point drift{};
  bool is_first = true;
  for (const WorkpieceBody& described : workpiece.bodies) {
    if (!described.is_in_way) continue;
    const Point velocity =
        first_velocity(description.bodies[described.body], description.dimension);
    if (!is_first && velocity != drift) return {};
    drift = velocity;
    is_first = false;
  }
  return drift;
}

double way_across_jet(const Case& description, const Body& body) {
  constexpr int samples = 64;  // of the run: a displacement may return
  const JetAxis jet(description.jets.front(), description.dimension);
  double farthest = 0.0;
  for (int n = 1; n <= samples; ++n) {
    const double time = description.time.end * n / samples;
    const Point moved = displacement_of(body, description.dimension, time);
    const Point start = jet.point_at(0.0, 0.0), nozzle = jet.point_at(0.0, time);
    double across = 0.0, aside = 0.0;
    for (std::size_t a = 0; a < 3; ++a) {
      const double way = moved[a] - (nozzle[a] - start[a]);
      across += way * jet.across[a];
      aside += way * jet.sideways[a];
    }
    farthest = std::max(farthest, std::hypot(across, aside));
  }
  return farthest;
}

}  // namespace kerf
