// SPDX-License-Identifier: Apache-2.0
#include "output/moving_workpiece_flag.hpp"

#include <fmt/format.h>

#include <cmath>

#include "analysis/jet_axis.hpp"
#include "geometry/shapes.hpp"
#include "model/case.hpp"
#include "model/expression.hpp"

namespace kerf {
namespace {

// Returns the velocity at the middle of a body at the start, m/s.
Point first_velocity(const Body& body, int dimension) {
  const Box box = bounding_box(body.shape, dimension);
  Point middle{}, velocity{};
  for (std::size_t a = 0; a < 3; ++a) middle[a] = (box.minimum[a] + box.maximum[a]) / 2.0;
  for (std::size_t a = 0; a < 3; ++a)
    velocity[a] = Expression(body.velocity[a], {"x", "y", "z"})(middle);
  return velocity;
}

}  // namespace

std::optional<ValidityFlag> moving_workpiece_flag(const Case& description) {
  if (description.jets.empty()) return {};
  const JetAxis jet(description.jets.front(), description.dimension);
  for (const Body& body : description.bodies) {
    if (body.role != Role::elastic || body.fixed) continue;
    const Point velocity = first_velocity(body, description.dimension);
    double across = 0.0, aside = 0.0;
    for (std::size_t a = 0; a < 3; ++a) {
      across += velocity[a] * jet.across[a];
      aside += velocity[a] * jet.sideways[a];
    }
    const double way = std::hypot(across, aside) * description.time.end;
    if (!(way > jet.width / 2.0)) continue;
    return ValidityFlag{
        "moving_workpiece", ValidityFlag::State::warning, way, jet.width / 2.0,
        fmt::format("{} crosses the jet: the kerf and the verdict are those at the place of it at "
                    "which the jet aims at the start. Let the nozzle move instead.",
                    body.name)};
  }
  return {};
}

}  // namespace kerf
