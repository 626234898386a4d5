// SPDX-License-Identifier: Apache-2.0
#include "output/moving_workpiece_flag.hpp"

#include <fmt/format.h>

#include "analysis/workpiece_motion.hpp"
#include "model/case.hpp"

namespace kerf {
namespace {

// Whether a body is at rest as the case states it: then the nozzle alone moves.
bool is_at_rest(const Body& body, int dimension) {
  return body.displacement[0].empty() && first_velocity(body, dimension) == Point{};
}

}  // namespace

std::optional<ValidityFlag> moving_workpiece_flag(const Case& description) {
  if (description.jets.empty()) return {};
  const double most = description.jets.front().width / 2.0;
  for (const Body& body : description.bodies) {
    if (body.role != Role::elastic || body.fixed || is_at_rest(body, description.dimension))
      continue;
    const double way = way_across_jet(description, body);
    if (!(way > most)) continue;
    return ValidityFlag{
        "moving_workpiece", ValidityFlag::State::warning, way, most,
        fmt::format("{} crosses the jet: the kerf and the verdict are those at the place of it at "
                    "which the jet aims at the start. Let the nozzle move instead.",
                    body.name)};
  }
  return {};
}

}  // namespace kerf
