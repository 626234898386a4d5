// SPDX-License-Identifier: Apache-2.0
#include "verification/worst.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace kerf {

namespace {

// Returns the part of its tolerance that a row uses; infinite for one that fails.
double used_tolerance(const Row& row) {
  if (row.verdict == Verdict::fail) return std::numeric_limits<double>::infinity();
  if (!row.error || !row.tolerance || *row.tolerance == 0.0) return 0.0;
  return std::abs(*row.error) / *row.tolerance;
}

}  // namespace

Findings worst_of(Findings written, const Findings& elsewhere) {
  for (Row& row : written.rows) {
    const auto same =
        std::find_if(elsewhere.rows.begin(), elsewhere.rows.end(), [&row](const Row& other) {
          return other.case_name == row.case_name && other.quantity == row.quantity &&
                 other.run == row.run;
        });
    if (same == elsewhere.rows.end()) continue;
    const double seconds = row.seconds + same->seconds;
    auto holds_in = row.holds_in;
    holds_in.insert(holds_in.end(), same->holds_in.begin(), same->holds_in.end());
    if (used_tolerance(*same) > used_tolerance(row)) row = *same;
    row.seconds = seconds;
    row.holds_in = std::move(holds_in);
  }
  return written;
}

}  // namespace kerf
