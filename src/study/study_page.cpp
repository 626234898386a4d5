// SPDX-License-Identifier: Apache-2.0
#include "study/study_page.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "core/version.hpp"
#include "input/key_text.hpp"
#include "output/files.hpp"
#include "output/result_metrics.hpp"
#include "report/html.hpp"
#include "report/plot.hpp"
#include "report/viewer_files.hpp"
#include "study/axis_label.hpp"
#include "study/run_table.hpp"

namespace kerf {

namespace {

using Json = nlohmann::ordered_json;

constexpr auto least_pause = std::chrono::seconds(4);
constexpr int curve_points = 49;              // of the model along one variable
constexpr std::size_t most_shown_levels = 9;  // of another variable, each with a curve
constexpr std::size_t most_curves = 81;       // along one variable
constexpr const char* state_words[] = {"running", "stopped", "ended"};

using Points = std::vector<std::map<std::string, double>>;

// Returns every combination of the points with the values of one more variable.
Points combined(const Points& points, const std::string& name, const std::set<double>& values) {
  Points result;
  for (const auto& point : points)
    for (const double value : values) {
      result.push_back(point);
      result.back()[name] = value;
    }
  return result;
}

// Returns the values of the other variables at which runs exist, one curve each; none where there
// would be too many curves.
Points curve_points_of(const std::vector<std::string>& variables, const std::string& along,
                       const ReducedModel& model, const std::vector<RunRow>& runs) {
  Points points{{}};
  for (const std::string& name : variables) {
    if (name == along) continue;
    const ModelRange range = model.ranges().at(name);
    std::set<double> values;
    for (const RunRow& row : runs)
      if (const double* value = find_number(row, name);
          value && *value >= range.low && *value <= range.high)
        values.insert(*value);
    if (values.size() > most_shown_levels) return {};
    points = combined(points, name, values);
    if (points.size() > most_curves) return {};
  }
  return points;
}

Json model_points(const StudyPlan& plan, const StudyAnswers& answers) {
  Json points = Json::array();
  if (!answers.model || !answers.model->problem().empty()) return points;
  std::vector<std::string> variables = plan.model->variables;
  if (!plan.model->drive.empty()) variables.insert(variables.begin(), plan.model->drive);
  for (const std::string& along : variables) {
    const ModelRange range = answers.model->ranges().at(along);
    for (const auto& point : curve_points_of(variables, along, *answers.model, answers.runs))
      for (int i = 0; i < curve_points; ++i) {
        auto at = point;
        at[along] = between(range.low, range.high, i / (curve_points - 1.0), false);
        const ModelPrediction says = answers.model->predict(at);
        points.push_back({{"along", along},
                          {"at", at},
                          {"value", says.value},
                          {"low", says.low},
                          {"high", says.high}});
      }
  }
  return points;
}

// Adds the labels of the varied keys, and what they mean, by the schema.
void add_keys(Json& data, const StudyPlan& plan) {
  const auto axes = all_axes(plan);
  for (const Axis& axis : axes) {
    data["labels"][axis.name()] = axis_label(axis, axes);
    data["help"][axis.name()] = key_help(*axis.path.key);
  }
  const Key& spacing = *find_key("body", "spacing", {});
  data["units"][spacing.name] = spacing.unit;
  data["labels"][spacing.name] = key_label(spacing);
  data["help"][spacing.name] = key_help(spacing);
}

// Adds the units and labels of the metrics of the runs.
void add_metrics(Json& data, const StudyPlan& plan, const std::vector<RunRow>& runs) {
  const auto add = [&](const std::string& name) {
    data["units"][name] = metric_unit(name, plan.dimension);
    data["labels"][name] = metric_label(name);
  };
  // Those of the tables also where no run has a value.
  for (const std::string& name : shown_metrics(plan)) add(name);
  for (const RunRow& row : runs)
    for (const auto& [name, value] : row.metrics) add(name);
}

std::string heading(const StudyPlan& plan) {
  return fmt::format(
      "<header>\n<h1>{}</h1>\n<p class=\"meta\">Study <code>{}</code> of the case <code>{}</code> "
      "· "
      "Kerf {}</p>\n</header>\n",
      html::escape(plan.title), html::escape(plan.name),
      html::escape(std::filesystem::path(plan.base_name).stem().string()), program_version);
}

std::string static_part(const StudyPlan& plan, const StudyAnswers& answers, bool has_script) {
  const char* why =
      has_script ? "The maps of this page need JavaScript; this is the content without it."
                 : "This program was built without npm, so this page has no interactive maps.";
  std::string words = html::escape(answers_text(describe_answers(plan, answers)));
  if (!words.empty()) words = "<pre class=\"answers\">" + words + "</pre>\n";
  return fmt::format("<p class=\"meta\">{}</p>\n{}{}{}", why, words, static_map(plan, answers.runs),
                     static_table(plan, answers.runs));
}

std::string words_of(RunVerdict verdict) {
  return std::string(verdict_words[static_cast<std::size_t>(verdict)]);
}

Mark mark_of(RunVerdict verdict) {
  switch (verdict) {
    case RunVerdict::not_cut_through:
    case RunVerdict::undecided:
    case RunVerdict::may_cut:
      return Mark::hollow;
    case RunVerdict::failed:
      return Mark::crossed;
    case RunVerdict::not_reached:
    case RunVerdict::not_run_yet:
      return Mark::dotted;
    default:
      return Mark::filled;
  }
}

// Returns the title of an axis, in the units of the study.
PlotAxis plot_axis(const Axis& axis, const std::vector<Axis>& axes) {
  const std::string label = axis_label(axis, axes);
  return {axis.path.unit().empty() ? label : label + " in " + axis.shown_unit, "1"};
}

}  // namespace

std::string static_map(const StudyPlan& plan, const std::vector<RunRow>& runs) {
  const std::vector<Axis> all = all_axes(plan);
  std::vector<Axis> axes = all;
  std::erase_if(axes, [](const Axis& axis) { return axis.values.size() < 2; });
  if (axes.size() < 2) return "";
  const Axis &across = axes[0], &upward = axes[1];
  Plot plot{plot_axis(across, all), plot_axis(upward, all)};
  for (const RunRow& row : runs) {
    const auto& numbers = row.trial.setting.numbers;
    const auto x = numbers.find(across.name()), y = numbers.find(upward.name());
    if (x == numbers.end() || y == numbers.end() || row.trial.refinement != plan.refinement)
      continue;
    const RunVerdict verdict = verdict_of(row);
    plot.points.push_back({x->second / across.shown_factor(), y->second / upward.shown_factor(),
                           mark_of(verdict), words_of(verdict), report_of(row)});
  }
  return fmt::format(
      "<figure><figcaption>{} across, {} upwards: filled = cut through, hollow = not, crossed = "
      "failed, dotted = not reached by the water or not run yet</figcaption>\n{}</figure>\n",
      html::escape(axis_label(across, all)), html::escape(axis_label(upward, all)),
      draw_plot(plot));
}

std::string static_table(const StudyPlan& plan, const std::vector<RunRow>& runs) {
  const auto axes = all_axes(plan);
  std::string text = "<table><thead><tr><th>verdict</th>";
  for (const Axis& axis : axes)
    text += fmt::format("<th title=\"{}\">{}</th>", html::escape(key_help(*axis.path.key)),
                        html::escape(axis_label(axis, axes)));
  text += "<th>spacing</th><th>depth of the kerf</th><th>run</th></tr></thead><tbody>\n";
  for (const RunRow& row : runs) {
    text += fmt::format("<tr><th scope=\"row\">{}</th>", words_of(verdict_of(row)));
    for (const Axis& axis : axes)
      text += fmt::format("<td>{}</td>", html::escape(shown_value(row.trial.setting, axis)));
    const double* depth = find_number(row, "kerf.depth");
    text += fmt::format("<td>{}</td><td>{}</td>", html::quantity(row.spacing, "m"),
                        depth ? html::quantity(*depth, "m") : "–");
    const std::string report = report_of(row);
    text += report.empty() ? fmt::format("<td>{}</td></tr>\n", html::escape(row.error))
                           : fmt::format("<td><a href=\"{}\">report</a></td></tr>\n", report);
  }
  return text + "</tbody></table>\n";
}

Json study_page_data(const StudyPlan& plan, const StudyAnswers& answers, StudyState state) {
  Json data;
  data["state"] = state_words[static_cast<std::size_t>(state)];
  data["written"] = fmt::format("{:%Y-%m-%d %H:%M:%S} UTC", fmt::gmtime(std::time(nullptr)));
  for (const char* words : {"units", "labels", "help"}) data[words] = Json::object();
  add_keys(data, plan);
  add_metrics(data, plan, answers.runs);
  data["model_points"] = model_points(plan, answers);
  data["study"] = Json::parse(study_json(plan, answers));
  return data;
}

std::string study_page(const StudyPlan& plan, const StudyAnswers& answers, StudyState state) {
  const std::string_view script = viewer_text("study_script");
  std::string body =
      heading(plan) + html::section("kerf-study", static_part(plan, answers, !script.empty()));
  if (!script.empty())
    body += html::data_script("kerf-study-data", study_page_data(plan, answers, state).dump()) +
            fmt::format("<script>{}</script>\n", script);
  return html::page(plan.title, body, "study_style");
}

void StudyPageFile::follow(std::size_t ended, std::size_t total,
                           const std::function<StudyAnswers()>& answers) {
  const auto now = std::chrono::steady_clock::now();
  const std::pair seen{ended, total};
  if (seen == seen_ || now - written_ < least_pause) return;
  write(answers(), StudyState::running);
  seen_ = seen;
  written_ = std::chrono::steady_clock::now();
}

void StudyPageFile::write(const StudyAnswers& answers, StudyState state) const {
  write_file(folder_ / "study.html", study_page(plan_, answers, state));
}

}  // namespace kerf
