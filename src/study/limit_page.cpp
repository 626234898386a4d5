// SPDX-License-Identifier: Apache-2.0
// Writes limit.html: the answer, its plots and the table of its trials.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

#include "core/version.hpp"
#include "report/html.hpp"
#include "report/plot.hpp"
#include "study/limit_answer.hpp"
#include "study/metrics.hpp"
#include "study/run_table.hpp"
#include "study/study_answers.hpp"

namespace kerf {

namespace {

const Axis& axis_of(const LimitPlan& plan) {
  return plan.study.threshold->axis;
}

// Draws one number of the trials over the quantity; the interval of the limit is shaded.
template <class NumberOf>
std::string plot_of(const LimitPlan& plan, const LimitAnswer& answer, const PlotAxis& upward,
                    NumberOf number_of) {
  const Axis& axis = axis_of(plan);
  const double unit = axis.shown_factor();
  Plot plot{
      {axis.path.unit().empty() ? plan.quantity : plan.quantity + " in " + axis.shown_unit, "1"},
      upward};
  if (answer.threshold && answer.threshold->problem.empty())
    plot.bands.push_back(
        {answer.threshold->stated.low / unit, answer.threshold->stated.high / unit});
  for (const RunRow& row : answer.runs) {
    if (row.trial.refinement != plan.study.refinement) continue;
    const bool tells = row.state == RunState::done && !is_not_reached(row.metrics);
    const double value = tells ? number_of(row) : std::nan("");
    if (!std::isfinite(value)) continue;
    const bool holds = plan.study.threshold->condition.holds(row.metrics);
    const double at = row.trial.setting.numbers.at(axis.name());
    plot.points.push_back({at / unit, value, holds ? Mark::filled : Mark::hollow,
                           fmt::format("{}: {}", show_number(at, axis), trial_verdict(plan, row)),
                           report_of(row)});
  }
  return plot.points.empty() ? "" : draw_plot(plot);
}

std::string figure(const std::string& caption, const std::string& drawing) {
  if (drawing.empty()) return "";
  return fmt::format("<figure><figcaption>{}</figcaption>\n{}</figure>\n", caption, drawing);
}

std::string table_of(const LimitPlan& plan, const LimitAnswer& answer) {
  std::string text = fmt::format(
      "<table><thead><tr><th>verdict</th><th>{}</th><th>margin</th><th>depth of the kerf</th>"
      "<th>spacing</th><th>layout</th><th>run</th></tr></thead><tbody>\n",
      html::escape(plan.quantity));
  std::vector<RunRow> rows = answer.runs;
  const auto place = [&](const RunRow& row) {
    return std::tuple(row.spacing, row.trial.repeat,
                      row.trial.setting.numbers.at(axis_of(plan).name()));
  };
  std::stable_sort(rows.begin(), rows.end(),
                   [&](const RunRow& a, const RunRow& b) { return place(a) < place(b); });
  for (const RunRow& row : rows) {
    const bool tells = row.state == RunState::done && !is_not_reached(row.metrics);
    const double* depth = find_number(row, "kerf.depth");
    const std::string report = report_of(row);
    text += fmt::format(
        "<tr><th scope=\"row\">{}</th><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td>"
        "<td>{}</td></tr>\n",
        trial_verdict(plan, row), html::escape(shown_value(row.trial.setting, axis_of(plan))),
        tells ? html::percent(plan.study.threshold->condition.margin(row.metrics)) : "–",
        depth ? html::quantity(*depth, "m") : "–", html::quantity(row.spacing, "m"),
        row.trial.repeat,
        report.empty() ? html::escape(row.error)
                       : fmt::format("<a href=\"{}\">report</a>", html::escape(report)));
  }
  return text + "</tbody></table>\n";
}

}  // namespace

std::string limit_page(const LimitPlan& plan, const LimitAnswer& answer) {
  const LimitWords words = describe_limit(plan, answer);
  std::string body = fmt::format(
      "<header>\n<h1>{}</h1>\n<p class=\"meta\">{} · case <code>{}</code> · Kerf "
      "{}</p>\n</header>\n"
      "<p class=\"verdict\">{}: {}</p>\n<ul>\n",
      html::escape(words.question), html::escape(plan.study.title), html::escape(plan.study.name),
      program_version, html::escape(words.question), html::escape(words.finding));
  for (const std::string& note : words.notes)
    body += fmt::format("<li>{}</li>\n", html::escape(note));
  body +=
      "</ul>\n<h2>Margin and depth</h2>\n<p class=\"meta\">Filled: the condition holds; hollow: "
      "it does not. The interval of the limit is shaded. A margin is the share of the run that "
      "was left after the cut; below zero, minus the share of the thickness that is unbroken.</p>\n"
      "<div class=\"plots\">\n";
  const Condition& condition = plan.study.threshold->condition;
  body += figure("Margin", plot_of(plan, answer, {"margin", "1"}, [&](const RunRow& row) {
                   return condition.margin(row.metrics);
                 }));
  body += figure("Depth of the kerf", plot_of(plan, answer, {"depth", "m"}, [](const RunRow& row) {
                   const double* depth = find_number(row, "kerf.depth");
                   return depth ? *depth : std::nan("");
                 }));
  body += "</div>\n<h2>Runs</h2>\n" + table_of(plan, answer);
  return html::page(words.question, body);
}

}  // namespace kerf
