// SPDX-License-Identifier: Apache-2.0
#include "report/drawing.hpp"

#include <cmath>

namespace kerf {

Drawing::Drawing(double width, double height, std::string_view label)
    : text_(fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" "
                        "role=\"img\" aria-label=\"{2}\" font-family=\"sans-serif\">\n"
                        "<rect width=\"{0}\" height=\"{1}\" fill=\"{3}\"/>\n",
                        width, height, label, hex(palette::paper))) {}

void Drawing::add(std::string_view element) {
  text_ += fmt::format("{}\n", element);
}

void Drawing::line(double x0, double y0, double x1, double y1, std::string_view style) {
  path(fmt::format("M{:.1f} {:.1f}L{:.1f} {:.1f}", x0, y0, x1, y1), style);
}

void Drawing::path(std::string_view commands, std::string_view style) {
  add(fmt::format("<path d=\"{}\" fill=\"none\" {}/>", commands, style));
}

void Drawing::text(double x, double y, std::string_view words, Anchor anchor,
                   std::string_view style) {
  constexpr const char* anchors[] = {"start", "middle", "end"};
  add(
      fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" font-size=\"14\" "
                  "fill=\"{}\"{}{}>{}</text>",
                  x, y, anchors[static_cast<int>(anchor)], hex(palette::ink),
                  style.empty() ? "" : " ", style, words));
}

std::string stroke(Colour colour, double width, std::string_view dashes) {
  std::string style = fmt::format("stroke=\"{}\" stroke-width=\"{}\"", hex(colour), width);
  if (!dashes.empty()) style += fmt::format(" stroke-dasharray=\"{}\"", dashes);
  return style;
}

double round_interval(double length, double parts) {
  const double rough = length / parts;
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (rough <= factor * power) return factor * power;
  return 10.0 * power;
}

std::vector<double> round_ticks(double low, double high, double interval) {
  constexpr double margin = 1e-9;  // of the interval and of the range, for rounding errors
  std::vector<double> ticks;
  for (double n = std::ceil(low / interval - margin); n * interval <= high + margin * (high - low);
       ++n)
    ticks.push_back(n == 0.0 ? 0.0 : n * interval);  // no "-0"
  return ticks;
}

}  // namespace kerf
