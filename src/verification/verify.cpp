// SPDX-License-Identifier: Apache-2.0
#include "verification/verify.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "input/units.hpp"
#include "verification/combined_rows.hpp"
#include "verification/series.hpp"

namespace kerf {

namespace {

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
  row.scatter = check.scatter;
  row.is_calibrated = check.is_calibrated;
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
  const auto is_near = [&] {
    const double apart = std::abs(row.measured - *check.reference);
    return std::abs(*row.error) <= *check.tolerance || apart <= check.scatter.value_or(0.0);
  };
  const bool good = (!check.reference || is_near()) &&
                    (!check.at_least || row.measured >= *check.at_least) &&
                    (!check.at_most || row.measured <= *check.at_most);
  row.verdict = good ? Verdict::pass : Verdict::fail;
}

// Returns the checks that need a run.
std::vector<const Check*> checks_of(const VerificationCase& verification, const std::string& run) {
  std::vector<const Check*> checks;
  const auto is_in = [&](const std::vector<std::string>& runs) {
    return std::count(runs.begin(), runs.end(), run) > 0;
  };
  for (const Check& check : verification.checks)
    if (is_in(check.runs) || is_in(check.other_runs())) checks.push_back(&check);
  return checks;
}

Recordings record_all(const VerificationCase& verification, bool all,
                      const VerifyProgress& progress, const KeptRuns& kept) {
  std::set<std::string> needed;
  for (const Check& check : verification.checks) {
    const auto due = verification.due_runs(check, all);
    needed.insert(due.begin(), due.end());
    const auto others = check.other_runs();
    if (!due.empty()) needed.insert(others.begin(), others.end());
  }
  Recordings recordings;
  for (const PlannedRun& run : verification.runs) {
    if (needed.count(run.name) == 0) continue;
    const auto checks = checks_of(verification, run.name);
    auto recording = kept.find(verification.name, run, checks);
    if (!recording) {
      recording = record_run(run, checks, progress);
      kept.keep(verification.name, run, checks, *recording);
    }
    recordings[run.name] = std::move(*recording);
  }
  return recordings;
}

const TimeSeries& series_of(const VerificationCase& verification, const Check& check,
                            const Recordings& recordings, const std::string& run) {
  const auto checks = checks_of(verification, run);
  const auto index = std::find(checks.begin(), checks.end(), &check) - checks.begin();
  return recordings.at(run).series.at(static_cast<std::size_t>(index));
}

// Returns the measured value in SI units; NaN if the run failed.
double number_in(const VerificationCase& verification, const Check& check,
                 const Recordings& recordings, const std::string& run) {
  if (!recordings.at(run).problem.empty()) return std::numeric_limits<double>::quiet_NaN();
  return reduce(series_of(verification, check, recordings, run), check.parameters);
}

// Returns whether the number of a check is a value of its signal, so that both may share an axis.
bool compares_values(const Check& check) {
  static const std::set<std::string> values{"last",    "mean", "hann_mean",
                                            "largest", "peak", "peak_of_mean"};
  return check.relative_to.empty() && check.exponent_over.empty() &&
         values.count(check.parameters.text("reduce")) > 0;
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
    return number_in(verification, check, recordings, name);
  };
  Row row;
  row.case_name = verification.name;
  row.quantity = check.quantity;
  row.run = run;
  row.placement = verification.run(run).placement.text();
  row.unit = check.unit;
  row.source = check.source;
  row.problem = recordings.at(run).problem;
  row.seconds = recordings.at(run).seconds;
  double divisor = factor_of(check.unit, check.parameters);
  if (!check.relative_to.empty()) {
    divisor = 0.0;
    for (const std::string& other : check.relative_to)
      divisor += measured(other) / static_cast<double>(check.relative_to.size());
  }
  row.measured = measured(run) / divisor;
  for (const std::string& other : check.interval) {
    const double value = measured(other) / divisor;
    row.low = std::fmin(row.low.value_or(row.measured), value);
    row.high = std::fmax(row.high.value_or(row.measured), value);
    row.seconds += recordings.at(other).seconds;
  }
  const bool is_complete = row.problem.empty() && !recordings.at(run).was_kept;
  if (const auto unread = check.parameters.unread(); is_complete && !unread.empty())
    check.parameters.fail(fmt::format("unknown key \"{}\"", unread.front()));
  return row;
}

}  // namespace

Findings verify(const VerificationCase& verification, bool all, const VerifyProgress& progress,
                const KeptRuns& kept) {
  Recordings recordings = record_all(verification, all, progress, kept);
  Findings findings;
  for (const Check& check : verification.checks) {
    const auto due = verification.due_runs(check, all);
    std::vector<Row> rows;
    for (const std::string& run : due)
      rows.push_back(measured_row(verification, check, recordings, run));
    if (check.of_mean && !rows.empty()) rows = {mean_of(rows)};
    if (!check.exponent_over.empty())
      rows = rows.size() < check.runs.size()
                 ? std::vector<Row>{}
                 : std::vector<Row>{exponent_of(rows, check.exponent_over)};
    const bool is_combined = check.of_mean || !check.exponent_over.empty();
    for (Row& row : rows) {
      judge(check, is_combined || check.judges(row.run, due), row);
      if (row.verdict == Verdict::pass) row.holds_in = {row.placement};
      findings.rows.push_back(row);
    }
    if (check.plot && !due.empty())
      findings.curves.push_back(curves_of(verification, check, recordings, due));
  }
  for (auto& [run, recording] : recordings)
    if (recording.image)
      findings.images.push_back({verification.name, run, verification.run(run).description(),
                                 std::move(*recording.image)});
  return findings;
}

void take_up_kept(VerificationCase& verification, const KeptRuns& kept) {
  for (PlannedRun& run : verification.runs)
    if (run.is_long && kept.find(verification.name, run, checks_of(verification, run.name)))
      run.is_long = false;
}

bool has_failed(const std::vector<Row>& rows) {
  return std::any_of(rows.begin(), rows.end(),
                     [](const Row& row) { return row.verdict == Verdict::fail; });
}

}  // namespace kerf
