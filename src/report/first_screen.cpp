// SPDX-License-Identifier: Apache-2.0
// This file writes the first screen of a report: the picture of the cut, the verdict on each body
// and the feed up to which the cut goes through.
#include <fmt/format.h>

#include <cmath>
#include <string_view>
#include <vector>

#include "model/case.hpp"
#include "output/layer_metrics.hpp"
#include "report/html.hpp"
#include "report/metric_rows.hpp"
#include "report/report_parts.hpp"

namespace kerf {

namespace {

using Json = nlohmann::ordered_json;

struct BodyFate {
  std::string name, fate;
  double time = std::nan("");  // s, of the cut
};

// Names the fate of the one body of a workpiece that is cut through.
const char* fate_of_cut(const Json& result) {
  if (!is_parted(result)) return "cut through";
  return is_punched(result) ? "punched out" : "parted";
}

// result.json lists the layers where the workpiece has several bodies; else the verdict is on all.
std::vector<BodyFate> fates_of(const Json& result, const Case& description) {
  std::vector<BodyFate> fates;
  if (result.contains("kerf"))
    for (const Json& layer : result.at("kerf").at("layers")) {
      const auto time = layer.find("cut_through_time");
      // Results of earlier versions have no verdict on a layer.
      const char* seen = layer.at("through").get<bool>() ? "cut through" : "cut in part";
      fates.push_back({layer.at("name").get<std::string>(), layer.value("verdict", seen),
                       time == layer.end() ? std::nan("") : value_of(*time)});
    }
  if (!fates.empty()) return fates;
  const bool through = result.at("cut_through").get<bool>();
  // Bonds may break without a particle that is fractured: then a part of the thickness is broken,
  // and the margin is above -1. Of a body that was pushed out of the domain nothing is removed.
  constexpr double rounding = 1e-6;
  const Json* margin = find_value(result, "kerf.margin");
  const Json* thickness = find_value(result, "kerf.thickness");
  const bool is_aside = thickness != nullptr && value_of(*thickness) == 0.0;
  const Json* removed = find_value(result, "kerf.removed_volume");
  const bool is_left_out = removed != nullptr && value_of(*removed) == 0.0;
  const bool is_whole = (is_left_out || !(value_of(result.at("fractured_fraction")) > 0.0)) &&
                        !(margin != nullptr && value_of(*margin) > -1.0 + rounding);
  for (const Body& body : description.bodies)
    if (body.role == Role::elastic)
      fates.push_back({body.name,
                       through    ? fate_of_cut(result)
                       : is_aside ? "not under the jet"
                       : is_whole ? "whole"
                                  : "cut in part",
                       through ? value_of(result.at("cut_through_time")) : std::nan("")});
  return fates;
}

// The sign has the same meaning as the colour.
std::string body_list(const std::vector<BodyFate>& fates) {
  std::string text = "<h2>Verdict on each body</h2>\n<ul class=\"bodies\">\n";
  for (const BodyFate& body : fates) {
    const bool cut = body.fate == "cut through" || body.fate == cut_on_part_of_way ||
                     body.fate == "parted" || body.fate == "punched out" ||
                     body.fate == "broken through";
    const bool aside = body.fate == "not under the jet";
    text += fmt::format(
        "<li class=\"{}\"><b>{}</b><span><strong>{}</strong> {}{}</span></li>\n",
        cut     ? "yes"
        : aside ? "none"
                : "no",
        cut     ? "✓"
        : aside ? "·"
                : "✗",
        html::escape(body.name), html::escape(body.fate),
        cut && std::isfinite(body.time) ? " after " + html::quantity(body.time, "s", 3) : "");
  }
  return text + "</ul>\n";
}

// "50 mm/s (3000 mm/min)", as machines are set, and "25 m/s (1500 m/min)".
std::string feed_html(double feed) {
  constexpr double slow = 1.0;  // m/s; faster ones would have five digits and more in mm/min
  const bool is_slow = feed < slow;
  return fmt::format("{} ({}\u202f{})", html::quantity(feed, "m/s", 3),
                     html::number((is_slow ? 6e4 : 60.0) * feed, 3), is_slow ? "mm/min" : "m/min");
}

std::string feed_answer(const Json& result) {
  const auto exposure = result.find("exposure");
  if (exposure == result.end()) return "";
  const double certain = value_of(exposure->at("greatest_feed"));
  const double possible = value_of(exposure->at("possible_feed"));
  std::string answer;
  // Beyond a run that ended before the cut the depth is carried on.
  const bool is_carried = value_of(exposure->value("exponent", Json())) > 0.0;
  if (certain > 0.0)
    answer = fmt::format("The cut is {} up to <strong>{}</strong>",
                         is_carried ? "expected" : "certain", feed_html(certain));
  if (possible > 0.0)
    answer += fmt::format("{} possible up to <strong>{}</strong>",
                          answer.empty() ? "No feed is certain to cut; the cut is" : " and",
                          feed_html(possible));
  if (answer.empty())
    answer = exposure->value("may_cut", false)
                 ? "This run tells no feed: it ends before it shows whether the jet cuts through"
                 : "This run shows no feed at which the jet cuts through";
  return "<h2>How fast may I traverse?</h2>\n<p class=\"feed\">" + answer + ".</p>\n";
}

}  // namespace

std::string first_screen(const Json& result, const Case& description, const std::string& picture) {
  if (description.jets.empty()) return "";
  const std::string drawing = kerf_figure(result, description);
  return "<div class=\"first\">\n" + (drawing.empty() ? picture : drawing) + "<div>\n" +
         feed_answer(result) + body_list(fates_of(result, description)) + "</div>\n</div>\n";
}

}  // namespace kerf
