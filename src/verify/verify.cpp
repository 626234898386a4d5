// SPDX-License-Identifier: Apache-2.0
#include "verify/verify.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "case/units.hpp"
#include "core/error.hpp"
#include "verify/series.hpp"
#include "verify/signal.hpp"

namespace kerf {

namespace {

// The signals of a run over time, one for each of the checks that want it.
struct Recording {
  std::vector<TimeSeries> series;
  std::optional<Frame> look;
  double seconds = 0.0;
  std::string problem;
};

void sample(std::vector<Signal>& signals, Moment moment, Recording& recording) {
  for (std::size_t i = 0; i < signals.size(); ++i) {
    recording.series[i].time.push_back(moment.time());
    recording.series[i].value.push_back(signals[i](moment));
  }
}

// One sample at the start, then one at the first step past each multiple of the interval, and one
// at the end.
void record_run(const PlannedRun& run, const std::vector<const Check*>& checks,
                const VerifyProgress& progress, Recording& recording) {
  const Case description = run.description();
  const auto simulation = make_simulation(description);
  Beginning beginning(description, *simulation);
  std::vector<Signal> signals;
  for (const Check* check : checks) signals.push_back(make_signal(check->parameters, beginning));
  const double interval =
      run.sample_interval > 0.0 ? run.sample_interval : description.output.series_interval;
  sample(signals, Moment(beginning, *simulation), recording);
  double next = interval;
  while (!simulation->finished()) {
    simulation->advance();
    if (simulation->time() < next && !simulation->finished()) continue;
    sample(signals, Moment(beginning, *simulation), recording);
    if (run.picture_time && !recording.look && simulation->time() >= *run.picture_time)
      recording.look = simulation->frame();
    next = interval * (std::floor(simulation->time() / interval) + 1.0);
    progress(run.name, simulation->time() / description.time.end);
  }
}

Recording record(const PlannedRun& run, const std::vector<const Check*>& checks,
                 const VerifyProgress& progress) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  Recording recording;
  recording.series.resize(checks.size());
  try {
    record_run(run, checks, progress, recording);
  } catch (const UserError& error) {
    recording.problem = error.what();
  }
  recording.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  return recording;
}

using Recordings = std::map<std::string, Recording>;

double factor_of(const std::string& unit, const Parameters& parameters) {
  const std::string si_unit = parameters.has("si_unit") ? parameters.text("si_unit") : "";
  if (unit == "1") return 1.0;
  const double percent = 0.01;
  if (unit == "%") return percent;
  const Quantity quantity = read_quantity("1 " + unit, si_unit);
  if (!quantity.problem.empty()) parameters.fail("unit: " + quantity.problem);
  return quantity.value;
}

void judge(const Check& check, bool is_judged, Row& row) {
  row.reference = check.reference;
  row.tolerance = check.tolerance;
  row.at_least = check.at_least;
  row.at_most = check.at_most;
  if (check.reference) row.error = row.measured / *check.reference - 1.0;
  if (!check.is_judged()) {
    row.verdict = std::isnan(row.measured) ? Verdict::fail : Verdict::reported;
    return;
  }
  if (!is_judged) {
    row.verdict = Verdict::coarse;
    return;
  }
  // Each comparison is false for NaN.
  const bool good = (!check.reference || std::abs(*row.error) <= *check.tolerance) &&
                    (!check.at_least || row.measured >= *check.at_least) &&
                    (!check.at_most || row.measured <= *check.at_most);
  row.verdict = good ? Verdict::pass : Verdict::fail;
}

// The checks that look at a run.
std::vector<const Check*> checks_of(const VerificationCase& verification, const std::string& run) {
  std::vector<const Check*> checks;
  for (const Check& check : verification.checks)
    if (std::count(check.runs.begin(), check.runs.end(), run) > 0 || check.relative_to == run)
      checks.push_back(&check);
  return checks;
}

Recordings record_all(const VerificationCase& verification, bool all,
                      const VerifyProgress& progress) {
  std::set<std::string> needed;
  for (const Check& check : verification.checks) {
    const auto due = verification.due_runs(check, all);
    needed.insert(due.begin(), due.end());
    if (!due.empty() && !check.relative_to.empty()) needed.insert(check.relative_to);
  }
  Recordings recordings;
  for (const PlannedRun& run : verification.runs)
    if (needed.count(run.name) > 0)
      recordings[run.name] = record(run, checks_of(verification, run.name), progress);
  return recordings;
}

const TimeSeries& series_of(const VerificationCase& verification, const Check& check,
                            const Recordings& recordings, const std::string& run) {
  const auto checks = checks_of(verification, run);
  const auto place = std::find(checks.begin(), checks.end(), &check) - checks.begin();
  return recordings.at(run).series.at(static_cast<std::size_t>(place));
}

// In SI units; NaN when the run broke down.
double measured_in(const VerificationCase& verification, const Check& check,
                   const Recordings& recordings, const std::string& run) {
  if (!recordings.at(run).problem.empty()) return std::numeric_limits<double>::quiet_NaN();
  return reduce(series_of(verification, check, recordings, run), check.parameters);
}

// Whether the number of a check is a value of its signal, so that the two may share an axis.
bool compares_values(const Check& check) {
  static const std::set<std::string> values{"last",    "mean", "hann_mean",
                                            "largest", "peak", "peak_of_mean"};
  return check.relative_to.empty() && values.count(check.parameters.text("reduce")) > 0;
}

CheckCurves curves_of(const VerificationCase& verification, const Check& check,
                      const Recordings& recordings, const std::vector<std::string>& runs) {
  CheckCurves curves{verification.name, check.quantity, "1", runs, {}, {}};
  if (check.parameters.has("si_unit")) curves.unit = check.parameters.text("si_unit");
  for (const std::string& run : runs)
    curves.series.push_back(series_of(verification, check, recordings, run));
  if (check.reference && compares_values(check))
    curves.reference = *check.reference * factor_of(check.unit, check.parameters);
  return curves;
}

Row measured_row(const VerificationCase& verification, const Check& check,
                 const Recordings& recordings, const std::string& run) {
  const auto measured = [&](const std::string& name) {
    return measured_in(verification, check, recordings, name);
  };
  Row row;
  row.case_name = verification.name;
  row.quantity = check.quantity;
  row.run = run;
  row.unit = check.unit;
  row.source = check.source;
  const double unit = factor_of(check.unit, check.parameters);
  row.measured = measured(run) / (check.relative_to.empty() ? unit : measured(check.relative_to));
  row.problem = recordings.at(run).problem;
  row.seconds = recordings.at(run).seconds;
  if (const auto unread = check.parameters.unread(); row.problem.empty() && !unread.empty())
    check.parameters.fail(fmt::format("nobody reads the key \"{}\"", unread.front()));
  return row;
}

}  // namespace

Findings verify(const VerificationCase& verification, bool all, const VerifyProgress& progress) {
  Recordings recordings = record_all(verification, all, progress);
  Findings findings;
  for (const Check& check : verification.checks) {
    const auto due = verification.due_runs(check, all);
    for (const std::string& run : due) {
      Row row = measured_row(verification, check, recordings, run);
      judge(check, check.judges(run, due), row);
      findings.rows.push_back(row);
    }
    if (check.plot && !due.empty())
      findings.curves.push_back(curves_of(verification, check, recordings, due));
  }
  for (auto& [run, recording] : recordings)
    if (recording.look)
      findings.looks.push_back({verification.name, run, verification.run(run).description(),
                                std::move(*recording.look)});
  return findings;
}

bool has_failed(const std::vector<Row>& rows) {
  return std::any_of(rows.begin(), rows.end(),
                     [](const Row& row) { return row.verdict == Verdict::fail; });
}

}  // namespace kerf
