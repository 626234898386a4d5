// SPDX-License-Identifier: Apache-2.0
// Runs verification cases and judges them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "verify/plan.hpp"

namespace kerf {

enum class Verdict {
  pass,
  fail,
  reported,  // nothing to be compared with
  coarse,    // not judged: a finer run is
};

struct Row {
  std::string case_name, quantity, run, unit, source;
  double measured = 0.0;                              // in `unit`; NaN when the run gave none
  std::optional<double> reference, error, tolerance;  // error and tolerance relative
  std::optional<double> at_least, at_most;
  Verdict verdict = Verdict::reported;
  std::string problem;   // why there is no number
  double seconds = 0.0;  // of the run
};

// Told where a run is, from 0 to 1.
using VerifyProgress = std::function<void(const std::string& run, double share)>;

// Each run that some due check needs is made once. A run that breaks down makes its rows fail.
std::vector<Row> verify(const VerificationCase& verification, bool all,
                        const VerifyProgress& progress);

bool has_failed(const std::vector<Row>& rows);

}  // namespace kerf
