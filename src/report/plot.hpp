// SPDX-License-Identifier: Apache-2.0
// This header declares the drawer of plots: curves of a report and points of a study, as <svg>
// elements.
#pragma once

#include <string>
#include <vector>

#include "report/palette.hpp"

namespace kerf {

enum class Stroke { full, dashed };

// A line; values that are not finite break it.
struct Curve {
  std::string label;
  std::vector<double> y;
  Colour colour = palette::curves[0];
  Stroke stroke = Stroke::full;
};

enum class Mark { filled, hollow, dotted, crossed };

// A point with a symbol of its own.
struct PlotPoint {
  double x = 0.0, y = 0.0;
  Mark mark = Mark::filled;
  std::string title = {};  // shown under the pointer
  std::string link = {};   // the address that it leads to; "" = none
};

// A shaded range of x over the whole height.
struct Band {
  double low = 0.0, high = 0.0;
};

struct PlotAxis {
  std::string name;
  std::string unit;  // SI, which gets a prefix; "1" and "%" get none, and "1" is omitted
};

struct Plot {
  PlotAxis x_axis, y_axis;
  std::vector<double> x = {};  // of the curves
  std::vector<Curve> curves = {};
  std::vector<PlotPoint> points = {};
  double mark = -1.0;            // x of a vertical line; negative = none
  std::vector<Band> bands = {};  // behind everything else
};

// Returns an <svg> element that scales with its container.
std::string draw_plot(const Plot& plot);

// A factor and prefix that bring numbers of this size between 1 and 1000: 1e-3 -> {1e3, "m"}.
struct Prefix {
  double factor = 1.0;
  std::string symbol;
};
Prefix prefix_for(double largest);

}  // namespace kerf
