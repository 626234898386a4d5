// SPDX-License-Identifier: Apache-2.0
// The part of the report that an operator reads: the machine, the kerf, its layers.
#include <fmt/format.h>

#include "report/html.hpp"
#include "report/json_number.hpp"
#include "report/kerf_drawing.hpp"
#include "report/report.hpp"

namespace kerf {
namespace {

using html::Row;
using Json = nlohmann::ordered_json;

std::string degrees(const Json& angle) {
  return html::number(value_of(angle) * 180.0 / 3.14159265358979, 3) + "°";
}

std::string machine_table(const Json& machine, bool plane) {
  const auto of = [&](const char* key, const char* unit) {
    return html::quantity(value_of(machine.at(key)), unit);
  };
  return html::table(
      "Machine",
      {{"pressure at the orifice", of("pressure", "Pa"), ""},
       {"orifice", of("orifice_diameter", "m"), machine.at("orifice_type").get<std::string>()},
       {"speed of the jet", of("jet_speed", "m/s"), ""},
       {"width of the jet", of("jet_width", "m"),
        "contraction " + html::number(value_of(machine.at("contraction")), 3)},
       {"flow rate", of("flow_rate", plane ? "m²/s" : "m³/s"), ""},
       {"power of the jet", of("power", plane ? "W/m" : "W"), ""},
       {"stagnation pressure", of("stagnation_pressure", "Pa"), ""},
       {"hammer pressure of real water", of("hammer_pressure", "Pa"), "for an instant"},
       {"standoff", of("standoff", "m"), ""},
       {"width at the workpiece", of("width_at_workpiece", "m"), "a model of the air"},
       {"share of water there", html::number(value_of(machine.at("water_share_at_workpiece")), 3),
        "a model of the air"}});
}

std::string shape_table(const char* caption, const Json& shape) {
  const auto width = [&](const char* level) {
    return html::quantity(value_of(shape.at(level).at("width")), "m");
  };
  std::vector<Row> rows = {{"depth", html::quantity(value_of(shape.at("depth")), "m"), ""},
                           {"width at the top", width("top"), ""},
                           {"width in the middle", width("middle"), ""},
                           {"width at the bottom", width("bottom"), ""},
                           {"taper of one face", degrees(shape.at("taper")), ""}};
  if (shape.at("lag").is_number())
    rows.push_back({"lag of the front", html::quantity(value_of(shape.at("lag")), "m"), ""});
  return html::table(caption, rows);
}

std::string removal_table(const Json& kerf, bool plane) {
  const char* volume = plane ? "m²" : "m³";
  const double energy = value_of(kerf.at("specific_energy"));
  std::vector<Row> rows = {
      {"removed", html::number(value_of(kerf.at("removed_volume"))) + " " + volume, ""},
      {"rate", html::number(value_of(kerf.at("removal_rate"))) + " " + volume + "/s", ""},
      {"specific energy", html::number(1e-9 * energy) + " J/mm³", ""},
      {"damaged zone beside the kerf", html::quantity(value_of(kerf.at("damaged_zone")), "m"), ""},
      {"margin", html::number(100.0 * value_of(kerf.at("margin")), 3) + "%",
       "of the run after the cut; less than 0: of the thickness left"}};
  const Json& splash = kerf.at("splash");
  if (splash.at("angle").is_number())
    rows.push_back(
        {"splash off the face", degrees(splash.at("angle")), "± " + degrees(splash.at("spread"))});
  return html::table("Removal", rows);
}

// Of a body beside the jet's way only the share taken away has a meaning.
Row layer_row(const Json& layer) {
  const double share = value_of(layer.at("removed_volume")) / value_of(layer.at("volume"));
  const double thickness = value_of(layer.at("thickness"));
  std::string fate = "not under the jet", extent;
  if (layer.at("through").get<bool>())
    fate = "cut through";
  else if (thickness > 0.0)
    fate = html::quantity(value_of(layer.at("depth")), "m") + " deep";
  if (thickness > 0.0)
    extent =
        fmt::format(", {} of {}", html::quantity(value_of(layer.at("middle").at("width")), "m"),
                    html::quantity(thickness, "m"));
  return {html::escape(layer.at("name").get<std::string>()), fate + extent,
          html::number(100.0 * share, 3) + "% of it"};
}

std::string layers_table(const Json& layers) {
  std::vector<Row> rows;
  for (const Json& layer : layers) rows.push_back(layer_row(layer));
  return html::table(
      "Layers and inclusions, from the top (width in the middle, of what thickness; taken away)",
      rows);
}

}  // namespace

std::string kerf_part(const Json& result) {
  if (!result.contains("kerf")) return {};
  const bool plane = result.at("dimension").get<int>() == 2;
  const Json& kerf = result.at("kerf");
  std::string text = "<h2>Kerf</h2>\n";
  const std::string drawing = draw_kerf(kerf);
  if (!drawing.empty())
    text += "<figure class=\"kerf\">" + drawing +
            "<figcaption>What was taken away, on the workpiece as laid out</figcaption></figure>\n";
  text += "<div class=\"tables\">\n" + shape_table("Taken away, as laid out", kerf) +
          shape_table("Open at the end, dents and bulges too", result.at("opening")) +
          removal_table(kerf, plane);
  if (!kerf.at("layers").empty()) text += layers_table(kerf.at("layers"));
  if (result.contains("machine")) text += machine_table(result.at("machine"), plane);
  return text + "</div>\n";
}

}  // namespace kerf
