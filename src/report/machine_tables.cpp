// SPDX-License-Identifier: Apache-2.0
// This file writes the tables of the workpiece and of the machine's setting.
#include <fmt/format.h>

#include "analysis/exposure.hpp"
#include "model/case.hpp"
#include "report/html.hpp"
#include "report/metric_rows.hpp"
#include "report/report_parts.hpp"

namespace kerf {
namespace {

using html::Row;
using Json = nlohmann::ordered_json;

// Collects rows of the machine; a row is omitted if result.json does not have its number.
class MachineRows {
 public:
  explicit MachineRows(const Json& result) : result_(result) {}

  double of(const std::string& key) const {
    return value_of(*find_value(result_, "machine." + key));
  }
  void add(const std::string& key, std::string remark = {}) {
    const Json* value = find_value(result_, "machine." + key);
    if (value != nullptr && value->is_number())
      rows_.push_back(metric_row(result_, "machine." + key, std::move(remark)));
  }
  void add_flow() {
    const int dimension = result_.at("dimension").get<int>();
    const double flow = of("flow_rate");
    add("flow_rate",
        dimension == 2 ? html::number(60.0 * flow) + "\u202fL/min per mm of depth" : "");
    rows_.back().value = html::flow_rate(flow, dimension);
  }
  std::vector<Row> rows() && { return std::move(rows_); }

 private:
  const Json& result_;
  std::vector<Row> rows_;
};

void add_orifice(MachineRows& rows, const std::string& type) {
  rows.add("pressure");
  rows.add("orifice_diameter", html::escape(type));
  for (const char* key : {"orifice_length", "cone_angle", "fan_angle", "velocity_coefficient",
                          "discharge_coefficient", "contraction"})
    rows.add(key);
}

void add_jet(MachineRows& rows) {
  rows.add("jet_speed");
  rows.add("jet_width");
  rows.add_flow();
  rows.add("power");
  rows.add("stagnation_pressure");
  rows.add("hammer_pressure", "for an instant");
}

void add_way(MachineRows& rows) {
  rows.add("standoff");
  rows.add("coherent_length", "then the jet breaks up in air");
  rows.add("width_at_workpiece", "a model of the air");
  rows.add("water_share_at_workpiece", "a model of the air");
  rows.add("lead_angle", "leans forwards");
  rows.add("tilt_angle", "leans to the right");
  rows.add("traverse_speed", rows.of("traverse_speed") > 0.0 ? "" : "the nozzle stands still");
  rows.add("dwell", "before the traverse");
  rows.add("pulse_frequency", rows.of("pulse_frequency") > 0.0 ? "" : "a steady jet");
  rows.add("duty", "water flows for that part of a pulse");
  rows.add("spacing");
}

}  // namespace

std::string machine_table(const Json& result) {
  MachineRows rows(result);
  add_orifice(rows, result.at("machine").at("orifice_type").get<std::string>());
  add_jet(rows);
  add_way(rows);
  return html::table("Machine", std::move(rows).rows());
}

std::string exposure_table(const Json& result) {
  std::vector<Row> rows;
  for (const Metric<Exposure>& metric : Exposure::metrics())
    rows.push_back(metric_row(result, "exposure." + metric.name));
  return html::table("The cut at the traverse speed, from a nozzle at rest", rows);
}

std::string workpiece_table(const Json& kerf, const Case& description) {
  std::vector<Row> rows;
  for (const Body& body : description.bodies) {
    if (body.role != Role::elastic) continue;
    const Material& material = description.materials.at(static_cast<std::size_t>(body.material));
    rows.push_back({html::escape(body.name), html::escape(material.name), ""});
  }
  const double thickness = value_of(kerf.at("thickness"));
  if (thickness > 0.0)
    rows.push_back({"thickness", html::quantity(thickness, "m"), "along the jet, on its axis",
                    "kerf.thickness"});
  return html::table("Workpiece", rows);
}

}  // namespace kerf
