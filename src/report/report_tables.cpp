// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "output/ledger_table.hpp"
#include "report/html.hpp"
#include "report/json_number.hpp"
#include "report/report.hpp"

namespace kerf {
namespace {

using html::Row;
using Json = nlohmann::ordered_json;

std::string case_table(const Json& result) {
  const auto number = [&](const char* key) { return value_of(result.at(key)); };
  std::vector<Row> rows;
  const auto add = [&](const char* name, std::string value) {
    rows.push_back({name, std::move(value), ""});
  };
  if (number("jet_speed") > 0.0) {
    add("speed of the jet, V", html::quantity(number("jet_speed"), "m/s"));
    add("stagnation pressure, ρV²/2", html::quantity(number("stagnation_pressure"), "Pa"));
    add("particles across the jet", html::number(number("jet_resolution")));
    add("Mach number in the water", html::number(number("mach")));
  }
  if (number("rayleigh_speed") > 0.0) {
    add("Rayleigh wave speed, c<sub>R</sub>", html::quantity(number("rayleigh_speed"), "m/s"));
    add("shear wave speed, c<sub>s</sub>", html::quantity(number("shear_speed"), "m/s"));
    add("pressure wave speed, c<sub>p</sub>", html::quantity(number("longitudinal_speed"), "m/s"));
    add("V / c<sub>R</sub>", html::number(number("V_over_cR")));
    add("V / c<sub>p</sub>", html::number(number("V_over_cp")));
    add("Cauchy number, ρV²/E", html::number(number("cauchy_number")));
    add("front speed of two streams, V / (1 + √(ρ<sub>s</sub>/ρ<sub>w</sub>))",
        html::quantity(number("hydrodynamic_front_speed"), "m/s"));
  }
  add("end of the run", html::quantity(number("end_time"), "s"));
  add("steps", html::count(number("steps")));
  add("particles at the end", html::count(number("particles")));
  return html::table("Case in numbers", rows);
}

std::string cut_table(const Json& result) {
  const auto metres = [&](const char* name, const char* key, const char* remark) {
    return Row{name, html::quantity(value_of(result.at(key)), "m"), remark, key};
  };
  const auto number = [&](const char* name, const char* key) {
    return Row{name, html::count(value_of(result.at(key))), "", key};
  };
  return html::table(
      "Cut",
      {metres("depth of the water front", "front_depth", "below the point aimed at, along the jet"),
       metres("opening at half that depth", "kerf_width", "at the end, without whole solid"),
       metres("fractured width there", "fractured_width", ""),
       number("pieces over 5% of the workpiece", "pieces"),
       number("connected pieces of any size", "fragment_count")});
}

std::string ledger_table(const Json& result, int dimension) {
  std::vector<Row> rows;
  const Json& ledger = result.at("ledger");
  for (const LedgerTerm& term : ledger_terms()) {
    const Json& value = ledger.at(term.name);
    const std::string unit = extensive_unit(term.unit, dimension);
    std::string text;
    if (term.scalar != nullptr) {
      text = html::quantity(value_of(value), unit);
    } else {
      for (int k = 0; k < dimension; ++k)
        text += (k == 0 ? "" : "<br>") +
                html::quantity(value_of(value.at(static_cast<std::size_t>(k))), unit);
    }
    rows.push_back({fmt::format("<code>{}</code>", term.name), text, term.meaning});
  }
  for (const char* key : {"mass_error", "momentum_error", "energy_drift", "pressure_energy_gap"})
    rows.push_back({fmt::format("<code>{}</code>", key), html::number(value_of(result.at(key))),
                    "relative, see docs/results.md"});
  return html::table(dimension == 2 ? "Ledger, per metre of depth (x, y)" : "Ledger (x, y, z)",
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
  if (result.contains("device"))  // not in folders of earlier versions
    rows.push_back({"computed on", html::escape(result.at("device").get<std::string>()), ""});
  rows.push_back({"threads", html::count(value_of(result.at("threads"))), ""});
  rows.push_back({"pair interactions", html::number(value_of(result.at("pair_interactions"))), ""});
  return html::table("Computing time", rows);
}

}  // namespace

std::string report_tables(const Json& result, const Case& description) {
  std::string text = "<h2>Numbers</h2>\n<div class=\"tables\">\n" + case_table(result);
  if (!description.jets.empty()) text += cut_table(result);
  text += limits_table(result) + stages_table(result) + ledger_table(result, description.dimension);
  return text + fmt::format(
                    "</div>\n<footer>Kerf {}, compiled by {}. All numbers are in "
                    "<code>result.json</code>, their course in <code>series.csv</code>; open "
                    "<code>{}.vtkhdf.series</code> with ParaView to see every particle.</footer>\n",
                    html::escape(result.at("version").get<std::string>()),
                    html::escape(result.at("compiler").get<std::string>()),
                    html::escape(result.at("case").get<std::string>()));
}

}  // namespace kerf
