// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>

#include "study/metrics.hpp"
#include "study/study_answers.hpp"
#include "study/study_table.hpp"

namespace kerf {

namespace {

std::string metric_text(double value, const std::string& name) {
  const std::string_view unit = metric_unit(name);
  if (unit == "m") return fmt::format("{:.4g} mm", 1e3 * value);
  return unit.empty() ? fmt::format("{:.4g}", value) : fmt::format("{:.4g} {}", value, unit);
}

std::string threshold_text(const ThresholdGoal& goal, const ThresholdAnswer& answer) {
  const auto shown = [&](double value) { return show_number(value, goal.axis); };
  const std::string what = fmt::format("{} {} with {}", goal.least ? "Least" : "Greatest",
                                       goal.axis.name(), goal.condition.text());
  if (!answer.problem.empty()) return fmt::format("{}: not found. {}.\n", what, answer.problem);
  std::string text = fmt::format("{}: {}, between {} and {} ({} runs, {} of them drafts)\n", what,
                                 shown(answer.value()), shown(answer.stated.low),
                                 shown(answer.stated.high), answer.runs, answer.draft_runs);
  text += fmt::format("  bracket over {} layout{}: {} to {}{}\n", answer.layouts.size(),
                      answer.layouts.size() == 1 ? "" : "s", shown(answer.bracket.low),
                      shown(answer.bracket.high),
                      answer.is_within_tolerance ? "" : ", wider than the tolerance");
  if (answer.draft)
    text += fmt::format("  at {:.3g} times the spacing: {} to {}; for spacing 0 that makes {}\n",
                        1.0 / goal.draft, shown(answer.draft->low), shown(answer.draft->high),
                        shown(answer.extrapolated));
  const double change = std::abs(answer.resolution_change);
  if (answer.draft && change > 2.0 * (answer.bracket.half_width() + answer.draft->half_width()))
    text +=
        "  the drafts broke elsewhere: too coarse to learn from; choose draft nearer to 1, or a "
        "finer study\n";
  return text;
}

std::string optimum_text(const StudyPlan& plan, const OptimumAnswer& answer) {
  const OptimumGoal& goal = *plan.optimum;
  const std::string what = fmt::format("{} of {} with {}", goal.least ? "Minimum" : "Maximum",
                                       goal.metric, goal.condition.text());
  std::string text = fmt::format("{}: {} at {} ({} runs, {} of them drafts)\n", what,
                                 metric_text(answer.value, goal.metric),
                                 show(answer.setting, plan.axes), answer.runs, answer.draft_runs);
  if (answer.low < answer.high)
    text += fmt::format("  between {} and {}, over {} layout{}{}\n",
                        metric_text(answer.low, goal.metric), metric_text(answer.high, goal.metric),
                        goal.repeats, goal.repeats == 1 ? "" : "s",
                        answer.extrapolated ? " and the change to spacing 0" : "");
  if (answer.extrapolated)
    text += fmt::format("  there at {:.3g} times the spacing: {}; for spacing 0 that makes {}\n",
                        1.0 / goal.draft, metric_text(*answer.draft_value, goal.metric),
                        metric_text(*answer.extrapolated, goal.metric));
  else if (answer.problem.empty() && answer.draft_runs > 0)
    text += fmt::format("  at {:.3g} times the spacing {} does not hold there\n", 1.0 / goal.draft,
                        goal.condition.text());
  if (!answer.problem.empty()) text += fmt::format("  but {}.\n", answer.problem);
  return text;
}

std::string calibration_text(const StudyPlan& plan, const CalibrationAnswer& answer) {
  const CalibrationGoal& goal = *plan.calibration;
  const auto shown = [&](double value) { return show_number(value, goal.axis); };
  if (!answer.problem.empty())
    return fmt::format("{}: not calibrated. {}.\n", goal.axis.name(), answer.problem);
  std::string text =
      fmt::format("{}: {}, between {} and {} ({} runs)\n", goal.axis.name(), shown(answer.value),
                  shown(answer.low), shown(answer.high), answer.runs);
  for (const PredictedCut& cut : answer.predictions)
    text += fmt::format("  at {}: {} {}, between {} and {}\n", show(cut.setting, all_axes(plan)),
                        goal.metric, metric_text(cut.value, goal.metric),
                        metric_text(cut.low, goal.metric), metric_text(cut.high, goal.metric));
  return text;
}

std::string model_text(const ReducedModel& model) {
  if (!model.problem().empty()) return fmt::format("Model: none. {}.\n", model.problem());
  std::string text = fmt::format("Model of {} runs: {}, R^2 = {:.4f}\n", model.used(),
                                 model.formula(), model.fit().explained);
  for (const ModelParameter& entry : model.parameters())
    text += fmt::format("  {} = {:.6g}, between {:.6g} and {:.6g} (SI)\n", entry.name, entry.value,
                        entry.low, entry.high);
  return text;
}

}  // namespace

std::string answers_text(const StudyPlan& plan, const StudyAnswers& answers) {
  std::string text;
  if (answers.threshold) text += threshold_text(*plan.threshold, *answers.threshold);
  if (answers.optimum) text += optimum_text(plan, *answers.optimum);
  if (answers.calibration) text += calibration_text(plan, *answers.calibration);
  if (answers.model) text += model_text(*answers.model);
  return text;
}

}  // namespace kerf
