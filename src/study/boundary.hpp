// SPDX-License-Identifier: Apache-2.0
// This header declares the boundary of cut-through in a map of runs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "study/axis.hpp"
#include "study/study_database.hpp"

namespace kerf {

// The verdict changes between two runs that are neighbours along `key` and equal in all other keys.
struct Crossing {
  std::string key;
  double low = 0.0, high = 0.0;  // SI, the values of the two runs
  bool cuts_above = false;       // otherwise below
  Setting at;                    // the values of the other keys
};

// Returns the boundary from finished runs of one resolution. Only the first layout counts.
std::vector<Crossing> cut_boundary(const std::vector<Axis>& axes, const std::vector<RunRow>& runs);

}  // namespace kerf
