// SPDX-License-Identifier: Apache-2.0
// Where the region of cut-through ends in a map.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "study/axis.hpp"
#include "study/study_database.hpp"

namespace kerf {

// Along one key, all others as they stand: the verdict changes between two runs that are
// neighbours.
struct Crossing {
  std::string key;
  double low = 0.0, high = 0.0;  // SI, of the runs either side
  bool cuts_above = false;       // else below
  Setting at;                    // where the other keys stand
};

// Of the finished runs of one resolution and layout. Verdicts are those of the first layout.
std::vector<Crossing> cut_boundary(const std::vector<Axis>& axes, const std::vector<RunRow>& runs);

}  // namespace kerf
