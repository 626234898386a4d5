// SPDX-License-Identifier: Apache-2.0
// Curves over time as SVG elements for the report, drawn by PLplot.
#pragma once

#include <string>
#include <vector>

#include "report/palette.hpp"

namespace kerf {

enum class Stroke { full, dashed };

// Points that are not numbers break the line.
struct Curve {
  std::string label;
  std::vector<double> y;
  Colour colour = palette::curves[0];
  Stroke stroke = Stroke::full;
};

// A quantity and the SI unit it is given in; the plot picks a prefix.
struct PlotAxis {
  std::string name;
  std::string unit;  // "1" = a plain number
};

struct Plot {
  PlotAxis x_axis, y_axis;
  std::vector<double> x;
  std::vector<Curve> curves;
  double mark = -1.0;  // a vertical line at this x where it is not negative
};

// An <svg> element that scales with its container; `name` makes its inner ids unique on a page.
std::string draw_plot(const Plot& plot, const std::string& name);

// A factor and prefix that bring numbers of this size between 1 and 1000: 1e-3 -> {1e3, "m"}.
struct Prefix {
  double factor = 1.0;
  std::string symbol;
};
Prefix prefix_for(double largest);

}  // namespace kerf
