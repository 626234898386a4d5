// SPDX-License-Identifier: Apache-2.0
// The curves of a report: which there are, and of what.
#pragma once

#include <string>
#include <vector>

#include "case/case.hpp"
#include "output/series.hpp"
#include "report/plot.hpp"

namespace kerf {

// Curves over the times of the series, in SI units.
struct ReportFigure {
  std::string title;
  PlotAxis axis;
  std::vector<Curve> curves;
};

std::vector<ReportFigure> report_figures(const SeriesTable& series, const Case& description);
// At most so many points (2 or more): of every piece of the curves the least and the greatest value
// stay, so no peak is lost.
void thin_figures(std::vector<ReportFigure>& figures, std::vector<double>& time, std::size_t most);
// Drawn; `cut_time` marks the cut where it is not negative.
std::string report_plots(const std::vector<ReportFigure>& figures, const std::vector<double>& time,
                         double cut_time);

}  // namespace kerf
