// SPDX-License-Identifier: Apache-2.0
#include "report/plot.hpp"

#include <plplot/plplot.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <memory>
#include <stdexcept>

namespace kerf {
namespace {

constexpr int width = 600, height = 330;                                // px at scale 1
constexpr double left = 0.12, right = 0.975, low = 0.17, high = 0.965;  // of the page
constexpr int ink = 1, grid = 2, first_curve = 3;  // places in PLplot's colour map

PLINT byte(double share) {
  return static_cast<PLINT>(std::lround(255.0 * share));
}

void set_colour(PLINT place, Colour colour) {
  plscol0(place, byte(colour.red), byte(colour.green), byte(colour.blue));
}

struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void include(const std::vector<double>& values) {
    for (const double value : values) {
      if (!std::isfinite(value)) continue;
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
  double largest() const { return std::max(std::abs(low), std::abs(high)); }
  // Never empty; curves from zero start at zero, and nothing touches the upper edge.
  void make_room() {
    if (!(low <= high)) *this = {0.0, 1.0};
    if (low > 0.0 && low < 0.5 * high) low = 0.0;
    if (high < 0.0 && high > 0.5 * low) high = 0.0;
    const double span = high > low ? high - low : std::max(1.0, std::abs(high));
    if (high != 0.0 || low == 0.0) high += 0.06 * span;
    if (low < 0.0) low -= 0.06 * span;
  }
};

std::vector<double> scaled(std::vector<double> values, double factor) {
  for (double& value : values) value *= factor;
  return values;
}

std::string axis_title(const PlotAxis& axis, const Prefix& prefix) {
  if (axis.unit == "1") return axis.name;
  return axis.name + " / " + prefix.symbol + axis.unit;
}

void draw_line(const std::vector<double>& x, const std::vector<double>& y) {
  for (std::size_t begin = 0; begin < x.size();) {
    std::size_t end = begin;
    while (end < x.size() && std::isfinite(y[end])) ++end;
    if (end > begin) plline(static_cast<PLINT>(end - begin), x.data() + begin, y.data() + begin);
    begin = end + 1;
  }
}

void draw_curves(const Plot& plot, const std::vector<double>& x,
                 const std::vector<std::vector<double>>& y) {
  for (std::size_t i = 0; i < y.size(); ++i) {
    plcol0(first_curve + static_cast<PLINT>(i));
    plwidth(2.2);
    pllsty(plot.curves[i].stroke == Stroke::dashed ? 2 : 1);
    draw_line(x, y[i]);
  }
  pllsty(1);
}

void draw_page(const Plot& plot) {
  Range x_range, y_range;
  x_range.include(plot.x);
  const double x_size = x_range.low <= x_range.high ? x_range.largest() : 1.0;
  std::vector<std::vector<double>> y;
  for (const Curve& curve : plot.curves) {
    y.push_back(curve.y);
    y_range.include(curve.y);
  }
  const Prefix x_prefix = prefix_for(x_size);
  const Prefix y_prefix = plot.y_axis.unit == "1" || !(y_range.low <= y_range.high)
                              ? Prefix{}
                              : prefix_for(y_range.largest());
  const std::vector<double> x = scaled(plot.x, x_prefix.factor);
  for (auto& values : y) values = scaled(values, y_prefix.factor);
  y_range.low *= y_prefix.factor;
  y_range.high *= y_prefix.factor;
  y_range.make_room();

  pladv(0);
  plvpor(left, right, low, high);
  const double x_end = x_size * x_prefix.factor;
  plwind(std::min(0.0, x_range.low * x_prefix.factor), x_end > 0.0 ? x_end : 1.0, y_range.low,
         y_range.high);
  plwidth(1.0);
  plcol0(grid);
  plbox("g", 0.0, 0, "g", 0.0, 0);
  plcol0(ink);
  plwidth(1.0);
  plbox("bnst", 0.0, 0, "bnstvf", 0.0, 0);
  plmtex("b", 2.9, 0.5, 0.5, axis_title(plot.x_axis, x_prefix).c_str());
  plmtex("l", 4.3, 0.5, 0.5, axis_title(plot.y_axis, y_prefix).c_str());
  if (plot.mark >= 0.0) {
    pllsty(2);
    pljoin(plot.mark * x_prefix.factor, y_range.low, plot.mark * x_prefix.factor, y_range.high);
    pllsty(1);
  }
  draw_curves(plot, x, y);
}

// PLplot writes whole documents and reuses ids; a page with several figures needs elements whose
// ids are their own.
std::string element_of(std::string document, const std::string& name) {
  const std::size_t start = document.find("<svg");
  if (start == std::string::npos) throw std::runtime_error("PLplot drew nothing");
  document.erase(0, start);
  const auto replace_all = [&document](const std::string& from, const std::string& to) {
    for (std::size_t at = 0; (at = document.find(from, at)) != std::string::npos; at += to.size())
      document.replace(at, from.size(), to);
  };
  replace_all("text-clipping", name + "-clip");
  const auto replace_once = [&document](const std::string& from, const std::string& to) {
    const std::size_t at = document.find(from);
    if (at != std::string::npos) document.replace(at, from.size(), to);
  };
  replace_once("width=\"" + std::to_string(width) + "pt\"", "role=\"img\"");
  replace_once("height=\"" + std::to_string(height) + "pt\"", "");
  return document;
}

struct FreeMemory {
  void operator()(char* memory) const { std::free(memory); }
};

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

std::string draw_plot(const Plot& plot, const std::string& name) {
  char* memory = nullptr;
  std::size_t size = 0;
  std::FILE* stream = open_memstream(&memory, &size);
  if (stream == nullptr) throw std::runtime_error("out of memory for a plot");
  plsdev("svg");
  plsfile(stream);
  plspage(0.0, 0.0, width, height, 0, 0);
  plscolbg(255, 255, 255);
  plscmap0n(first_curve + static_cast<PLINT>(plot.curves.size()) + 1);
  set_colour(ink, palette::ink);
  set_colour(grid, palette::grid);
  for (std::size_t i = 0; i < plot.curves.size(); ++i)
    set_colour(first_curve + static_cast<PLINT>(i), plot.curves[i].colour);
  plinit();
  plsfont(PL_FCI_SANS, PL_FCI_UPRIGHT, PL_FCI_MEDIUM);
  plschr(3.7, 1.0);
  plsmaj(2.0, 1.0);
  plsmin(1.0, 1.0);
  draw_page(plot);
  plend();  // closes the stream
  const std::unique_ptr<char, FreeMemory> owner(memory);
  return element_of({memory, size}, name);
}

}  // namespace kerf
