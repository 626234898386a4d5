// SPDX-License-Identifier: Apache-2.0
#include "study/study_table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "case/units.hpp"
#include "output/csv.hpp"
#include "study/metrics.hpp"
#include "study/study_runs.hpp"

namespace kerf {

namespace {

void add_axis(std::vector<Axis>& axes, const Axis& axis) {
  const auto same = [&](const Axis& other) { return other.name() == axis.name(); };
  if (std::none_of(axes.begin(), axes.end(), same)) axes.push_back(axis);
}

void add_once(std::vector<std::string>& names, const std::string& name) {
  if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
}

std::string state_text(RunState state) {
  return std::string(run_state_words[static_cast<std::size_t>(state)]);
}

std::string metric_or(const RunRow& row, const std::string& name, const std::string& none) {
  const auto found = row.metrics.find(name);
  return found == row.metrics.end() ? none : shortest(found->second);
}

// Columns as wide as their widest entry.
std::string aligned(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths(rows.front().size());
  for (const auto& row : rows)
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  std::string text;
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) line += fmt::format("{:<{}}  ", row[i], widths[i]);
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text;
}

std::string verdict_of(const RunRow& row) {
  if (row.state != RunState::done) return state_text(row.state);
  const auto found = row.metrics.find("cut_through");
  if (found == row.metrics.end()) return "done";
  return found->second > 0.5 ? "cut through" : "not through";
}

std::string in_mm(const RunRow& row, const std::string& metric) {
  const auto found = row.metrics.find(metric);
  return found == row.metrics.end() ? "-" : fmt::format("{:.4g}", 1e3 * found->second);
}

}  // namespace

std::vector<Axis> all_axes(const StudyPlan& plan) {
  std::vector<Axis> axes = plan.axes;
  if (plan.threshold) add_axis(axes, plan.threshold->axis);
  if (!plan.calibration) return axes;
  add_axis(axes, plan.calibration->axis);
  for (const Axis& axis : plan.calibration->at_axes) add_axis(axes, axis);
  return axes;
}

std::string unit_of(const StudyPlan& plan, const std::string& name) {
  for (const Axis& axis : all_axes(plan))
    if (axis.name() == name) return axis.path.unit();
  return std::string(metric_unit(name));
}

std::string with_unit(const std::string& name, std::string_view unit) {
  return unit.empty() ? name : fmt::format("{} ({})", name, unit);
}

std::vector<std::string> shown_metrics(const StudyPlan& plan) {
  std::vector<std::string> names(std::begin(standard_metrics), std::end(standard_metrics));
  if (plan.threshold) add_once(names, plan.threshold->condition.metric);
  if (plan.optimum) add_once(names, plan.optimum->metric);
  if (plan.calibration) add_once(names, plan.calibration->metric);
  if (plan.model) add_once(names, plan.model->metric);
  for (const std::string& name : plan.metrics) add_once(names, name);
  return names;
}

std::string study_csv(const StudyPlan& plan, const std::vector<RunRow>& runs) {
  const auto axes = all_axes(plan);
  const auto metrics = shown_metrics(plan);
  std::vector<std::string> head{"id", "state"};
  for (const Axis& axis : axes) head.push_back(with_unit(axis.name(), axis.path.unit()));
  for (const char* name : {"repeat", "refinement", "spacing (m)"}) head.emplace_back(name);
  for (const std::string& name : metrics) head.push_back(with_unit(name, metric_unit(name)));
  for (const char* name : {"report", "error"}) head.emplace_back(name);
  std::string text = fmt::format("{}\r\n", fmt::join(head, ","));
  for (const RunRow& row : runs) {
    std::vector<std::string> cells{row.id, state_text(row.state)};
    for (const Axis& axis : axes) {
      const auto& [numbers, words] = row.trial.setting;
      if (const auto number = numbers.find(axis.name()); number != numbers.end())
        cells.push_back(shortest(number->second));
      else if (const auto word = words.find(axis.name()); word != words.end())
        cells.push_back(csv_text(word->second));
      else
        cells.emplace_back();
    }
    cells.push_back(std::to_string(row.trial.repeat));
    cells.push_back(shortest(row.trial.refinement));
    cells.push_back(shortest(row.spacing));
    for (const std::string& name : metrics) cells.push_back(metric_or(row, name, ""));
    cells.push_back(row.state == RunState::done ? (run_folder(row.id) / "report.html").string()
                                                : "");
    cells.push_back(csv_text(row.error));
    text += fmt::format("{}\r\n", fmt::join(cells, ","));
  }
  return text;
}

std::string study_text(const StudyPlan& plan, const std::vector<RunRow>& runs) {
  const auto axes = all_axes(plan);
  std::vector<std::vector<std::string>> rows{{"run"}};
  for (const Axis& axis : axes) rows[0].push_back(axis.name());
  for (const char* name : {"spacing/mm", "repeat", "verdict", "depth/mm", "width/mm"})
    rows[0].emplace_back(name);
  for (const RunRow& row : runs) {
    std::vector<std::string> cells{row.id};
    for (const Axis& axis : axes) {
      const auto& [numbers, words] = row.trial.setting;
      const auto number = numbers.find(axis.name());
      const auto word = words.find(axis.name());
      cells.push_back(number != numbers.end() ? show_number(number->second, axis)
                      : word != words.end()   ? word->second
                                              : "as the case");
    }
    cells.push_back(fmt::format("{:.4g}", 1e3 * row.spacing));
    cells.push_back(std::to_string(row.trial.repeat));
    cells.push_back(verdict_of(row));
    cells.push_back(in_mm(row, "kerf.depth"));
    cells.push_back(in_mm(row, "kerf.middle.width"));
    rows.push_back(std::move(cells));
  }
  return aligned(rows);
}

}  // namespace kerf
