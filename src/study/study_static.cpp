// SPDX-License-Identifier: Apache-2.0
// A study without a script.
#include <fmt/format.h>

#include <algorithm>

#include "report/html.hpp"
#include "study/study_page.hpp"
#include "study/study_runs.hpp"
#include "study/study_table.hpp"

namespace kerf {

namespace {

constexpr double left = 90.0, top = 10.0, width = 560.0, height = 320.0;  // px, of the map

const char* verdict_of(const RunRow& row) {
  if (row.state == RunState::failed) return "failed";
  if (row.state != RunState::done) return "not run yet";
  const auto found = row.metrics.find("cut_through");
  if (found == row.metrics.end()) return "done";
  return found->second > 0.5 ? "cut through" : "not cut through";
}

std::string report_of(const RunRow& row) {
  return (run_folder(row.id) / "report.html").generic_string();
}

// Filled = cut, hollow = not, crossed = failed, dotted = not run yet.
std::string symbol(const RunRow& row, double x, double y) {
  const std::string verdict = verdict_of(row);
  const bool is_filled = verdict == "cut through" || verdict == "done";
  std::string shape = fmt::format(
      "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"7\" fill=\"{}\" stroke=\"#22272e\" "
      "stroke-width=\"2\"{}/>",
      x, y, is_filled ? "#22272e" : "#fff",
      verdict == "not run yet" ? " stroke-dasharray=\"2 2\"" : "");
  if (verdict == "failed")
    shape = fmt::format(
        "<path d=\"M{:.1f},{:.1f}l12,12m0,-12l-12,12\" stroke=\"#9a3412\" stroke-width=\"3\"/>",
        x - 6.0, y - 6.0);
  shape += fmt::format("<title>{}</title>", verdict);
  if (row.state != RunState::done) return fmt::format("<g>{}</g>\n", shape);
  return fmt::format("<a href=\"{}\">{}</a>\n", report_of(row), shape);
}

double share(const Axis& axis, double value) {
  const auto [low, high] = std::minmax_element(axis.values.begin(), axis.values.end());
  return 0.06 + 0.88 * (*high > *low ? (value - *low) / (*high - *low) : 0.5);
}

std::string text(double x, double y, const char* anchor, const std::string& words) {
  return fmt::format(
      "<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"13\" text-anchor=\"{}\">{}</text>\n", x, y,
      anchor, html::escape(words));
}

}  // namespace

std::string static_map(const StudyPlan& plan, const std::vector<RunRow>& runs) {
  std::vector<Axis> axes = all_axes(plan);
  std::erase_if(axes, [](const Axis& axis) { return axis.values.size() < 2; });
  if (axes.size() < 2) return "";
  const Axis &across = axes[0], &upward = axes[1];
  const auto place_x = [&](double value) { return left + width * share(across, value); };
  const auto place_y = [&](double value) { return top + height * (1.0 - share(upward, value)); };
  std::string body = fmt::format(
      "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"#22272e\"/>\n",
      left, top, width, height);
  for (const double value : {across.values.front(), across.values.back()})
    body += text(place_x(value), top + height + 20.0, "middle", show_number(value, across));
  for (const double value : {upward.values.front(), upward.values.back()})
    body += text(left - 8.0, place_y(value) + 4.0, "end", show_number(value, upward));
  for (const RunRow& row : runs) {
    const auto& numbers = row.trial.setting.numbers;
    const auto x = numbers.find(across.name()), y = numbers.find(upward.name());
    if (x == numbers.end() || y == numbers.end() || row.trial.refinement != plan.refinement)
      continue;
    body += symbol(row, place_x(x->second), place_y(y->second));
  }
  return fmt::format(
      "<figure><figcaption>{} across, {} upwards: filled = cut through, hollow = not, crossed = "
      "failed, dotted = "
      "not run yet</figcaption>\n<svg viewBox=\"0 0 {} {}\">\n{}</svg></figure>\n",
      html::escape(across.name()), html::escape(upward.name()), left + width + 10.0,
      top + height + 30.0, body);
}

std::string static_table(const StudyPlan& plan, const std::vector<RunRow>& runs) {
  const auto axes = all_axes(plan);
  std::string text = "<table><thead><tr><th>verdict</th>";
  for (const Axis& axis : axes) text += fmt::format("<th>{}</th>", html::escape(axis.name()));
  text += "<th>spacing</th><th>depth of the kerf</th><th>run</th></tr></thead><tbody>\n";
  for (const RunRow& row : runs) {
    text += fmt::format("<tr><th scope=\"row\">{}</th>", verdict_of(row));
    for (const Axis& axis : axes) {
      const auto& [numbers, words] = row.trial.setting;
      const auto number = numbers.find(axis.name());
      const auto word = words.find(axis.name());
      const std::string shown = number != numbers.end() ? show_number(number->second, axis)
                                : word != words.end()   ? word->second
                                                        : "as the case";
      text += fmt::format("<td>{}</td>", html::escape(shown));
    }
    const auto depth = row.metrics.find("kerf.depth");
    text += fmt::format("<td>{}</td><td>{}</td>", html::quantity(row.spacing, "m"),
                        depth == row.metrics.end() ? "–" : html::quantity(depth->second, "m"));
    text += row.state == RunState::done
                ? fmt::format("<td><a href=\"{}\">report</a></td></tr>\n", report_of(row))
                : fmt::format("<td>{}</td></tr>\n", html::escape(row.error));
  }
  return text + "</tbody></table>\n";
}

}  // namespace kerf
