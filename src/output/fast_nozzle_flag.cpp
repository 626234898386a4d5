// SPDX-License-Identifier: Apache-2.0
#include "output/fast_nozzle_flag.hpp"

#include <fmt/format.h>

#include <cstddef>

#include "geometry/jet_direction.hpp"
#include "machine/machine_jet.hpp"
#include "model/case.hpp"
#include "output/readable.hpp"

namespace kerf {
namespace {

struct FastNozzle {
  double feed = 0.0, jet_speed = 0.0;  // m/s
  std::string sentence;
};

// A pressure that no pump is set to, but that `mPa` for `MPa` gives.
std::string pressure_hint(double pressure) {
  constexpr double least = 1e3;  // Pa
  return pressure < least ? fmt::format(" ({} in the case; mPa is millipascal, MPa megapascal)",
                                        readable(pressure, "Pa"))
                          : "";
}

std::optional<FastNozzle> of_machine(const Machine& machine, const Jet& jet) {
  if (!(machine.traverse_speed > jet.speed)) return {};
  return FastNozzle{
      machine.traverse_speed, jet.speed,
      fmt::format(
          "machine.traverse_speed = {}: the nozzle travels faster than its jet, whose speed "
          "by machine.pressure is {}. Allowed: a feed far below the speed of the jet. Check "
          "the units: lower the feed or raise the pressure{}",
          readable(machine.traverse_speed, "m/s"), readable(jet.speed, "m/s"),
          pressure_hint(machine.pressure))};
}

std::optional<FastNozzle> of_jet(const Jet& jet, std::size_t index) {
  const double feed = traverse_speed(jet);
  if (!(feed > jet.speed)) return {};
  return FastNozzle{
      feed, jet.speed,
      fmt::format("jet[{}].traverse: the nozzle travels at {}, faster than its jet, of which "
                  "jet[{}].speed = {}. Allowed: a traverse far below the speed of the jet. Check "
                  "the units: lower the traverse or raise the speed",
                  index + 1, readable(feed, "m/s"), index + 1, readable(jet.speed, "m/s"))};
}

std::optional<FastNozzle> find_fast_nozzle(const Case& description) {
  const auto& jets = description.jets;
  for (std::size_t index = 0; index < jets.size(); ++index) {
    const bool is_of_machine =
        description.machine && index + 1 == jets.size() && jets[index].name == machine_jet_name;
    const auto found =
        is_of_machine ? of_machine(*description.machine, jets[index]) : of_jet(jets[index], index);
    if (found) return found;
  }
  return {};
}

}  // namespace

std::optional<std::string> fast_nozzle(const Case& description) {
  const auto found = find_fast_nozzle(description);
  return found ? std::optional<std::string>(found->sentence) : std::nullopt;
}

std::optional<ValidityFlag> fast_nozzle_flag(const Case& description) {
  const auto found = find_fast_nozzle(description);
  if (!found) return {};
  return ValidityFlag{"fast_nozzle", ValidityFlag::State::warning, found->feed, found->jet_speed,
                      found->sentence + "."};
}

}  // namespace kerf
