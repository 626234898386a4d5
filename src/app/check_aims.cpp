// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/check_warnings.hpp"
#include "app/jet_way.hpp"
#include "geometry/beside_jet.hpp"
#include "geometry/jet_direction.hpp"
#include "geometry/water_line.hpp"
#include "machine/characteristic_speed.hpp"
#include "model/case.hpp"
#include "output/falling_jet_flag.hpp"
#include "output/fast_nozzle_flag.hpp"
#include "output/readable.hpp"

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

// Warns of a dwell of a nozzle that has no traverse to wait for.
void warn_of_idle_dwell(const Case& description, const Jet& jet,
                        std::vector<std::string>& warnings) {
  const double speed =
      description.machine ? description.machine->traverse_speed : traverse_speed(jet);
  if (jet.dwell > 0.0 && speed == 0.0)
    warnings.push_back(
        fmt::format("the dwell of the jet \"{}\", {}, changes nothing, because its nozzle does not "
                    "move afterwards. Remove it, or add {}",
                    jet.name, readable(jet.dwell, "s"),
                    description.machine ? "machine.traverse_speed" : "a traverse"));
}

// Says how near the water comes to a body. A distance that is rounding is none.
std::string nearest_words(const BesideJet& beside) {
  constexpr double rounding = 1e-6;  // spacings
  if (beside.body == nullptr) return "all lie behind its nozzle";
  if (beside.distance < rounding * beside.body->spacing)
    return fmt::format("its water flows along the nearest, \"{}\"", beside.body->name);
  return fmt::format("its water is {:.3g} m from the nearest, \"{}\"", beside.distance,
                     beside.body->name);
}

// Tells of a nozzle that starts beside the workpiece and comes over it.
std::string entry_sentence(const Jet& jet, const std::vector<const Body*>& targets, int dimension) {
  const WaterLine axis = axis_line(jet, jet.time_beside);
  const auto met = std::find_if(targets.begin(), targets.end(), [&](const Body* body) {
    return std::isfinite(way_into(*body, axis, dimension));
  });
  return fmt::format(
      "the nozzle of the jet \"{}\" starts beside the workpiece, and its axis comes over \"{}\" "
      "after {}: depths, the kerf and the verdict count from there on",
      jet.name, (*met)->name, readable(jet.start + jet.dwell + jet.time_beside, "s"));
}

}  // namespace

std::vector<std::string> aim_warnings(const Case& description) {
  std::vector<std::string> warnings;
  for (const Jet& jet : description.jets) warn_of_late_water(jet, description.time.end, warnings);
  for (const Jet& jet : description.jets) warn_of_idle_dwell(description, jet, warnings);
  if (const auto text = fast_nozzle(description)) warnings.push_back(*text);
  if (const auto text = falling_jet(description)) warnings.push_back(*text);
  std::vector<const Body*> targets;
  for (const Body& body : description.bodies)
    if (body.role == Role::elastic && !body.fixed) targets.push_back(&body);
  const bool may_meet_later = fastest_body(description) > 0.0 || description.gravity != Point{};
  if (may_meet_later || targets.empty()) return warnings;
  for (const Jet& jet : description.jets) {
    const auto meets = [&](const Body* body) {
      return is_in_way(jet, *body, description.dimension);
    };
    if (jet.time_beside > 0.0)
      warnings.push_back(entry_sentence(jet, targets, description.dimension));
    const bool meets_one = std::any_of(targets.begin(), targets.end(), meets);
    if (meets_one || traverse_speed(jet) > 0.0) continue;
    const BesideJet beside = beside_jet(jet, targets, description.dimension, most_tested);
    const std::string nearest = nearest_words(beside);
    warnings.push_back(fmt::format(
        "the jet \"{}\" passes beside all bodies that it could cut: none is within half "
        "its width of its axis, and {}. Correct its position or its angle",
        jet.name, nearest));
  }
  return warnings;
}

}  // namespace kerf
