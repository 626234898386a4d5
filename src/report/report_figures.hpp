// SPDX-License-Identifier: Apache-2.0
// This header declares the figures of a report: their curves and how they are drawn.
#pragma once

#include <string>
#include <vector>

#include "output/series.hpp"
#include "report/plot.hpp"

namespace kerf {

struct Case;

// A figure with curves over the times of the series, in SI units.
struct ReportFigure {
  std::string title;
  PlotAxis axis;
  std::vector<Curve> curves;
};

std::vector<ReportFigure> report_figures(const SeriesTable& series, const Case& description);
// Reduces the curves to at most `most` points (2 or more). The least and the greatest value of
// every interval are kept, so no peak is lost.
void thin_figures(std::vector<ReportFigure>& figures, std::vector<double>& time, std::size_t most);
// Draws the figures; `cut_time` marks the time of cut-through if it is not negative.
std::string report_plots(const std::vector<ReportFigure>& figures, const std::vector<double>& time,
                         double cut_time);

}  // namespace kerf
