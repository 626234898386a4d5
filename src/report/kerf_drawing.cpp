// SPDX-License-Identifier: Apache-2.0
#include "report/kerf_drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "model/jet.hpp"
#include "report/drawing.hpp"
#include "report/html.hpp"
#include "report/report_parts.hpp"

namespace kerf {
namespace {

using Json = nlohmann::ordered_json;

constexpr double drawing_width = 640.0, drawing_height = 360.0;
constexpr double block_left = 20.0, block_right = 470.0,
                 block_top = 40.0;  // of the workpiece in it
constexpr double text_height = 17.0;
constexpr Colour dimension_colour = rgb(0x5b6470);

struct Level {
  double below, half;  // m
};

// A body that stands in the kerf, which has passed beside it; across from the axis of the jet.
struct StandingPart {
  std::string name;
  double top, bottom, left, right;  // m
};

// The lengths that are drawn, m. Depths are along the jet, widths at right angles to it.
struct Section {
  double thickness = 0.0, depth = 0.0;
  bool through = false;
  std::array<Level, 3> levels{};
  std::vector<StandingPart> standing{};
};

// This class maps the section onto the drawing at one scale. The faces of the workpiece are
// horizontal for any inclination of the jet, so a point `across` the jet and `below` its face is at
// across / cos(lean) + below sin(lean).
class SectionDrawing {
 public:
  SectionDrawing(const Section& shown, double lean)
      : section(shown),
        slope_(std::sin(lean)),
        upright_(std::cos(lean)),
        shift_(0.5 * slope_ * shown.thickness) {
    double widest = 0.0;
    for (const Level& level : shown.levels) widest = std::max(widest, 2.0 * level.half);
    const double breadth = widest / upright_ + std::abs(slope_) * shown.thickness;
    scale_ = std::min(260.0 / (upright_ * shown.thickness),
                      0.8 * (block_right - block_left) / std::max(breadth, 1e-12));
  }

  double x(double across, double below) const {
    return 0.5 * (block_left + block_right) +
           scale_ * (across / upright_ + slope_ * below - shift_);
  }
  double y(double below) const { return block_top + scale_ * upright_ * below; }
  double length_below(double y) const { return (y - block_top) / (scale_ * upright_); }
  // The length of so many pixels, m.
  double length(double pixels) const { return pixels / scale_; }

  std::string line_to(double across, double below) const {
    return fmt::format("L{:.1f} {:.1f}", x(across, below), y(below));
  }
  // A line along the axis of the jet.
  void axis_line(double from, double to, const std::string& style) {
    drawing.line(x(0.0, from), y(from), x(0.0, to), y(to), style);
  }

  const Section& section;
  Drawing drawing{drawing_width, drawing_height, "Cross-section of the kerf"};

