// SPDX-License-Identifier: Apache-2.0
#include "study/metrics.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "output/result_metrics.hpp"

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
    if (path == left_whole_metric) metrics[path] = flag.value("value", 0.0);
  }
}

bool is_flag(std::string_view name) {
  return name == still_cutting_metric || name == not_reached_metric || name == left_whole_metric;
}

bool is_number(const ResultMetric& metric) {
  return metric.form == ResultMetric::Form::value && metric.kind != MetricKind::text &&
         metric.kind != MetricKind::numbers && !metric.name.starts_with("balance.");
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

std::string why_no_number(const std::string& name) {
  if (is_flag(name)) return "";
  const ResultMetric* metric = find_result_metric(name);
  if (!metric) return fmt::format("there is no metric \"{}\"", name);
  if (is_number(*metric)) return "";
  if (name.starts_with("balance."))
    return "the terms of the balance describe the computation and are kept with each run only";
  const bool is_text =
      metric->form == ResultMetric::Form::value && metric->kind == MetricKind::text;
  return fmt::format("\"{}\" is {} and no number", name, is_text ? "a text" : "a list or table");
}

std::vector<std::string> number_names() {
  std::vector<std::string> names;
  for (const ResultMetric& metric : result_metrics())
    if (is_number(metric)) names.push_back(metric.name);
  return names;
}

bool is_not_reached(const Metrics& metrics) {
  return is_raised(metrics, not_reached_metric);
}

bool was_still_cutting(const Metrics& metrics) {
  return is_raised(metrics, still_cutting_metric);
}

double left_whole(const Metrics& metrics) {
  const auto found = metrics.find(std::string(left_whole_metric));
  return found == metrics.end() ? 0.0 : found->second;
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
