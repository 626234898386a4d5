// SPDX-License-Identifier: Apache-2.0
// This header declares the numbers of a run by name.
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace kerf {

using Metrics = std::map<std::string, double>;

// Returns every number of result.json by its path, "front_depth" or "kerf.middle.width"; true is 1
// and false 0. Lists and null are left out, as are the balance, the counts of limits and the times
// of stages, which describe the run and not the cut.
Metrics read_metrics(const std::string& result_json);

// The metrics of every table of a study.
inline constexpr std::string_view standard_metrics[] = {
    "cut_through", "cut_through_time",    "front_depth", "kerf.depth",   "kerf.middle.width",
    "kerf.taper",  "kerf.removed_volume", "kerf.margin", "energy_drift", "kerf.specific_energy"};

}  // namespace kerf
