// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "model/case.hpp"
#include "output/balance_metrics.hpp"
#include "report/html.hpp"
#include "report/report_figures.hpp"

namespace kerf {

namespace {

// Collects the figures of one report, which have the same time axis.
class Figures {
 public:
  Figures(const SeriesTable& series, const Case& description)
      : series_(series), description_(description) {}

  struct Line {
    std::string column;
    std::string label;
    double factor = 1.0;
  };

  void add(const std::string& title, const PlotAxis& axis, const std::vector<Line>& lines) {
    std::vector<Curve> curves;
    for (const Line& line : lines) {
      std::vector<double> y = series_.numbers(line.column);
      for (double& value : y) value *= line.factor;
      curves.push_back({line.label, std::move(y), colour(curves.size()), stroke(curves.size())});
    }
    figures_.push_back({title, axis, std::move(curves)});
  }

  // Draws the time step with one colour for each limit: the line up to a row has the colour of the
  // limit of that row.
  void add_time_step() {
    const std::vector<double> dt = series_.numbers("dt");
    const std::vector<std::string>& limits = series_.texts("limit");
    std::vector<Curve> curves;
    for (std::size_t i = 1; i < dt.size(); ++i) {
      // The last step is shortened to the end of the run.
      if (limits[i] == "end of run") continue;
      auto curve = std::find_if(curves.begin(), curves.end(),
                                [&](const Curve& known) { return known.label == limits[i]; });
      if (curve == curves.end()) {
        const std::vector<double> nothing(dt.size(), std::numeric_limits<double>::quiet_NaN());
        curves.push_back({limits[i], nothing, colour(curves.size()), Stroke::full});
        curve = curves.end() - 1;
      }
      // No step precedes the first row, so its dt has no meaning.
      if (i > 1) curve->y[i - 1] = dt[i - 1];
      curve->y[i] = dt[i];
    }
    figures_.push_back({"Time step, by the limit that set it", {"step", "s"}, std::move(curves)});
  }

  std::vector<ReportFigure> result() && { return std::move(figures_); }
  std::string unit(const char* extensive) const {
    return MetricUnit(extensive, true).in(description_.dimension);
  }
  bool moves(const std::string& column) const {
    const std::vector<double> values = series_.numbers(column);
    return std::any_of(values.begin(), values.end(), [](double value) { return value != 0.0; });
  }

 private:
  static Colour colour(std::size_t index) {
    return palette::curves[index % palette::curves.size()];
  }
  // Every other line is dashed, so that neighbours differ without colours too.
  static Stroke stroke(std::size_t index) { return index % 2 == 1 ? Stroke::dashed : Stroke::full; }

  const SeriesTable& series_;
  const Case& description_;
  std::vector<ReportFigure> figures_;
};

std::string plot_legend(const ReportFigure& figure, double cut_time) {
  std::string legend;
  for (const Curve& curve : figure.curves)
    legend +=
        fmt::format("<span>{}{}</span>", html::swatch(curve.colour, curve.stroke == Stroke::dashed),
                    html::escape(curve.label));
  if (cut_time >= 0.0) legend += "<span>" + html::swatch(palette::ink, true) + "cut through</span>";
  return legend;
}

void add_cut_curves(Figures& figures) {
  figures.add("Depth of the water front", {"front depth", "m"}, {{"front_depth", "front depth"}});
  figures.add("Fractured solid", {"fractured mass", "%"},
              {{"fractured_fraction", "share of the solid's mass", 100.0}});
}

void add_energy(Figures& figures) {
  const std::vector<Figures::Line> kinds = {
      {"kinetic", "kinetic"},
      {"pressure_work", "work against pressure"},
      {"elastic_deviatoric", "elastic, shape"},
      {"elastic_strain", "elastic, total Lagrangian"},
      {"hourglass", "hourglass control"},
      {"rigid_potential", "plate repulsion"},
      {"dissipated_artificial", "lost to artificial viscosity"},
      {"dissipated_viscous", "lost to water's viscosity"},
      {"dissipated_fracture", "lost to fracture"},
      {"dissipated_plastic", "lost to plastic flow"},
      {"dissipated_density", "lost by the continuity equation"},
      {"dissipated_reinitialisation", "lost to density reinitialisation"},
      {"dissipated_damping", "lost to relaxation"}};
  figures.add("Energy by kind", {"energy", figures.unit("J")}, kinds);
  figures.add("Errors of the balances", {"error", "%"},
              {{"energy_drift", "energy", 100.0},
               {"momentum_error", "momentum", 100.0},
               {"mass_error", "mass", 100.0}});
}

void add_momentum(Figures& figures) {
  std::vector<Figures::Line> lines = {{"momentum_now_y", "of the particles"},
                                      {"momentum_in_y", "brought by the jets"},
                                      {"momentum_out_y", "left"}};
  if (figures.moves("impulse_rigid_y"))
    lines.push_back({"impulse_rigid_y", "impulse of the plate"});
  if (figures.moves("impulse_constraint_y"))
    lines.push_back({"impulse_constraint_y", "impulse of nozzles and clamps"});
  if (figures.moves("impulse_gravity_y"))
    lines.push_back({"impulse_gravity_y", "impulse of gravity"});
  figures.add("Vertical momentum (up is positive)", {"momentum", figures.unit("N s")}, lines);
}

// `term` is force_water or force_rigid.
void add_force(Figures& figures, int dimension, const std::string& title, const std::string& term) {
  if (!figures.moves(term + "_y")) return;
  std::vector<Figures::Line> lines = {{term + "_y", "vertical"}, {term + "_x", "across"}};
  if (dimension == 3) lines.push_back({term + "_z", "along z"});
  figures.add(title, {"force", figures.unit("N")}, lines);
}

void add_probes(Figures& figures, const Case& description) {
  std::vector<Figures::Line> pressures, forces;
  for (const Probe& probe : description.probes) {
    if (!probe.is_plane())
      pressures.push_back({probe.name + "_pressure", probe.name});
    else
      forces.push_back({probe.name + "_force_y", probe.name});
  }
  if (!pressures.empty()) figures.add("Pressure at the probes", {"pressure", "Pa"}, pressures);
  if (!forces.empty())
    figures.add("Vertical force at the probes", {"force", figures.unit("N")}, forces);
}

// Returns the least and the greatest number of y[begin..end) in the order in which they occur.
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

std::vector<ReportFigure> report_figures(const SeriesTable& series, const Case& description) {
  Figures figures(series, description);
  if (!description.jets.empty()) add_cut_curves(figures);
  add_energy(figures);
  add_momentum(figures);
  add_force(figures, description.dimension, "Force of the water on the workpiece", "force_water");
  add_force(figures, description.dimension, "Force on the plate", "force_rigid");
  add_probes(figures, description);
  figures.add_time_step();
  return std::move(figures).result();
}

std::string report_plots(const std::vector<ReportFigure>& figures, const std::vector<double>& time,
                         double cut_time) {
  std::string text;
  for (const ReportFigure& figure : figures)
    text += fmt::format(
        "<figure><figcaption>{}<div class=\"legend\">{}</div></figcaption>{}</figure>\n",
        figure.title, plot_legend(figure, cut_time),
        draw_plot({{"time", "s"}, figure.axis, time, figure.curves, {}, cut_time}));
  return "<div class=\"plots\">\n" + text + "</div>\n";
}

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
