// SPDX-License-Identifier: Apache-2.0
#include "report/metric_rows.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "core/error.hpp"

namespace kerf {
namespace {

using Json = nlohmann::ordered_json;

// "J/m3" as "J/m³".
std::string with_raised_powers(std::string unit) {
  for (const auto& [digit, raised] : {std::pair{'2', "²"}, std::pair{'3', "³"}})
    for (std::size_t at; (at = unit.find(digit)) != std::string::npos;) unit.replace(at, 1, raised);
  return unit;
}

std::string number_html(const std::string& unit, double value, int digits) {
  if (unit == "1") return html::number(value, digits);
  if (unit == "rad") return html::degrees(value);
  const double factor = unit.starts_with("m3") ? 1e9 : unit.starts_with("m2") ? 1e6 : 0.0;
  if (factor > 0.0)
    return html::number(factor * value, digits) + "\u202fm" + with_raised_powers(unit);
  return html::quantity(value, with_raised_powers(unit), digits);
}

// Returns the number of a metric; not a number where there is none.
double number_in(const Json& result, const ResultMetric& metric) {
  const Json* value = find_value(result, metric.name);
  return value != nullptr && value->is_number() ? value->get<double>()
                                                : std::numeric_limits<double>::quiet_NaN();
}

std::string written(const Json& result, const ResultMetric& metric, double number, int digits) {
  if (metric.kind == MetricKind::count) return html::count(number);
  if (metric.unit.is_share) return html::percent(number);
  return number_html(metric.unit.in(result.at("dimension").get<int>()), number, digits);
}

}  // namespace

const Json* find_value(const Json& result, const std::string& name) {
  const std::size_t dot = name.find('.');
  const auto found = result.find(name.substr(0, dot));
  if (found == result.end()) return nullptr;
  return dot == std::string::npos ? &*found : find_value(*found, name.substr(dot + 1));
}

std::string label_html(const std::string& label) {
  std::string text;
  const std::string safe = html::escape(label);
  for (std::size_t i = 0; i < safe.size(); ++i) {
    const bool is_index = safe[i] == '_' && i + 1 < safe.size();
    text += is_index ? "<sub>" + safe.substr(++i, 1) + "</sub>" : safe.substr(i, 1);
  }
  return text;
}

std::string value_html(const Json& result, const ResultMetric& metric, int digits) {
  const Json* value = find_value(result, metric.name);
  if (value != nullptr && value->is_string()) return html::escape(value->get<std::string>());
  const double number = number_in(result, metric);
  return std::isfinite(number) ? written(result, metric, number, digits) : "—";
}

std::string difference_html(const Json& first, const Json& second, const ResultMetric& metric,
                            int digits) {
  const double before = number_in(first, metric), after = number_in(second, metric);
  if (!std::isfinite(before) || !std::isfinite(after)) return "";
  if (before == after) return "0";
  const char* sign = after > before ? "+" : "−";
  if (metric.unit.is_share)
    return fmt::format("{}{} percentage points", sign,
                       html::number(100.0 * std::abs(after - before), 3));
  const std::string size = sign + written(first, metric, std::abs(after - before), digits);
  if (before == 0.0) return size;
  return fmt::format("{} ({}{})", size, sign, html::percent(std::abs((after - before) / before)));
}

html::Row metric_row(const Json& result, const std::string& name, std::string remark) {
  const ResultMetric* metric = find_result_metric(name);
  require(metric != nullptr, "a row of the report is a metric");
  return {label_html(metric->label), value_html(result, *metric), std::move(remark), name};
}

}  // namespace kerf
