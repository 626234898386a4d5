// SPDX-License-Identifier: Apache-2.0
// This file runs verification cases and judges them.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "model/case.hpp"
#include "simulation/frame.hpp"
#include "verification/kept_runs.hpp"
#include "verification/plan.hpp"
#include "verification/series.hpp"

namespace kerf {

enum class Verdict {
  pass,
  fail,
  reported,  // nothing to be compared with
  coarse,    // not judged: a finer run is
};

struct Row {
  std::string case_name, quantity, run, unit, source;
  std::string placement;                              // of the run
  double measured = 0.0;                              // in `unit`; NaN when the run gave none
  std::optional<double> low, high;                    // the range of Kerf's values, in `unit`
  std::optional<double> reference, error, tolerance;  // error and tolerance relative
  std::optional<double> scatter;                      // of the reference, in `unit`
  std::optional<double> at_least, at_most;
  bool is_calibrated = false;  // a constant of the case was fitted to the reference
  Verdict verdict = Verdict::reported;
  std::vector<std::string> holds_in;  // the placements in which it passes
  std::string problem;                // why there is no number
  double seconds = 0.0;               // of the run, or of the runs of which this is the worst
};

// The signal of a check over time, in each run that was made.
struct CheckCurves {
  std::string case_name, quantity;
  std::string unit;                 // SI; "1" = a plain number
  std::vector<std::string> runs;    // from coarse to fine
  std::vector<TimeSeries> series;   // one for each run
  std::optional<double> reference;  // in `unit`, where the check compares a value of the signal
};

// The state of a run at the time of the picture that its plan requests.
struct RunImage {
  std::string case_name, run;
  Case description;
  Frame frame;
};

struct Findings {
  std::vector<Row> rows;
  // Of the cases that were set up elsewhere too: where, and why not in other ways.
  std::map<std::string, std::string> elsewhere;
  std::vector<CheckCurves> curves;  // of the checks with `plot`
  std::vector<RunImage> images;
};

// Runs a case and judges its checks. Each run that a due check needs is made once, or taken from
// those kept. The rows of a run that fails, fail.
Findings verify(const VerificationCase& verification, bool all, const VerifyProgress& progress,
                const KeptRuns& kept = {});

// Marks long runs that are kept as due, because they take no time.
void take_up_kept(VerificationCase& verification, const KeptRuns& kept);

bool has_failed(const std::vector<Row>& rows);

}  // namespace kerf