 private:
  double slope_, upright_, shift_;  // 1, 1, m
  double scale_ = 1.0;              // px/m
};

constexpr const char* solid_fill = "fill=\"#e7c3c4\" stroke=\"#b3262a\"";

// The face of the kerf on one side, from the top down.
std::string face(const SectionDrawing& map, double side) {
  const auto& levels = map.section.levels;
  std::string path = map.line_to(side * levels[0].half, 0.0);
  for (const Level& level : levels) path += map.line_to(side * level.half, level.below);
  return path;
}

// Two halves where the kerf goes through.
void add_halves(SectionDrawing& map) {
  const Section& section = map.section;
  for (const double side : {-1.0, 1.0}) {
    const double edge = side < 0.0 ? block_left : block_right;
    map.drawing.add(fmt::format("<path d=\"M{:.1f} {:.1f}{}{}L{:.1f} {:.1f}Z\" {}/>", edge,
                                map.y(0.0), face(map, side),
                                map.line_to(side * section.levels[2].half, section.thickness), edge,
                                map.y(section.thickness), solid_fill));
  }
}

// One piece with a notch.
void add_whole(SectionDrawing& map) {
  const Section& section = map.section;
  // The right face is followed upwards.
  std::string upwards;
  for (std::size_t k = section.levels.size(); k-- > 0;)
    upwards += map.line_to(section.levels[k].half, section.levels[k].below);
  upwards += map.line_to(section.levels[0].half, 0.0);
  const double low = map.y(section.thickness), high = map.y(0.0);
  map.drawing.add(fmt::format(
      "<path d=\"M{0:.1f} {1:.1f}{2}{3}{4}L{5:.1f} {1:.1f}L{5:.1f} {6:.1f}L{0:.1f} {6:.1f}Z\" "
      "{7}/>",
      block_left, high, face(map, -1.0), map.line_to(0.0, section.depth), upwards, block_right, low,
      solid_fill));
}

// The bodies that stand in the kerf, as far as they are not removed.
void add_standing(SectionDrawing& map) {
  for (const StandingPart& part : map.section.standing) {
    // What is drawn of the workpiece ends at its edges.
    const auto x = [&](double across, double below) {
      return std::clamp(map.x(across, below), block_left, block_right);
    };
    const double top = map.y(part.top), bottom = map.y(part.bottom);
    map.drawing.add(fmt::format(
        "<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}L{:.1f} {:.1f}L{:.1f} {:.1f}Z\" {} "
        "data-standing=\"{}\"/>",
        x(part.left, part.top), top, x(part.right, part.top), top, x(part.right, part.bottom),
        bottom, x(part.left, part.bottom), bottom, solid_fill, html::escape(part.name)));
    map.drawing.text(x(0.5 * (part.left + part.right), part.top), 0.5 * (top + bottom) + 5.0,
                     html::escape(part.name), Anchor::middle);
  }
}

void add_widths(SectionDrawing& map) {
  const Section& section = map.section;
  double lowest = 0.0;  // y of the label above
  for (const Level& level : section.levels) {
    if (!(level.half > 0.0)) continue;
    const double y = map.y(level.below);
    const double label_y = std::max(y + 5.0, lowest + text_height);
    if (lowest > 0.0 && level.below == section.levels[0].below) continue;  // the same once more
    map.drawing.line(map.x(-level.half, level.below), y, block_right + 14.0, y,
                     stroke(dimension_colour, 1.0, "3 3"));
    map.drawing.text(
        block_right + 20.0, label_y,
        html::quantity(2.0 * level.half, "m", 3) + " at " + html::quantity(level.below, "m", 3),
        Anchor::left);
    lowest = label_y;
  }
}

// Returns half the width of the kerf at a depth as it is drawn: straight between the levels.
double drawn_half(const Section& section, double below) {
  std::vector<Level> points{{0.0, section.levels[0].half}};
  points.insert(points.end(), section.levels.begin(), section.levels.end());
  if (section.through)
    points.push_back({section.thickness, section.levels[2].half});
  else
    points.push_back({section.depth, 0.0});
  for (std::size_t k = 1; k < points.size(); ++k) {
    const Level &above = points[k - 1], &next = points[k];
    if (below > next.below) continue;
    const double step = next.below - above.below;
    const double share = step > 0.0 ? (below - above.below) / step : 1.0;
    return above.half + share * (next.half - above.half);
  }
  return 0.0;
}

// Returns whether a text whose base line is at `y` stands in the solid left of the kerf, up to
// `end`.
bool is_left_of_kerf(const SectionDrawing& map, double y, double end) {
  constexpr double above = 12.0, beneath = 4.0, gap = 4.0;  // px, of a text
  if (y - above < map.y(0.0) || y + beneath > map.y(map.section.thickness)) return false;
  for (const double part : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    const double below = map.length_below(y - above + part * (above + beneath));
    const bool is_beside = below < map.section.depth || map.section.through;
    if (is_beside && map.x(-drawn_half(map.section, below), below) < end + gap) return false;
  }
  return true;
}

// Writes the depth beside its line where no edge of the kerf crosses it: half way down, else below
// the end of the line, else below the workpiece.
void add_depth(SectionDrawing& map) {
  constexpr double width_of_letter = 7.5;  // px, on average
  const Section& section = map.section;
  const double x = block_left + 26.0, high = map.y(0.0), low = map.y(section.depth);
  map.drawing.line(x, high, x, low, stroke(dimension_colour, 1.0));
  const std::string words = "depth " + html::quantity(section.depth, "m", 3);
  const double end = x + 8.0 + width_of_letter * static_cast<double>(words.size());
  for (const double y : {0.5 * (high + low) + 5.0, low + text_height})
    if (is_left_of_kerf(map, y, end)) return map.drawing.text(x + 8.0, y, words, Anchor::left);
  map.drawing.text(block_left, map.y(section.thickness) + 22.0, words, Anchor::left);
}

void add_depths(SectionDrawing& map) {
  const Section& section = map.section;
  if (section.depth > 0.0) add_depth(map);
  map.drawing.text(0.5 * (block_left + block_right), map.y(section.thickness) + 22.0,
                   "thickness " + html::quantity(section.thickness, "m", 3), Anchor::middle);
}

// Returns half the width of a kerf at a level, m; 0 where it has none.
double half_of(const Json& level) {
  const double width = value_of(level.at("width"));
  return std::isfinite(width) ? 0.5 * width : 0.0;
}

Section section_of(const Json& kerf) {
  Section section{kerf.at("thickness").get<double>(), kerf.at("depth").get<double>(),
                  kerf.at("through").get<bool>()};
  const char* names[] = {"top", "middle", "bottom"};
  for (std::size_t k = 0; k < 3; ++k) {
    const Json& level = kerf.at(names[k]);
    section.levels[k] = {level.at("below").get<double>(), half_of(level)};
  }
  for (const Json& layer : kerf.value("layers", Json::array())) {
    if (!stands_in_kerf(layer, section.depth)) continue;
    const double face = layer.at("face").get<double>();
    section.standing.push_back({layer.at("name").get<std::string>(),
                                face + layer.at("depth").get<double>(),
                                face + layer.at("thickness").get<double>(),
                                layer.at("left").get<double>(), layer.at("right").get<double>()});
  }
  return section;
}

}  // namespace

double lean_of(const Jet& jet, int dimension) {
  if (dimension == 2) return jet.angle;
  const double speed = std::hypot(jet.traverse[0], jet.traverse[2]);
  if (!(speed > 0.0)) return jet.angle;
  const double ahead = std::atan2(jet.traverse[2], jet.traverse[0]);
  // The right of the traverse is a quarter turn from it, from x to z.
  return std::atan(std::tan(jet.angle) * std::sin(jet.azimuth - ahead));
}

std::string draw_kerf(const Json& kerf, const KerfSetting& setting) {
  const Section section = section_of(kerf);
  const bool cracked = setting.parted && !section.through;
  if (!(section.thickness > 0.0) || (!(section.depth > 0.0) && !cracked)) return {};
  SectionDrawing map(section, setting.lean);
  if (section.through)
    add_halves(map);
  else
    add_whole(map);
  // The axis of the jet ends where the crack begins, or at the far face.
  add_standing(map);
  map.axis_line(-map.length(28.0), cracked ? section.depth : section.thickness,
                stroke(kerf_jet_colour, 1.5, "12 3 2 3"));
  if (cracked)
    map.axis_line(section.depth, section.thickness,
                  stroke(kerf_crack_colour, 2.5, "4 3") + " data-line=\"crack\"");
  add_widths(map);
  add_depths(map);
  return map.drawing.svg();
}

}  // namespace kerf
