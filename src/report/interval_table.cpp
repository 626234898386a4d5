// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "output/result_metrics.hpp"
#include "report/html.hpp"
#include "report/metric_rows.hpp"
#include "report/report_parts.hpp"

namespace kerf {

namespace {

using Json = nlohmann::ordered_json;

std::string in_unit(double value, const std::string& unit) {
  return unit == "1" ? html::number(value, 3) : html::quantity(value, unit, 3);
}

html::Row row_of(const Json& interval) {
  const std::string unit = interval.at("unit").get<std::string>();
  const auto shown = [&](const char* key) { return in_unit(value_of(interval.at(key)), unit); };
  const std::string metric = interval.at("metric").get<std::string>();
  const std::string layout = interval.at("layout").is_null() ? "not varied" : shown("layout");
  std::string remark =
      fmt::format("spacing {}, layout {}; {} of {} runs", shown("spacing"), layout,
                  interval.at("rule").get<std::string>(), interval.at("runs").get<int>());
  return {label_html(metric_label(metric)),
          fmt::format("{} [{}, {}]", shown("value"), shown("low"), shown("high")), remark};
}

}  // namespace

std::string intervals_table(const Json& result) {
  const auto intervals = result.find("intervals");
  if (intervals == result.end() || !result.contains("kerf")) return "";
  if (intervals->empty())
    return "<p class=\"remark\">How far these numbers depend on spacing and layout was not "
           "examined; "
           "<code>kerf run CASE --converge --resume</code> does.</p>\n";
  std::vector<html::Row> rows;
  for (const Json& interval : *intervals) rows.push_back(row_of(interval));
  return "<h3>What the resolution and the layout leave open</h3>\n" +
         html::table("Value [low, high] of the headline numbers", rows) +
         "<p class=\"remark\">Errors of the model and of material data are not part of these "
         "intervals.</p>\n";
}

}  // namespace kerf
