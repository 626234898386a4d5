// SPDX-License-Identifier: Apache-2.0
// What was cut, and the setting of the machine that cut it.
#include <fmt/format.h>

#include "report/html.hpp"
#include "report/json_number.hpp"
#include "report/kerf_part.hpp"

namespace kerf {
namespace {

using html::Row;
using Json = nlohmann::ordered_json;

// The rows of the machine: each names its key of result.json, so that none is shown that is not
// there.
class MachineRows {
 public:
  explicit MachineRows(const Json& machine) : machine_(machine) {}

  bool has(const char* key) const { return machine_.contains(key) && machine_.at(key).is_number(); }
  double of(const char* key) const { return value_of(machine_.at(key)); }
  void add(const char* name, const char* key, std::string value, std::string remark = {}) {
    rows_.push_back({name, std::move(value), std::move(remark), std::string("machine.") + key});
  }
  void quantity(const char* name, const char* key, const char* unit, std::string remark = {}) {
    if (has(key)) add(name, key, html::quantity(of(key), unit), std::move(remark));
  }
  void ratio(const char* name, const char* key, std::string remark = {}) {
    if (has(key)) add(name, key, html::number(of(key)), std::move(remark));
  }
  void angle(const char* name, const char* key, std::string remark = {}) {
    if (has(key)) add(name, key, html::degrees(of(key)), std::move(remark));
  }
  std::vector<Row> rows() && { return std::move(rows_); }

 private:
  const Json& machine_;
  std::vector<Row> rows_;
};

void add_orifice(MachineRows& rows, const Json& machine) {
  rows.quantity("pressure at the orifice", "pressure", "Pa");
  rows.quantity("orifice", "orifice_diameter", "m",
                html::escape(machine.at("orifice_type").get<std::string>()));
  rows.quantity("length of the orifice", "orifice_length", "m");
  rows.angle("angle of its cone", "cone_angle");
  rows.angle("angle of the fan", "fan_angle");
  rows.ratio("velocity coefficient", "velocity_coefficient");
  rows.ratio("discharge coefficient", "discharge_coefficient");
  rows.ratio("contraction, jet over orifice", "contraction");
}

void add_jet(MachineRows& rows, int dimension) {
  rows.quantity("speed of the jet", "jet_speed", "m/s");
  rows.quantity("width of the jet", "jet_width", "m");
  const double flow = rows.of("flow_rate");
  rows.add("flow rate", "flow_rate", html::flow_rate(flow, dimension),
           dimension == 2 ? html::number(60.0 * flow) + "\u202fL/min per mm of depth" : "");
  rows.quantity("power of the jet", "power", dimension == 2 ? "W/m" : "W");
  rows.quantity("stagnation pressure", "stagnation_pressure", "Pa");
  rows.quantity("hammer pressure of real water", "hammer_pressure", "Pa", "for an instant");
}

void add_way(MachineRows& rows) {
  rows.quantity("standoff", "standoff", "m");
  if (rows.has("coherent_length"))
    rows.quantity("coherent length", "coherent_length", "m", "then the air breaks the jet up");
  rows.quantity("width at the workpiece", "width_at_workpiece", "m", "a model of the air");
  rows.ratio("share of water there", "water_share_at_workpiece", "a model of the air");
  rows.angle("lead angle", "lead_angle", "leans forwards");
  rows.angle("tilt angle", "tilt_angle", "leans to the right");
  const bool moves = rows.of("traverse_speed") > 0.0;
  rows.quantity("traverse", "traverse_speed", "m/s", moves ? "" : "the nozzle stands still");
  rows.quantity("dwell before it", "dwell", "s");
  const bool pulses = rows.of("pulse_frequency") > 0.0;
  rows.quantity("pulses", "pulse_frequency", "Hz", pulses ? "" : "a steady jet");
  rows.ratio("duty, water for that part of a pulse", "duty");
  rows.quantity("spacing of the water", "spacing", "m");
}

}  // namespace

std::string machine_table(const Json& machine, int dimension) {
  MachineRows rows(machine);
  add_orifice(rows, machine);
  add_jet(rows, dimension);
  add_way(rows);
  return html::table("Machine", std::move(rows).rows());
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
