// SPDX-License-Identifier: Apache-2.0
#include "study/run_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "input/units.hpp"
#include "output/csv.hpp"
#include "output/hdf5.hpp"
#include "output/result_metrics.hpp"
#include "study/limit_plan.hpp"
#include "study/metrics.hpp"
#include "study/study_runs.hpp"

namespace kerf {

namespace {

using Storage = RunColumn::Storage;

void add_axis(std::vector<Axis>& axes, const Axis& axis) {
  const auto same = [&](const Axis& other) { return other.name() == axis.name(); };
  if (std::none_of(axes.begin(), axes.end(), same)) axes.push_back(axis);
}

void add_once(std::vector<std::string>& names, const std::string& name) {
  if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
}

// Returns the entry of that name, or `none`.
template <class Map>
typename Map::mapped_type entry_or(const Map& map, const std::string& name,
                                   typename Map::mapped_type none) {
  const auto found = map.find(name);
  return found == map.end() ? none : found->second;
}

RunColumn axis_column(const Axis& axis, const std::vector<RunRow>& runs) {
  RunColumn column{axis.name(), axis.path.unit()};
  column.choices = axis.words;
  if (!axis.words.empty()) column.storage = Storage::choices;
  for (const RunRow& row : runs) {
    const auto& [numbers, words] = row.trial.setting;
    if (axis.words.empty())
      column.numbers.push_back(entry_or(numbers, axis.name(), std::nan("")));
    else
      column.words.push_back(entry_or(words, axis.name(), ""));
  }
  return column;
}

template <class ValueOf>
RunColumn number_column(const std::string& name, std::string_view unit,
                        const std::vector<RunRow>& runs, ValueOf value_of) {
  RunColumn column{name, std::string(unit)};
  for (const RunRow& row : runs) column.numbers.push_back(value_of(row));
  return column;
}

template <class WordOf>
RunColumn word_column(const std::string& name, Storage storage, const std::vector<RunRow>& runs,
                      WordOf word_of) {
  RunColumn column{name};
  column.storage = storage;
  for (const RunRow& row : runs) column.words.push_back(word_of(row));
  return column;
}

std::string cell(const RunColumn& column, std::size_t row) {
  if (!column.words.empty()) return csv_text(column.words[row]);
  return std::isnan(column.numbers[row]) ? "" : shortest(column.numbers[row]);
}

// Stores each word as its index in the list of choices, which is an attribute; -1 = none of them.
void write_choices(const hdf5::Handle& table, const RunColumn& column) {
  std::vector<std::int64_t> indices;
  for (const std::string& word : column.words) {
    const auto found = std::find(column.choices.begin(), column.choices.end(), word);
    indices.push_back(found == column.choices.end() ? -1 : found - column.choices.begin());
  }
  const hdf5::Handle array = hdf5::write(table, column.name, hdf5::block(indices));
  hdf5::write_text_attribute(array, "words", fmt::format("{}", fmt::join(column.choices, "\n")));
}

void write_column(const hdf5::Handle& table, const RunColumn& column) {
  if (column.storage == Storage::choices) return write_choices(table, column);
  if (column.storage == Storage::hexadecimal) {
    constexpr int base = 16;
    std::vector<std::uint64_t> ids;
    for (const std::string& word : column.words)
      ids.push_back(std::strtoull(word.c_str(), nullptr, base));
    hdf5::write(table, column.name, hdf5::block(ids));
  }
  if (column.storage == Storage::whole_numbers)
    hdf5::write(
        table, column.name,
        hdf5::block(std::vector<std::int64_t>(column.numbers.begin(), column.numbers.end())));
  if (column.storage == Storage::numbers) {
    const hdf5::Handle array = hdf5::write(table, column.name, hdf5::block(column.numbers));
    hdf5::write_text_attribute(array, "unit", column.unit.empty() ? "1" : column.unit);
  }
}

// Pads every column to its widest entry.
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
  return metric_unit(name, plan.dimension);
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
  // A setting that is in the result too, such as the pressure, has the column of its key.
  for (const Axis& axis : all_axes(plan)) std::erase(names, axis.name());
  return names;
}

RunVerdict verdict_of(const RunRow& row) {
  if (row.state == RunState::failed) return RunVerdict::failed;
  if (row.state != RunState::done) return RunVerdict::not_run_yet;
  if (is_not_reached(row.metrics)) return RunVerdict::not_reached;
  const auto verdict = cuts(row.metrics);
  if (!verdict) return RunVerdict::done;
  if (may_cut(row.metrics)) return RunVerdict::may_cut;
  if (*verdict) return RunVerdict::cut_through;
  const bool is_exposure = row.metrics.contains("exposure.cuts");
  return was_still_cutting(row.metrics) && !is_exposure ? RunVerdict::undecided
                                                        : RunVerdict::not_cut_through;
}

bool ended_too_soon(const Condition& condition, const RunRow& row) {
  const bool may_come = condition.at_least && condition.metric != certain_feed;
  return row.state == RunState::done && may_come && was_still_cutting(row.metrics) &&
         !condition.holds(row.metrics);
}

std::string too_soon_sentence(const Condition& condition, const std::vector<RunRow>& runs) {
  const auto count = std::count_if(
      runs.begin(), runs.end(), [&](const RunRow& row) { return ended_too_soon(condition, row); });
  if (count == 0) return "";
  return fmt::format(
      "{} run{} undecided: the jet was still cutting when {} ended, which counts as not "
      "satisfying; a later `end` in [time] tells more",
      count, count == 1 ? " is" : "s are", count == 1 ? "it" : "they");
}

std::string report_of(const RunRow& row) {
  if (row.state != RunState::done) return "";
  return (run_folder(row.id) / "report.html").generic_string();
}

std::string shown_value(const Setting& setting, const Axis& axis) {
  const auto number = setting.numbers.find(axis.name());
  if (number != setting.numbers.end()) return show_number(number->second, axis);
  return entry_or(setting.words, axis.name(), "as the case");
}

std::vector<RunColumn> run_columns(const StudyPlan& plan, const std::vector<RunRow>& runs) {
  std::vector<RunColumn> columns;
  columns.push_back(
      word_column("id", Storage::hexadecimal, runs, [](auto& row) { return row.id; }));
  columns.push_back(word_column("state", Storage::choices, runs, [](auto& row) {
    return std::string(run_state_words[static_cast<std::size_t>(row.state)]);
  }));
  columns.back().choices.assign(run_state_words.begin(), run_state_words.end());
  for (const Axis& axis : all_axes(plan)) columns.push_back(axis_column(axis, runs));
  columns.push_back(number_column("repeat", "", runs, [](auto& row) { return row.trial.repeat; }));
  columns.back().storage = Storage::whole_numbers;
  columns.push_back(
      number_column("refinement", "", runs, [](auto& row) { return row.trial.refinement; }));
  columns.push_back(number_column("spacing", "m", runs, [](auto& row) { return row.spacing; }));
  for (const std::string& name : shown_metrics(plan))
    columns.push_back(number_column(name, unit_of(plan, name), runs, [&](auto& row) {
      return entry_or(row.metrics, name, std::nan(""));
    }));
  columns.push_back(word_column("report", Storage::csv_only, runs, report_of));
  columns.push_back(
      word_column("error", Storage::csv_only, runs, [](auto& row) { return row.error; }));
  return columns;
}

std::string study_csv(const StudyPlan& plan, const std::vector<RunRow>& runs) {
  const auto columns = run_columns(plan, runs);
  std::vector<std::string> cells;
  for (const RunColumn& column : columns) cells.push_back(with_unit(column.name, column.unit));
  std::string text = fmt::format("{}\r\n", fmt::join(cells, ","));
  for (std::size_t row = 0; row < runs.size(); ++row) {
    cells.clear();
    for (const RunColumn& column : columns) cells.push_back(cell(column, row));
    text += fmt::format("{}\r\n", fmt::join(cells, ","));
  }
  return text;
}

std::string study_hdf5(const StudyPlan& plan, const std::vector<RunRow>& runs) {
  const hdf5::Handle file = hdf5::create();
  const hdf5::Handle table = hdf5::create_group(file, "runs");
  hdf5::write_text_attribute(table, "title", plan.title);
  for (const RunColumn& column : run_columns(plan, runs)) write_column(table, column);
  return hdf5::bytes_of(file);
}

std::string study_text(const StudyPlan& plan, const std::vector<RunRow>& runs) {
  const auto axes = all_axes(plan);
  std::vector<std::vector<std::string>> rows{{"run"}};
  for (const Axis& axis : axes) rows[0].push_back(axis.name());
  for (const char* name : {"spacing/mm", "repeat", "verdict", "depth/mm", "width/mm"})
    rows[0].emplace_back(name);
  for (const RunRow& row : runs) {
    std::vector<std::string> cells{row.id};
    for (const Axis& axis : axes) cells.push_back(shown_value(row.trial.setting, axis));
    cells.push_back(fmt::format("{:.4g}", 1e3 * row.spacing));
    cells.push_back(std::to_string(row.trial.repeat));
    cells.emplace_back(verdict_words[static_cast<std::size_t>(verdict_of(row))]);
    cells.push_back(in_mm(row, "kerf.depth"));
    cells.push_back(in_mm(row, "kerf.middle.width"));
    rows.push_back(std::move(cells));
  }
  return aligned(rows);
}

}  // namespace kerf
