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

}  // namespace

Metrics read_metrics(const std::string& result_json) {
  Metrics metrics;
  add(nlohmann::json::parse(result_json), "", metrics);
  return metrics;
}

std::optional<bool> cuts(const Metrics& metrics) {
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
