// SPDX-License-Identifier: Apache-2.0
// This header declares the keys of a case that a study names, each with its place in the study
// file. A key that two places name would keep the value of one of them only, so it is refused.
#pragma once

#include <string>
#include <vector>

#include "input/problems.hpp"
#include "study/key_path.hpp"

namespace kerf {

// A key of the case as one table of the study names it.
struct NamedKey {
  std::string table;         // "set", "vary", "search", "calibrate", "calibrate.at", ...
  std::string reported_key;  // as the study file has it: "vary.jet.jet.speed"
  int line = 0;
  KeyPath path;
};

// Notes a problem for each key that the study names twice where once would do: in one table, under
// two names, or with a value that another table replaces in all runs.
void refuse_repeated_keys(const std::vector<NamedKey>& named, Problems& problems);

}  // namespace kerf
