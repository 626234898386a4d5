// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/check_warnings.hpp"
#include "app/jet_way.hpp"
#include "geometry/beside_jet.hpp"
#include "geometry/jet_direction.hpp"
#include "machine/characteristic_speed.hpp"
#include "model/case.hpp"

namespace kerf {

namespace {

// Warns of a jet that opens, or whose water arrives, when the run has ended at `end`, s.
void warn_of_late_water(const Jet& jet, double end, std::vector<std::string>& warnings) {
  const double arrival = jet.start + jet.standoff / jet.speed;
  if (jet.start >= end)
    warnings.push_back(
        fmt::format("the jet \"{}\" opens at {:.4g} s, when the run has ended ({:.4g} s): it emits "
                    "no water. Give it an earlier start, or the run a later end",
                    jet.name, jet.start, end));
  else if (arrival >= end)
    warnings.push_back(
        fmt::format("the water of the jet \"{}\" comes to the point at which it aims after {:.4g} "
                    "s, when the run has ended ({:.4g} s). Give the run a later end",
                    jet.name, arrival, end));
}

// Warns of a nozzle that travels onto a body from beside it: what is measured is the kerf where the
// jet aims at the start (analysis/kerf.hpp), and there is nothing.
void warn_of_later_meeting(const Jet& jet, const std::vector<const Body*>& targets,
                           const Case& description, std::vector<std::string>& warnings) {
  constexpr double most_places = 200.0;
  const double speed = traverse_speed(jet), end = description.time.end;
  const double step = std::max(jet.width / 4.0 / speed, end / most_places);
  for (double time = step; time <= end; time += step) {
    Jet later = jet;
    for (std::size_t a = 0; a < 3; ++a) later.position[a] += time * jet.traverse[a];
    for (const Body* body : targets) {
      if (!is_in_way(later, *body, description.dimension)) continue;
      warnings.push_back(fmt::format(
          "the nozzle of the jet \"{}\" travels onto \"{}\" from beside it, which it meets after "
          "{:.3g} s: the verdict and the kerf are those at the place at which it aims at the "
          "start, where there is nothing to cut, so that nothing is measured. Choose a position "
          "over the body, {:.3g} m or more along its way",
          jet.name, body->name, time, speed * time));
      return;
    }
  }
}

}  // namespace

std::vector<std::string> aim_warnings(const Case& description) {
  std::vector<std::string> warnings;
  for (const Jet& jet : description.jets) warn_of_late_water(jet, description.time.end, warnings);
  std::vector<const Body*> targets;
  for (const Body& body : description.bodies)
    if (body.role == Role::elastic && !body.fixed) targets.push_back(&body);
  const bool may_meet_later = fastest_body(description) > 0.0 || description.gravity != Point{};
  if (may_meet_later || targets.empty()) return warnings;
  for (const Jet& jet : description.jets) {
    const auto meets = [&](const Body* body) {
      return is_in_way(jet, *body, description.dimension);
    };
    if (std::any_of(targets.begin(), targets.end(), meets)) continue;
    if (traverse_speed(jet) > 0.0) {
      warn_of_later_meeting(jet, targets, description, warnings);
      continue;
    }
    const BesideJet beside = beside_jet(jet, targets, description.dimension, most_tested);
    const std::string nearest = beside.body
                                    ? fmt::format("its water is {:.3g} m from the nearest, \"{}\"",
                                                  beside.distance, beside.body->name)
                                    : std::string("all lie behind its nozzle");
    warnings.push_back(fmt::format(
        "the jet \"{}\" passes beside all bodies that it could cut: none is within half "
        "its width of its axis, and {}. Correct its position or its angle",
        jet.name, nearest));
  }
  return warnings;
}

}  // namespace kerf
