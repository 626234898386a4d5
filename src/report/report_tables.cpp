// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "model/case.hpp"
#include "output/balance_metrics.hpp"
#include "report/html.hpp"
#include "report/metric_rows.hpp"
#include "report/report_parts.hpp"

namespace kerf {
namespace {

using html::Row;
using Json = nlohmann::ordered_json;

std::string case_table(const Json& result) {
  std::vector<Row> rows;
  const auto add = [&](const std::vector<const char*>& names) {
    for (const char* name : names) rows.push_back(metric_row(result, name));
  };
  if (value_of(result.at("jet_speed")) > 0.0)
    add({"jet_speed", "stagnation_pressure", "jet_resolution", "mach"});
  if (value_of(result.at("rayleigh_speed")) > 0.0)
    add({"rayleigh_speed", "shear_speed", "longitudinal_speed", "V_over_cR", "V_over_cp",
         "cauchy_number", "hydrodynamic_front_speed"});
  add({"end_time", "steps", "particles"});
  return html::table("Case in numbers", rows);
}

std::string cut_table(const Json& result) {
  std::vector<Row> rows;
  for (const char* name :
       {"front_depth", "kerf_width", "fractured_width", "pieces", "fragment_count"})
    rows.push_back(metric_row(result, name, html::escape(find_result_metric(name)->meaning)));
  return html::table("Cut", rows);
}

std::string balance_table(const Json& result, int dimension) {
  std::vector<Row> rows;
  const Json& balance = result.at("balance");
  for (const Metric<Balance>& term : balance_terms()) {
    const Json& value = balance.at(term.name);
    const std::string unit = term.unit.in(dimension);
    std::string text;
    if (term.kind == MetricKind::number) {
      text = html::quantity(value_of(value), unit);
    } else {
      for (int k = 0; k < dimension; ++k)
        text += (k == 0 ? "" : "<br>") +
                html::quantity(value_of(value.at(static_cast<std::size_t>(k))), unit);
    }
    rows.push_back({fmt::format("<code>{}</code>", term.name), text, term.meaning});
  }
  for (const Metric<Balance>& error : balance_errors())
    rows.push_back({fmt::format("<code>{}</code>", error.name),
                    html::number(value_of(result.at(error.name))), error.meaning});
  return html::table(dimension == 2 ? "Balance, per metre of depth (x, y)" : "Balance (x, y, z)",
                     rows);
}

std::string limits_table(const Json& result) {
  std::vector<Row> rows;
  const double steps = std::max(1.0, value_of(result.at("steps")));
  for (const auto& [name, times] : result.at("time_step_limits").items())
    rows.push_back({html::escape(name), html::count(value_of(times)),
                    fmt::format("{:.3g}% of the steps", 100.0 * value_of(times) / steps)});
  return html::table("What limited the time step", rows);
}

std::string stages_table(const Json& result) {
  std::vector<Row> rows;
  double sum = 0.0;
  for (const auto& [name, seconds] : result.at("stage_times").items()) sum += value_of(seconds);
  for (const auto& [name, seconds] : result.at("stage_times").items())
    rows.push_back({html::escape(name), html::quantity(value_of(seconds), "s"),
                    fmt::format("{:.3g}%", 100.0 * value_of(seconds) / std::max(sum, 1e-300))});
  rows.push_back({"whole run", html::quantity(value_of(result.at("wall_time")), "s"), ""});
  if (result.contains("device"))  // earlier versions do not write it
    rows.push_back({"computed on", html::escape(result.at("device").get<std::string>()), ""});
  rows.push_back({"threads", html::count(value_of(result.at("threads"))), ""});
  rows.push_back({"pair interactions", html::number(value_of(result.at("pair_interactions"))), ""});
  return html::table("Computing time", rows);
}

}  // namespace

std::string report_tables(const Json& result, const Case& description) {
  std::string text = "<h2>Numbers</h2>\n<div class=\"tables\">\n" + case_table(result);
  if (!description.jets.empty()) text += cut_table(result);
  text +=
      "</div>\n<details class=\"balance\"><summary>Balance of mass, momentum and energy, time step "
      "and computing time</summary>\n<div class=\"tables\">\n" +
      balance_table(result, description.dimension) + limits_table(result) + stages_table(result) +
      "</div></details>\n";
  return text + fmt::format(
                    "<footer>Kerf {}, compiled by {}. All numbers are in "
                    "<code>result.json</code>, their course in <code>series.csv</code>; open "
                    "<code>{}.vtkhdf.series</code> with ParaView to see every particle.</footer>\n",
                    html::escape(result.at("version").get<std::string>()),
                    html::escape(result.at("compiler").get<std::string>()),
                    html::escape(result.at("case").get<std::string>()));
}

}  // namespace kerf
