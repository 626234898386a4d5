// SPDX-License-Identifier: Apache-2.0
#include "report/plot.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "report/drawing.hpp"
#include "report/html.hpp"

namespace kerf {
namespace {

constexpr double width = 600.0, height = 330.0;                           // px
constexpr double left = 72.0, right = 585.0, top = 12.0, bottom = 274.0;  // of the axes in it
constexpr double margin = 0.06;  // of a range, that stays free beyond curves and points

// An interval of numbers that grows with what it includes.
struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void include(double value) {
    if (!std::isfinite(value)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  bool is_empty() const { return !(low <= high); }
  double span() const { return high > low ? high - low : std::max(1.0, std::abs(high)); }
};

// One axis: the numbers it covers and where they lie in the drawing.
struct Scale {
  Range range;          // in the unit that is shown
  double factor = 1.0;  // from SI to that unit
  std::string title;
  double first, last;  // px, of the ends of the range

  double at(double value) const {
    return first + (last - first) * (factor * value - range.low) / (range.high - range.low);
  }
};

// Chooses the prefix of the unit; `range` holds the values in SI units.
Scale scale_of(const PlotAxis& axis, Range range, double first, double last) {
  const bool is_plain = axis.unit == "1" || axis.unit == "%" || range.is_empty();
  const Prefix prefix =
      is_plain ? Prefix{} : prefix_for(std::max(std::abs(range.low), std::abs(range.high)));
  if (!range.is_empty()) range = {range.low * prefix.factor, range.high * prefix.factor};
  const std::string title =
      axis.unit == "1" ? axis.name : axis.name + " / " + prefix.symbol + axis.unit;
  return {range, prefix.factor, title, first, last};
}

// The x axis of curves begins at zero and ends with them.
void fit_to_time(Range& range) {
  if (range.is_empty()) range = {0.0, 1.0};
  range.low = std::min(0.0, range.low);
  if (!(range.high > range.low)) range.high = range.low + 1.0;
}

// Curves that begin near zero begin at zero, and none touches the upper edge.
void fit_to_curves(Range& range) {
  if (range.is_empty()) range = {0.0, 1.0};
  if (range.low > 0.0 && range.low < 0.5 * range.high) range.low = 0.0;
  if (range.high < 0.0 && range.high > 0.5 * range.low) range.high = 0.0;
  const double span = range.span();
  if (range.high != 0.0 || range.low == 0.0) range.high += margin * span;
  if (range.low < 0.0) range.low -= margin * span;
}

void fit_to_points(Range& range) {
  const double span = range.span();
  range = {range.low - margin * span, range.high + margin * span};
}

// Draws the grid, the numbers along both axes, their titles and the frame.
void draw_axes(Drawing& drawing, const Scale& x, const Scale& y) {
  const std::string faint = stroke(palette::grid, 1.0);
  const auto number = [](double value) { return fmt::format("{:g}", value); };
  const auto ticks = [](const Scale& scale, double parts) {
    const double interval = round_interval(scale.range.high - scale.range.low, parts);
    return round_ticks(scale.range.low, scale.range.high, interval);
  };
  for (const double tick : ticks(x, 7.0)) {
    const double at = x.at(tick / x.factor);
    drawing.line(at, top, at, bottom, faint);
    drawing.text(at, bottom + 18.0, number(tick), Anchor::middle);
  }
  for (const double tick : ticks(y, 5.0)) {
    const double at = y.at(tick / y.factor);
    drawing.line(left, at, right, at, faint);
    drawing.text(left - 7.0, at + 5.0, number(tick), Anchor::right);
  }
  drawing.add(fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\" {}/>",
                          left, top, right - left, bottom - top, stroke(palette::ink, 1.0)));
  const double middle = 0.5 * (top + bottom);
  drawing.text(0.5 * (left + right), bottom + 42.0, html::escape(x.title), Anchor::middle);
  drawing.text(16.0, middle, html::escape(y.title), Anchor::middle,
               fmt::format("transform=\"rotate(-90 16 {})\"", middle));
}

void draw_curve(Drawing& drawing, const std::vector<double>& times, const Curve& curve,
                const Scale& x, const Scale& y) {
  std::string commands;
  bool is_begun = false;
  for (std::size_t i = 0; i < times.size(); ++i) {
    const bool is_finite = std::isfinite(curve.y[i]);
    if (is_finite)
      commands +=
          fmt::format("{}{:.1f} {:.1f}", is_begun ? "L" : "M", x.at(times[i]), y.at(curve.y[i]));
    is_begun = is_finite;
  }
  if (commands.empty()) return;
  const char* dashes = curve.stroke == Stroke::dashed ? "6 4" : "";
  drawing.path(commands, stroke(curve.colour, 2.0, dashes) + " stroke-linejoin=\"round\"");
}

void draw_point(Drawing& drawing, const PlotPoint& point, double x, double y) {
  constexpr double radius = 7.0;
  std::string shape =
      fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\" fill=\"{}\" {}/>", x, y, radius,
                  hex(point.mark == Mark::filled ? palette::ink : palette::paper),
                  stroke(palette::ink, 2.0, point.mark == Mark::dotted ? "2 2" : ""));
  if (point.mark == Mark::crossed)
    shape = fmt::format("<path d=\"M{:.1f} {:.1f}l12 12m0 -12l-12 12\" {}/>", x - 6.0, y - 6.0,
                        stroke(palette::failed, 3.0));
  shape += fmt::format("<title>{}</title>", html::escape(point.title));
  drawing.add(point.link.empty()
                  ? fmt::format("<g>{}</g>", shape)
                  : fmt::format("<a href=\"{}\">{}</a>", html::escape(point.link), shape));
}

}  // namespace

