// SPDX-License-Identifier: Apache-2.0
#include "report/kerf_drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "report/html.hpp"

namespace kerf {
namespace {

using Json = nlohmann::ordered_json;

constexpr double width = 640.0, height = 360.0;           // of the drawing
constexpr double left = 20.0, right = 470.0, top = 40.0;  // of the workpiece in it
constexpr double text_height = 17.0;

struct Level {
  double below, half;  // m
};

// What is drawn, m. Depths are along the jet, widths at right angles to it.
struct Section {
  double thickness = 0.0, depth = 0.0;
  bool through = false;
  std::array<Level, 3> levels{};
};

// Lengths at one scale. The faces of the workpiece are level however the jet leans, so a place
// `across` the jet and `below` its face lies at across / cos(lean) + below sin(lean).
class Drawing {
 public:
  Drawing(const Section& section, double lean)
      : slope_(std::sin(lean)), upright_(std::cos(lean)), shift_(0.5 * slope_ * section.thickness) {
    double widest = 0.0;
    for (const Level& level : section.levels) widest = std::max(widest, 2.0 * level.half);
    const double breadth = widest / upright_ + std::abs(slope_) * section.thickness;
    scale_ = std::min(260.0 / (upright_ * section.thickness),
                      0.8 * (right - left) / std::max(breadth, 1e-12));
  }

  double x(double across, double below) const {
    return 0.5 * (left + right) + scale_ * (across / upright_ + slope_ * below - shift_);
  }
  double y(double below) const { return top + scale_ * upright_ * below; }
  std::string place(double across, double below) const {
    return fmt::format("{:.1f} {:.1f}", x(across, below), y(below));
  }
  std::string line_to(double across, double below) const {
    return fmt::format("L{:.1f} {:.1f}", x(across, below), y(below));
  }
  // Of so many px in the drawing.
  double length(double pixels) const { return pixels / scale_; }

  void add(const std::string& element) { text_ += element + "\n"; }
  void label(double at_x, double at_y, const std::string& words, const char* anchor) {
    add(
        fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" font-size=\"14\" "
                    "fill=\"#22272e\">{}</text>",
                    at_x, at_y, anchor, words));
  }
  void line(const std::string& from, const std::string& to, const std::string& style) {
    add(fmt::format("<path d=\"M{}L{}\" fill=\"none\" {}/>", from, to, style));
  }
  std::string svg() const {
    return fmt::format(
        "<svg viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"Cross-section of the "
        "kerf\">\n{}</svg>\n",
        width, height, text_);
  }

