// SPDX-License-Identifier: Apache-2.0
// The part of the report that an operator reads: the kerf, its layers, the machine.
#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "report/html.hpp"
#include "report/json_number.hpp"
#include "report/kerf_drawing.hpp"
#include "report/kerf_part.hpp"
#include "report/report.hpp"

namespace kerf {
namespace {

using html::Row;
using Json = nlohmann::ordered_json;

// `key` is that of the shape in result.json.
std::string shape_table(const char* caption, const std::string& key, const Json& shape) {
  std::vector<Row> rows = {
      {"depth", html::quantity(value_of(shape.at("depth")), "m"), "", key + ".depth"}};
  for (const auto& [name, level] :
       {std::pair{"width at the top", "top"}, std::pair{"width in the middle", "middle"},
        std::pair{"width at the bottom", "bottom"}}) {
    const Json& place = shape.at(level);
    rows.push_back({name, html::quantity(value_of(place.at("width")), "m"),
                    html::quantity(value_of(place.at("below")), "m") + " below the face",
                    key + "." + level + ".width"});
  }
  rows.push_back(
      {"taper of one face", html::degrees(value_of(shape.at("taper"))), "", key + ".taper"});
  if (shape.at("lag").is_number())
    rows.push_back(
        {"lag of the front", html::quantity(value_of(shape.at("lag")), "m"), "", key + ".lag"});
  return html::table(caption, rows);
}

// Volumes in mm³ (2D: mm² of the section): the cubic metres of a kerf are all tiny.
std::string removal_table(const Json& kerf, bool plane) {
  const double factor = plane ? 1e6 : 1e9;
  const std::string volume = plane ? "\u202fmm²" : "\u202fmm³";
  const auto number = [&](const char* key) { return value_of(kerf.at(key)); };
  std::vector<Row> rows = {
      {"removed", html::number(factor * number("removed_volume")) + volume,
       plane ? "of the section" : "", "kerf.removed_volume"},
      {"rate", html::number(factor * number("removal_rate")) + volume + "/s", "",
       "kerf.removal_rate"},
      {"specific energy", html::quantity(number("specific_energy"), "J/m³"), "",
       "kerf.specific_energy"},
      {"damaged zone beside the kerf", html::quantity(number("damaged_zone"), "m"), "",
       "kerf.damaged_zone"},
      {"margin", html::percent(number("margin")),
       "of the run after the cut; less than 0: of the thickness left", "kerf.margin"}};
  const Json& splash = kerf.at("splash");
  if (splash.at("angle").is_number())
    rows.push_back({"splash off the face", html::degrees(value_of(splash.at("angle"))),
                    "± " + html::degrees(value_of(splash.at("spread"))), "kerf.splash.angle"});
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
          html::percent(share) + " of it"};
}

std::string layers_table(const Json& layers) {
  std::vector<Row> rows;
  for (const Json& layer : layers) rows.push_back(layer_row(layer));
  return html::table(
      "Layers and inclusions, from the top (width in the middle, of what thickness; taken away)",
      rows);
}

// Below the depth where material is gone.
std::string parted_sentence(const Json& kerf) {
  const double depth = value_of(kerf.at("depth"));
  if (!(depth > 0.0)) return "It parted without loss of material.";
  return fmt::format("Below {} it parted without loss of material.", html::quantity(depth, "m", 3));
}

std::string figure(const Json& result, const Case& description) {
  const Json& kerf = result.at("kerf");
  const bool parted = is_parted(result);
  const double lean = lean_of(description.jets.front(), description.dimension);
  const std::string drawing = draw_kerf(kerf, {lean, parted});
  if (drawing.empty()) return "";
  std::string legend = "<span>" + html::swatch(kerf_jet_colour, true) + "axis of the jet";
  if (lean != 0.0) legend += ", " + html::degrees(std::abs(lean)) + " from the vertical";
  legend += "</span>";
  if (parted)
    legend += " <span>" + html::swatch(kerf_crack_colour, true) +
              "crack, without loss of material</span>";
  return "<figure class=\"kerf\">" + drawing +
         "<figcaption>What was taken away, on the workpiece as laid out. Depths are along the jet, "
         "widths at right angles to it." +
         (parted ? " " + parted_sentence(kerf) : "") + "<div class=\"legend\">" + legend +
         "</div></figcaption></figure>\n";
}

}  // namespace

std::string kerf_part(const Json& result, const Case& description) {
  if (!result.contains("kerf") || description.jets.empty()) return {};
  const bool plane = description.dimension == 2;
  const Json& kerf = result.at("kerf");
  std::string text = "<h2>Kerf</h2>\n" + figure(result, description);
  text += "<div class=\"tables\">\n" + shape_table("Taken away, as laid out", "kerf", kerf) +
          shape_table("Open at the end, dents and bulges too", "opening", result.at("opening")) +
          removal_table(kerf, plane) + workpiece_table(kerf, description);
  if (!kerf.at("layers").empty()) text += layers_table(kerf.at("layers"));
  if (result.contains("machine"))
    text += machine_table(result.at("machine"), description.dimension);
  return text + "</div>\n";
}

}  // namespace kerf
