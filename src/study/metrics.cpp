// SPDX-License-Identifier: Apache-2.0
#include "study/metrics.hpp"

#include <nlohmann/json.hpp>

namespace kerf {

namespace {

void add(const nlohmann::json& object, const std::string& prefix, Metrics& metrics) {
  for (const auto& [name, value] : object.items()) {
    const std::string path = prefix.empty() ? name : prefix + "." + name;
    const bool describes_the_run =
        path == "balance" || path == "time_step_limits" || path == "stage_times";
    if (value.is_object() && !describes_the_run) add(value, path, metrics);
    if (value.is_number()) metrics[path] = value.get<double>();
    if (value.is_boolean()) metrics[path] = value.get<bool>() ? 1.0 : 0.0;
  }
}

void add_flags(const nlohmann::json& result, Metrics& metrics) {
  const auto flags = result.find("validity");
  if (flags == result.end()) return;
  for (const auto& flag : *flags) {
    const std::string path = "validity." + flag.at("name").get<std::string>();
    if (path == still_cutting_metric || path == not_reached_metric) metrics[path] = 1.0;
  }
}

bool is_raised(const Metrics& metrics, std::string_view flag) {
  return metrics.contains(std::string(flag));
}

}  // namespace

Metrics read_metrics(const std::string& result_json) {
  const nlohmann::json result = nlohmann::json::parse(result_json);
  Metrics metrics;
  add(result, "", metrics);
  add_flags(result, metrics);
  return metrics;
}

bool is_not_reached(const Metrics& metrics) {
  return is_raised(metrics, not_reached_metric);
}

bool was_still_cutting(const Metrics& metrics) {
  return is_raised(metrics, still_cutting_metric);
}

std::optional<bool> cuts(const Metrics& metrics) {
  if (is_not_reached(metrics)) return std::nullopt;
  for (const char* name : {"exposure.cuts", "cut_through"})
    if (const auto found = metrics.find(name); found != metrics.end()) return found->second > 0.5;
  return std::nullopt;
}

bool may_cut(const Metrics& metrics) {
  const auto certain = metrics.find("exposure.cuts"), possible = metrics.find("exposure.may_cut");
  return certain != metrics.end() && certain->second < 0.5 && possible != metrics.end() &&
         possible->second > 0.5;
}

}  // namespace kerf
