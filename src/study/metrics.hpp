// SPDX-License-Identifier: Apache-2.0
// This header declares the numbers of a run by name.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace kerf {

using Metrics = std::map<std::string, double>;

// Returns every number of result.json by its path, "front_depth" or "kerf.middle.width"; true is 1
// and false 0. Lists and null are left out, as are the balance, the counts of limits and the times
// of stages, which describe the run and not the cut.
Metrics read_metrics(const std::string& result_json);

// Returns whether a run cuts: under a nozzle that stands in place of one that moves, whether its
// feed is certain to (analysis/exposure.hpp), since it leaves no path; nothing where it tells none.
std::optional<bool> cuts(const Metrics& metrics);

// Returns whether the feed of such a nozzle may cut but is not certain to.
bool may_cut(const Metrics& metrics);

// The metrics of every table of a study.
inline constexpr std::string_view standard_metrics[] = {
    "cut_through", "cut_through_time",    "front_depth", "kerf.depth",   "kerf.middle.width",
    "kerf.taper",  "kerf.removed_volume", "kerf.margin", "energy_drift", "kerf.specific_energy"};

}  // namespace kerf
