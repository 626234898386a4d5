// SPDX-License-Identifier: Apache-2.0
#include "study/metrics.hpp"

#include <array>
#include <nlohmann/json.hpp>
#include <utility>

namespace kerf {

namespace {

void add(const nlohmann::json& object, const std::string& prefix, Metrics& metrics) {
  for (const auto& [name, value] : object.items()) {
    const std::string path = prefix.empty() ? name : prefix + "." + name;
    const bool describes_the_run =
        path == "ledger" || path == "time_step_limits" || path == "stage_times";
    if (value.is_object() && !describes_the_run) add(value, path, metrics);
    if (value.is_number()) metrics[path] = value.get<double>();
    if (value.is_boolean()) metrics[path] = value.get<bool>() ? 1.0 : 0.0;
  }
}

// By the end of the name, the first that fits.
constexpr std::pair<std::string_view, std::string_view> units_by_ending[] = {
    {"specific_energy", "J/m3"},
    {"stagnation_pressure", "Pa"},
    {"hammer_pressure", "Pa"},
    {"machine.pressure", "Pa"},
    {"speed", "m/s"},
    {"depth", "m"},
    {"width", "m"},
    {"below", "m"},
    {"lag", "m"},
    {"thickness", "m"},
    {"damaged_zone", "m"},
    {"diameter", "m"},
    {"standoff", "m"},
    {"taper", "rad"},
    {"angle", "rad"},
    {"time", "s"},
};

}  // namespace

Metrics read_metrics(const std::string& result_json) {
  Metrics metrics;
  add(nlohmann::json::parse(result_json), "", metrics);
  return metrics;
}

std::string_view metric_unit(std::string_view name) {
  for (const auto& [ending, unit] : units_by_ending)
    if (name.ends_with(ending)) return unit;
  return "";
}

}  // namespace kerf
