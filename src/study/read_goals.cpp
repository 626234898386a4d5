// SPDX-License-Identifier: Apache-2.0
#include "study/read_study.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "input/section.hpp"
#include "input/units.hpp"
#include "output/result_metrics.hpp"
#include "study/metrics.hpp"
#include "study/run_table.hpp"

namespace kerf {

namespace {

constexpr std::array<std::string_view, 4> find_words{"least", "greatest", "minimum", "maximum"};
constexpr std::array<std::string_view, 3> form_words{"power", "threshold_linear",
                                                     "threshold_power"};
constexpr double infinite = std::numeric_limits<double>::infinity();

// A metric of the cases of a study.
struct StudyMetric {
  std::string name;
  int dimension = 2;  // of the cases
};

// A value of a metric: a text with its unit where it has one, else a number.
double metric_value(StudySection& section, std::string_view name, const StudyMetric& metric,
                    std::optional<double> fallback = {}) {
  const std::string unit = metric_unit(metric.name, metric.dimension);
  if (unit.empty()) return section.number(name, -infinite, infinite, fallback);
  if (fallback && !section.has(name)) return section.number(name, -infinite, infinite, fallback);
  const std::string written = section.text(name);
  const Quantity quantity = read_quantity(written, unit);
  if (!quantity.problem.empty() && section.has(name))
    section.refuse(name, quantity.problem, dimension_of(unit) + " with its unit",
                   fmt::format("Write a text such as \"{}\"", example_of(unit)));
  return quantity.value;
}

Condition read_condition(StudySection& section, int dimension) {
  Condition condition;
  const toml::table* table = section.table("where");
  if (!table) return condition;
  StudySection where(section.problems(), *table, section.path("where"));
  condition.metric = where.metric("metric");
  condition.at_least = !where.has("at_most");
  const char* end = condition.at_least ? "at_least" : "at_most";
  condition.bound = metric_value(where, end, {condition.metric, dimension});
  if (!metric_unit(condition.metric, dimension).empty()) condition.written = where.text(end);
  where.refuse_unknown();
  return condition;
}

std::optional<Axis> read_range(StudySection& section, const std::string& table,
                               AxisReader& reader) {
  const std::string key = section.text("key");
  const toml::node *from = section.node("from"), *to = section.node("to");
  if (key.empty()) return std::nullopt;
  reader.note(table, key, section.path("key"), *section.node("key"));
  return reader.range(key, section.path("key"), from, to);
}

void read_threshold(StudySection& section, AxisReader& reader, StudyPlan& plan) {
  ThresholdGoal goal;
  goal.least = section.text("find") == "least";
  const bool is_logarithmic = section.word("scale", scale_words, 0) == 1;
  goal.condition = read_condition(section, plan.dimension);
  goal.tolerance = section.number("tolerance", 1e-4, 0.5, goal.tolerance);
  goal.draft = section.number("draft", 0.1, 1.0, goal.draft);
  goal.most_runs = section.whole("runs", 2, most_runs, goal.most_runs);
  goal.repeats = section.whole("repeats", 1, 1000, plan.repeats);
  auto axis = read_range(section, "search", reader);
  if (!axis) return;
  goal.axis = std::move(*axis);
  goal.axis.is_logarithmic = is_logarithmic;
  plan.threshold = std::move(goal);
}

void read_optimum(StudySection& section, StudyPlan& plan) {
  OptimumGoal goal;
  goal.least = section.text("find") == "minimum";
  goal.metric = section.metric("metric");
  goal.condition = read_condition(section, plan.dimension);
  goal.tolerance = section.number("tolerance", 1e-4, 0.5, goal.tolerance);
  goal.draft = section.number("draft", 0.1, 1.0, goal.draft);
  goal.most_runs = section.whole("runs", 4, most_runs, goal.most_runs);
  goal.repeats = section.whole("repeats", 1, 1000, plan.repeats);
  for (const Axis& axis : plan.axes)
    if (axis.is_range) goal.axes.push_back(axis);
  if (goal.axes.empty() || goal.axes.size() != plan.axes.size())
    section.refuse("find", "the search needs ranges, and [vary] has a list or nothing",
                   "ranges in [vary]", "Write { from = ..., to = ... } for each key of [vary]");
  plan.optimum = std::move(goal);
}

void read_search(StudySection& top, AxisReader& reader, StudyPlan& plan) {
  const toml::table* table = top.table("search");
  if (!table) return;
  StudySection section(top.problems(), *table, "search");
  const std::size_t find = section.word("find", find_words);
  if (find < 2)
    read_threshold(section, reader, plan);
  else
    read_optimum(section, plan);
  section.refuse_unknown();
}

// Reads a table of keys and values; the axes hold the units in which they are written.
Setting read_setting(const toml::table& table, const std::string& reported_key, AxisReader& reader,
                     std::vector<Axis>& axes) {
  Setting setting;
  const auto is_value = [](const toml::table&) { return false; };
  for_each_key(table, "", is_value, [&](const std::string& path, const toml::node& node) {
    const std::string where = fmt::format("{}.{}", reported_key, path);
    reader.note(reported_key, path, where, node);
    const auto axis = reader.axis(path, where, node);
    if (!axis) return;
    axis->put_level(0, setting);
    axes.push_back(*axis);
  });
  return setting;
}

void read_calibration(StudySection& top, AxisReader& reader, StudyPlan& plan) {
  const toml::table* table = top.table("calibrate");
  if (!table) return;
  StudySection section(top.problems(), *table, "calibrate");
  CalibrationGoal goal;
  goal.metric = section.metric("metric");
  if (goal.metric != "cut_through") {
    goal.measured = metric_value(section, "measured", {goal.metric, plan.dimension});
    goal.uncertainty = metric_value(section, "uncertainty", {goal.metric, plan.dimension}, 0.0);
    const std::string unit = metric_unit(goal.metric, plan.dimension);
    const toml::node* measured = section.node("measured");
    if (measured && !unit.empty()) goal.shown_unit = unit_of(*measured);
    if (!goal.shown_unit.empty())
      goal.shown_factor = read_quantity("1 " + goal.shown_unit, unit).value;
  }
  goal.tolerance = section.number("tolerance", 1e-4, 0.5, goal.tolerance);
  goal.most_runs = section.whole("runs", 4, most_runs, goal.most_runs);
  const toml::table* at = section.table("at");
  if (at) goal.at = read_setting(*at, section.path("at"), reader, goal.at_axes);
  for (const toml::table* entry : section.tables("predict"))
    goal.predict.push_back(read_setting(
        *entry, fmt::format("{}[{}]", section.path("predict"), goal.predict.size() + 1), reader,
        goal.at_axes));
  auto axis = read_range(section, "calibrate", reader);
  section.refuse_unknown();
  if (!axis) return;
  if (axis->values.front() <= 0.0)
    section.refuse("from", "the range is searched by ratios and starts at 0 or below",
                   "greater than 0", "Choose a small value instead");
  goal.axis = std::move(*axis);
  goal.axis.is_logarithmic = true;
  plan.calibration = std::move(goal);
}

// Refuses a variable of the model that no run has as a number.
void check_variable(StudySection& section, std::string_view key, const std::string& name,
                    const StudyPlan& plan) {
  for (const Axis& axis : all_axes(plan))
    if (axis.name() == name && axis.words.empty()) return;
  const std::string problem = why_no_number(name);
  if (problem.empty()) return;
  std::vector<std::string> known = number_names();
  for (const Axis& axis : all_axes(plan)) known.push_back(axis.name());
  const std::string guess = closest(name, known);
  section.refuse(key,
                 fmt::format("\"{}\" is no varied key that holds numbers, and {}", name, problem),
                 "varied keys, and numbers of result.json",
                 guess.empty() ? "Name one of them" : fmt::format("Did you mean \"{}\"?", guess));
}

void read_model(StudySection& top, StudyPlan& plan) {
  const toml::table* table = top.table("model");
  if (!table) return;
  StudySection section(top.problems(), *table, "model");
  ModelGoal goal;
  goal.form = static_cast<ModelForm>(section.word("form", form_words, 2));
  goal.metric = section.metric("metric", goal.metric);
  goal.drive = section.text("drive", "");
  goal.variables = section.texts("variables");
  goal.floor = metric_value(section, "floor", {goal.metric, plan.dimension}, 0.0);
  goal.table_points = section.whole("table_points", 2, 1000, goal.table_points);
  if (goal.drive.empty() && goal.form != ModelForm::power)
    section.refuse("drive", "the key is missing", "a varied key, or a metric",
                   "Name the variable with the threshold, such as \"machine.pressure\"");
  if (goal.form == ModelForm::threshold_linear && !goal.variables.empty())
    section.refuse("variables", "the linear form has none besides the drive", "no such key",
                   "Remove it, or choose form = \"threshold_power\"");
  if (goal.drive.empty() && goal.variables.empty())
    section.refuse("variables", "the model has no variables", "a list of varied keys or metrics",
                   "Add one");
  if (!goal.drive.empty()) check_variable(section, "drive", goal.drive, plan);
  for (const std::string& name : goal.variables) check_variable(section, "variables", name, plan);
  section.refuse_unknown();
  plan.model = std::move(goal);
}

}  // namespace

void read_goals(StudySection& top, AxisReader& reader, StudyPlan& plan) {
  read_search(top, reader, plan);
  read_calibration(top, reader, plan);
  read_model(top, plan);
}

}  // namespace kerf
