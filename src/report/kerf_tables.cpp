// SPDX-License-Identifier: Apache-2.0
// This file writes the part of the report on the kerf, its layers and the machine.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "analysis/kerf_shape.hpp"
#include "analysis/removal.hpp"
#include "model/case.hpp"
#include "output/piece_reasons.hpp"
#include "report/html.hpp"
#include "report/kerf_drawing.hpp"
#include "report/metric_rows.hpp"
#include "report/report_parts.hpp"

namespace kerf {
namespace {

using html::Row;
using Json = nlohmann::ordered_json;

// `key` is the path of the shape in result.json.
std::string shape_table(const Json& result, const char* caption, const std::string& key) {
  std::vector<Row> rows = {metric_row(result, key + ".depth")};
  for (const std::string level : {"top", "middle", "bottom"}) {
    const Json& below = *find_value(result, key + "." + level + ".below");
    rows.push_back(metric_row(result, key + "." + level + ".width",
                              html::quantity(value_of(below), "m") + " below the face"));
  }
  rows.push_back(metric_row(result, key + ".taper"));
  if (find_value(result, key + ".lag")->is_number())
    rows.push_back(metric_row(result, key + ".lag"));
  return html::table(caption, rows);
}

bool is_of_shape(std::string_view name) {
  const auto& shape = KerfShape::metrics();
  return std::any_of(shape.begin(), shape.end(),
                     [name](const MetricText& metric) { return metric.name == name; });
}

// The numbers of all measurements besides the shape.
std::string removal_table(const Json& result) {
  constexpr std::string_view prefix = "kerf.";
  std::vector<Row> rows;
  for (const ResultMetric& metric : result_metrics()) {
    const bool is_number = metric.form == ResultMetric::Form::value &&
                           (metric.kind == MetricKind::number || metric.kind == MetricKind::count);
    if (!is_number || !metric.name.starts_with(prefix)) continue;
    if (is_of_shape(std::string_view(metric.name).substr(prefix.size()))) continue;
    const Json* value = find_value(result, metric.name);
    if (value != nullptr && value->is_number())
      rows.push_back(metric_row(result, metric.name, html::escape(metric.meaning)));
  }
  return html::table("Removal, damage and splash", rows);
}

// A body outside the path of the jet has only a removed share. Results of earlier versions have no
// verdict on a layer.
Row layer_row(const Json& layer) {
  const double share = value_of(layer.at("removed_volume")) / value_of(layer.at("volume"));
  const double thickness = value_of(layer.at("thickness"));
  std::string fate = layer.value("verdict", ""), extent;
  if (fate.empty()) fate = layer.at("through").get<bool>() ? "cut through" : "cut in part";
  if (fate != "cut through" && fate != "whole" && thickness > 0.0)
    fate += ", " + html::quantity(value_of(layer.at("depth")), "m") + " deep";
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

// Returns the sentence on the part below the depth to which material is removed.
std::string parted_sentence(const Json& kerf) {
  const double depth = value_of(kerf.at("depth"));
  if (!(depth > 0.0)) return "It parted " + loss_words(kerf) + ".";
  return fmt::format("Below {} it parted {}.", html::quantity(depth, "m", 3), loss_words(kerf));
}

// Returns what was simulated of the workpiece, and why.
std::string piece_part(const Case& description) {
  std::string text;
  for (const std::string& sentence : piece_reasons(description))
    text += html::escape(sentence) + " ";
  return text.empty() ? text : "<p>" + text + "</p>\n";
}

}  // namespace

std::string loss_words(const Json& kerf) {
  const double share = value_of(kerf.value("removed_below", Json()));
  return share >= Removal::least_share
             ? "with loss of " + html::percent(share) + " of the material in the way of the jet"
             : "without loss of material";
}

std::string standing_words(const Json& kerf) {
  std::string names;
  int count = 0;
  for (const Json& layer : kerf.value("layers", Json::array())) {
    if (!stands_in_kerf(layer, value_of(kerf.at("depth")))) continue;
    names += (count++ == 0 ? "" : ", ") + html::escape(layer.at("name").get<std::string>());
  }
  if (count == 0) return "";
  return ", beside " + names + (count == 1 ? ", which is" : ", which are") + " not cut through";
}

std::string kerf_figure(const Json& result, const Case& description) {
  if (!result.contains("kerf") || description.jets.empty()) return "";
  const Json& kerf = result.at("kerf");
  // The cracks around a plug are elsewhere than on the axis.
  const bool parted = is_parted(result) && !is_punched(result);
  const double lean = lean_of(description.jets.front(), description.dimension);
  const std::string drawing = draw_kerf(kerf, {lean, parted});
  if (drawing.empty()) return "";
  std::string legend = "<span>" + html::swatch(kerf_jet_colour, true) + "axis of the jet";
  if (lean != 0.0) legend += ", " + html::degrees(std::abs(lean)) + " from the vertical";
  legend += "</span>";
  if (parted)
    legend += " <span>" + html::swatch(kerf_crack_colour, true) + "crack, " + loss_words(kerf) +
              "</span>";
  return fmt::format(
      "<figure class=\"kerf\">{}<figcaption>What was taken away, on the workpiece as laid out. "
      "Depths "
      "are along the jet, widths at right angles to it.{}{}<div class=\"legend\">{}</div>"
      "</figcaption></figure>\n",
      drawing, parted ? " " : "", parted ? parted_sentence(kerf) : "", legend);
}

std::string kerf_part(const Json& result, const Case& description) {
  if (!result.contains("kerf") || description.jets.empty()) return {};
  const Json& kerf = result.at("kerf");
  std::string text = "<h2>Kerf</h2>\n" + piece_part(description);
  text += "<div class=\"tables\">\n" + shape_table(result, "Taken away, as laid out", "kerf") +
          shape_table(result, "Open at the end, dents and bulges too", "opening") +
          removal_table(result) + workpiece_table(kerf, description);
  if (!kerf.at("layers").empty()) text += layers_table(kerf.at("layers"));
  if (result.contains("machine")) text += machine_table(result);
  if (result.contains("exposure")) text += exposure_table(result);
  return text + "</div>\n";
}

}  // namespace kerf