 private:
  double slope_, upright_, shift_;  // 1, 1, m
  double scale_ = 1.0;              // px/m
  std::string text_;
};

constexpr const char* dimension_line = "stroke=\"#5b6470\"";
constexpr const char* solid_fill = "fill=\"#e7c3c4\" stroke=\"#b3262a\"";

std::string stroke(Colour colour, double breadth, const char* dashes) {
  const auto byte = [](double share) { return static_cast<int>(std::lround(255.0 * share)); };
  return fmt::format("stroke=\"#{:02x}{:02x}{:02x}\" stroke-width=\"{}\" stroke-dasharray=\"{}\"",
                     byte(colour.red), byte(colour.green), byte(colour.blue), breadth, dashes);
}

// The face of the kerf on one side, from the top down.
std::string face(const Drawing& drawing, const Section& section, double side) {
  std::string path = drawing.line_to(side * section.levels[0].half, 0.0);
  for (const Level& level : section.levels) path += drawing.line_to(side * level.half, level.below);
  return path;
}

// Two halves where the kerf goes through.
void add_halves(Drawing& drawing, const Section& section) {
  for (const double side : {-1.0, 1.0}) {
    const double edge = side < 0.0 ? left : right;
    drawing.add(fmt::format("<path d=\"M{:.1f} {:.1f}{}L{}L{:.1f} {:.1f}Z\" {}/>", edge,
                            drawing.y(0.0), face(drawing, section, side),
                            drawing.place(side * section.levels[2].half, section.thickness), edge,
                            drawing.y(section.thickness), solid_fill));
  }
}

// One piece with a notch.
void add_whole(Drawing& drawing, const Section& section) {
  // The right face is followed upwards.
  std::string upwards;
  for (std::size_t k = section.levels.size(); k-- > 0;)
    upwards += drawing.line_to(section.levels[k].half, section.levels[k].below);
  upwards += drawing.line_to(section.levels[0].half, 0.0);
  const double low = drawing.y(section.thickness), high = drawing.y(0.0);
  drawing.add(fmt::format(
      "<path d=\"M{0:.1f} {1:.1f}{2}L{3}{4}L{5:.1f} {1:.1f}L{5:.1f} {6:.1f}L{0:.1f} {6:.1f}Z\" "
      "{7}/>",
      left, high, face(drawing, section, -1.0), drawing.place(0.0, section.depth), upwards, right,
      low, solid_fill));
}

void add_widths(Drawing& drawing, const Section& section) {
  double lowest = 0.0;  // place of the label above
  for (const Level& level : section.levels) {
    if (!(level.half > 0.0)) continue;
    const double y = drawing.y(level.below);
    const double label_y = std::max(y + 5.0, lowest + text_height);
    if (lowest > 0.0 && level.below == section.levels[0].below) continue;  // the same once more
    drawing.line(drawing.place(-level.half, level.below),
                 fmt::format("{:.1f} {:.1f}", right + 14.0, y),
                 std::string(dimension_line) + " stroke-dasharray=\"3 3\"");
    drawing.label(
        right + 20.0, label_y,
        html::quantity(2.0 * level.half, "m", 3) + " at " + html::quantity(level.below, "m", 3),
        "start");
    lowest = label_y;
  }
}

void add_depths(Drawing& drawing, const Section& section) {
  const double x = left + 26.0;
  const auto at = [&](double below) { return fmt::format("{:.1f} {:.1f}", x, drawing.y(below)); };
  if (section.depth > 0.0) {
    drawing.line(at(0.0), at(section.depth), dimension_line);
    drawing.label(x + 8.0, 0.5 * (drawing.y(0.0) + drawing.y(section.depth)) + 5.0,
                  "depth " + html::quantity(section.depth, "m", 3), "start");
  }
  drawing.label(0.5 * (left + right), drawing.y(section.thickness) + 22.0,
                "thickness " + html::quantity(section.thickness, "m", 3), "middle");
}

// From above the workpiece down to where the crack begins, or to the far face.
void add_jet(Drawing& drawing, const Section& section, bool cracked) {
  const double end = cracked ? section.depth : section.thickness;
  drawing.line(drawing.place(0.0, -drawing.length(28.0)), drawing.place(0.0, end),
               stroke(kerf_jet_colour, 1.5, "12 3 2 3"));
}

void add_crack(Drawing& drawing, const Section& section) {
  drawing.line(drawing.place(0.0, section.depth), drawing.place(0.0, section.thickness),
               stroke(kerf_crack_colour, 2.5, "4 3") + " data-line=\"crack\"");
}

Section section_of(const Json& kerf) {
  Section section{kerf.at("thickness").get<double>(), kerf.at("depth").get<double>(),
                  kerf.at("through").get<bool>()};
  const char* names[] = {"top", "middle", "bottom"};
  for (std::size_t k = 0; k < 3; ++k) {
    const Json& level = kerf.at(names[k]);
    section.levels[k] = {level.at("below").get<double>(), 0.5 * level.at("width").get<double>()};
  }
  return section;
}

}  // namespace

double lean_of(const Jet& jet, int dimension) {
  if (dimension == 2) return jet.angle;
  const double speed = std::hypot(jet.traverse[0], jet.traverse[2]);
  if (!(speed > 0.0)) return jet.angle;
  const double ahead = std::atan2(jet.traverse[2], jet.traverse[0]);
  // The right of the way is a quarter of a turn from it, from x to z.
  return std::atan(std::tan(jet.angle) * std::sin(jet.azimuth - ahead));
}

std::string draw_kerf(const Json& kerf, const KerfSetting& setting) {
  const Section section = section_of(kerf);
  const bool cracked = setting.parted && !section.through;
  if (!(section.thickness > 0.0) || (!(section.depth > 0.0) && !cracked)) return {};
  Drawing drawing(section, setting.lean);
  if (section.through)
    add_halves(drawing, section);
  else
    add_whole(drawing, section);
  add_jet(drawing, section, cracked);
  if (cracked) add_crack(drawing, section);
  add_widths(drawing, section);
  add_depths(drawing, section);
  return drawing.svg();
}

}  // namespace kerf