Prefix prefix_for(double largest) {
  static const std::array<Prefix, 8> prefixes = {{{1e9, "n"},
                                                  {1e6, "µ"},
                                                  {1e3, "m"},
                                                  {1.0, ""},
                                                  {1e-3, "k"},
                                                  {1e-6, "M"},
                                                  {1e-9, "G"},
                                                  {1e-12, "T"}}};
  if (!(largest > 0.0)) return {};
  const Prefix* best = &prefixes.front();
  for (const Prefix& prefix : prefixes)
    if (largest * prefix.factor >= 1.0) best = &prefix;
  return *best;
}

std::string draw_plot(const Plot& plot) {
  Range x_values, y_values;
  for (const double value : plot.x) x_values.include(value);
  for (const Curve& curve : plot.curves)
    for (const double value : curve.y) y_values.include(value);
  for (const PlotPoint& point : plot.points) {
    x_values.include(point.x);
    y_values.include(point.y);
  }
  for (const Band& band : plot.bands) {
    x_values.include(band.low);
    x_values.include(band.high);
  }
  Scale x = scale_of(plot.x_axis, x_values, left, right);
  Scale y = scale_of(plot.y_axis, y_values, bottom, top);
  const bool has_points = !plot.points.empty();
  (has_points ? fit_to_points : fit_to_time)(x.range);
  (has_points ? fit_to_points : fit_to_curves)(y.range);

  Drawing drawing(width, height, html::escape(y.title + " over " + x.title));
  for (const Band& band : plot.bands)
    drawing.add(fmt::format(
        "<rect x=\"{:.1f}\" y=\"{}\" width=\"{:.1f}\" height=\"{}\" fill=\"{}\"/>", x.at(band.low),
        top, std::max(1.0, x.at(band.high) - x.at(band.low)), bottom - top, hex(palette::grid)));
  draw_axes(drawing, x, y);
  if (plot.mark >= 0.0)
    drawing.line(x.at(plot.mark), top, x.at(plot.mark), bottom, stroke(palette::ink, 1.0, "6 4"));
  for (const Curve& curve : plot.curves) draw_curve(drawing, plot.x, curve, x, y);
  for (const PlotPoint& point : plot.points)
    draw_point(drawing, point, x.at(point.x), y.at(point.y));
  return drawing.svg();
}

}  // namespace kerf
