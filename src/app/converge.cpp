// SPDX-License-Identifier: Apache-2.0
#include "app/converge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/signals.hpp"
#include "app/study_display.hpp"
#include "core/error.hpp"
#include "input/read.hpp"
#include "model/case.hpp"
#include "output/files.hpp"
#include "output/result.hpp"
#include "output/result_metrics.hpp"
#include "report/report.hpp"
#include "report/report_parts.hpp"
#include "study/convergence.hpp"
#include "study/layout.hpp"
#include "study/metrics.hpp"
#include "study/study_plan.hpp"
#include "study/study_runs.hpp"

namespace kerf {

namespace {

namespace fs = std::filesystem;

StudyPlan plan_of(const Case& description, const ConvergeSettings& settings) {
  return plan_of_case(settings.case_file, read_file(settings.case_file), description);
}

std::vector<Trial> trials_of(const Case& description, const CoarserSpacings& spacings,
                             const ConvergeSettings& settings) {
  return convergence_trials(spacings, has_other_layouts(description) ? settings.layouts : 1);
}

void keep(const std::vector<MetricInterval>& intervals, const Case& description,
          const fs::path& folder) {
  RunOutcome outcome;
  outcome.intervals = intervals;
  auto result = read_result(folder / "result.json");
  result["intervals"] = *find_result_metric("intervals")->value(outcome);
  write_file(folder / "result.json", result.dump(2) + "\n");
  write_report(folder, description);
}

void print_intervals(const std::vector<MetricInterval>& intervals, const Case& description,
                     const CoarserSpacings& coarser) {
  const auto [ratio, count] = coarser;
  const bool has_layouts =
      std::any_of(intervals.begin(), intervals.end(),
                  [](const MetricInterval& each) { return std::isfinite(each.layout); });
  const std::string spacings = count > 1 ? fmt::format("1, {:.3g} and {:.3g}", ratio, ratio * ratio)
                                         : fmt::format("1 and {:.3g}", ratio);
  fmt::print("Value [low, high], from spacings {} times as large{}:\n", spacings,
             has_layouts ? " and from layouts" : "");
  for (const MetricInterval& interval : intervals) fmt::print("  {}\n", interval_line(interval));
  if (count == 1)
    fmt::print(
        "  Only one coarser spacing: no two suit the symmetry planes, in which a jet has an even "
        "number of columns and no particles of a body lie.\n");
  if (!has_other_layouts(description))
    fmt::print(
        "  Layouts were not varied: nothing is random and a symmetry plane holds the jet.\n");
  else if (!has_layouts)
    fmt::print("  Layouts were not varied: --layouts 1 asks for one.\n");
  fmt::print("  Material data have no intervals in a case, so their share is left out.\n");
}

void refuse_failures(const std::vector<Outcome>& outcomes, const ConvergeSettings& settings) {
  for (const Outcome& outcome : outcomes)
    if (outcome.failed)
      throw UserError(
          fmt::format("the run {} of --converge failed: {}. The run itself is complete. "
                      "Correct the cause, then continue with: {}",
                      outcome.id, outcome.error, settings.resume_command),
          exit_run_failed);
}

}  // namespace

void check_convergence(const Case& description, const ConvergeSettings& settings) {
  if (description.jets.empty())
    throw UserError(
        fmt::format("{}: --converge needs the numbers of a cut, and the case has no "
                    "jet. Allowed: a case with a [machine] or a [[jet]]. Add one, or "
                    "leave --converge out.",
                    settings.case_file.string()));
  const CaseMaker maker(plan_of(description, settings));
  const std::string name = settings.case_file.string() + " at a coarser spacing (--converge)";
  for (const Trial& trial : trials_of(description, convergence_spacings(description), settings)) {
    const ResolvedCase made = maker.make(trial);
    if (made.meshes.empty()) parse_case(made.text, name);
  }
}

int converge(const Case& description, const ConvergeSettings& settings) {
  const StudyPlan plan = plan_of(description, settings);
  const fs::path folder = settings.folder / "converge";
  make_folder(folder);
  const FolderLock lock(folder);
  StudyDatabase database(folder / "study.db");
  const CaseMaker maker(plan);
  const auto executor = make_executor(settings.executor, folder);
  const StopSignals signals;
  StudyDisplay display(progress_style(settings.executor.quiet));
  constexpr bool retry = true;  // a new start repeats what failed
  StudyRuns runs(
      folder, maker, database, *executor,
      {[&](const StudyProgress& now) { display.show(now); }, [&] { return signals.caught(); }},
      retry);
  const CoarserSpacings spacings = convergence_spacings(description);
  const std::vector<Trial> trials = trials_of(description, spacings, settings);
  std::vector<Outcome> outcomes;
  try {
    outcomes = runs.run(trials);
  } catch (const StudyStopped& stopped) {
    display.clear();
    fmt::print(settings.quiet ? stderr : stdout,
               "Stopped. The run itself is complete; continue with: {}\n", settings.resume_command);
    return stopped.signal;
  }
  display.clear();
  refuse_failures(outcomes, settings);
  Outcome run;
  run.metrics = read_metrics(read_file(settings.folder / "result.json"));
  const auto intervals =
      find_intervals(run, trials, outcomes, spacings.ratio, description.dimension);
  keep(intervals, description, settings.folder);
  if (!settings.quiet) print_intervals(intervals, description, spacings);
  return 0;
}

}  // namespace kerf
