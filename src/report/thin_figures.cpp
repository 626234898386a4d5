// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "report/report_figures.hpp"

namespace kerf {
namespace {

// The least and the greatest number of y[begin..end), in the order in which they come.
std::pair<double, double> extremes(const std::vector<double>& y, std::size_t begin,
                                   std::size_t end) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  std::size_t least = end, greatest = end;
  for (std::size_t i = begin; i < end; ++i) {
    if (!std::isfinite(y[i])) continue;
    if (least == end || y[i] < y[least]) least = i;
    if (greatest == end || y[i] > y[greatest]) greatest = i;
  }
  if (least == end) return {none, none};
  return {y[std::min(least, greatest)], y[std::max(least, greatest)]};
}

}  // namespace

void thin_figures(std::vector<ReportFigure>& figures, std::vector<double>& time, std::size_t most) {
  const std::size_t rows = time.size(), pieces = most / 2;
  if (rows <= most || pieces == 0) return;
  const auto begin_of = [&](std::size_t piece) { return piece * rows / pieces; };
  for (ReportFigure& figure : figures)
    for (Curve& curve : figure.curves) {
      std::vector<double> y;
      for (std::size_t piece = 0; piece < pieces; ++piece) {
        const auto [first, second] = extremes(curve.y, begin_of(piece), begin_of(piece + 1));
        y.push_back(first);
        y.push_back(second);
      }
      curve.y = std::move(y);
    }
  std::vector<double> thinned;
  for (std::size_t piece = 0; piece < pieces; ++piece) {
    thinned.push_back(time[begin_of(piece)]);
    thinned.push_back(time[begin_of(piece + 1) - 1]);
  }
  time = std::move(thinned);
}

}  // namespace kerf
