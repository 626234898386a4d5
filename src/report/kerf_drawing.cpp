// SPDX-License-Identifier: Apache-2.0
#include "report/kerf_drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "report/html.hpp"

namespace kerf {
namespace {

using Json = nlohmann::ordered_json;

constexpr double width = 640.0, height = 360.0;           // of the drawing
constexpr double left = 20.0, right = 470.0, top = 40.0;  // of the workpiece in it

struct Level {
  double below, half;  // m
};

// Lengths at one scale, the workpiece `thickness` high.
class Drawing {
 public:
  Drawing(double thickness, double widest)
      : scale_(std::min(260.0 / thickness, 0.8 * (right - left) / std::max(widest, 1e-12))) {}

  double x(double across) const { return 0.5 * (left + right) + scale_ * across; }
  double y(double below) const { return top + scale_ * below; }

  void add(const std::string& element) { text_ += element + "\n"; }
  void label(double at_x, double at_y, const std::string& words, const char* anchor) {
    add(
        fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" font-size=\"14\" "
                    "fill=\"#22272e\">{}</text>",
                    at_x, at_y, anchor, words));
  }
  void line(std::array<double, 2> from, std::array<double, 2> to, const char* style) {
    add(fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" {}/>", from[0], from[1], to[0], to[1],
                    style));
  }
  std::string svg() const {
    return fmt::format(
        "<svg viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"Cross-section of the "
        "kerf\">\n{}</svg>\n",
        width, height, text_);
  }

 private:
  double scale_;
  std::string text_;
};

constexpr const char* dimension_line = "stroke=\"#5b6470\" fill=\"none\"";
constexpr const char* solid_fill = "fill=\"#e7c3c4\" stroke=\"#b3262a\"";

// One half of the solid, mirrored by `side`.
void add_half(Drawing& drawing, const std::array<Level, 3>& levels, double thickness, bool through,
              double depth, double side) {
  const double edge = side < 0.0 ? left : right;
  std::string path = fmt::format("M{:.1f} {:.1f}", edge, drawing.y(0.0));
  const auto to = [&](double across, double below) {
    path += fmt::format("L{:.1f} {:.1f}", drawing.x(side * across), drawing.y(below));
  };
  to(levels[0].half, 0.0);
  for (const Level& level : levels) to(level.half, level.below);
  if (through) {
    to(levels[2].half, thickness);
  } else {
    to(0.0, depth);
    to(0.0, thickness);
  }
  path += fmt::format("L{:.1f} {:.1f}Z", edge, drawing.y(thickness));
  drawing.add(fmt::format("<path d=\"{}\" {}/>", path, solid_fill));
}

void add_dimensions(Drawing& drawing, const std::array<Level, 3>& levels, double thickness,
                    double depth) {
  for (const Level& level : levels) {
    const double y = drawing.y(level.below);
    drawing.line({drawing.x(-level.half), y}, {right + 14.0, y},
                 "stroke=\"#5b6470\" stroke-dasharray=\"3 3\" fill=\"none\"");
    drawing.label(
        right + 20.0, y + 5.0,
        html::quantity(2.0 * level.half, "m", 3) + " at " + html::quantity(level.below, "m", 3),
        "start");
  }
  const double x = left + 26.0;
  drawing.line({x, drawing.y(0.0)}, {x, drawing.y(depth)}, dimension_line);
  drawing.label(x + 8.0, 0.5 * (drawing.y(0.0) + drawing.y(depth)) + 5.0,
                "depth " + html::quantity(depth, "m", 3), "start");
  drawing.label(0.5 * (left + right), drawing.y(thickness) + 22.0,
                "thickness " + html::quantity(thickness, "m", 3), "middle");
}

}  // namespace

std::string draw_kerf(const Json& kerf) {
  const double thickness = kerf.at("thickness").get<double>();
  const double depth = kerf.at("depth").get<double>();
  if (!(thickness > 0.0) || !(depth > 0.0)) return {};
  std::array<Level, 3> levels{};
  const char* names[] = {"top", "middle", "bottom"};
  double widest = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Json& level = kerf.at(names[k]);
    levels[k] = {level.at("below").get<double>(), 0.5 * level.at("width").get<double>()};
    widest = std::max(widest, 2.0 * levels[k].half);
  }
  Drawing drawing(thickness, widest);
  for (const double side : {-1.0, 1.0})
    add_half(drawing, levels, thickness, kerf.at("through").get<bool>(), depth, side);
  add_dimensions(drawing, levels, thickness, depth);
  return drawing.svg();
}

}  // namespace kerf
