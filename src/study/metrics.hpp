// SPDX-License-Identifier: Apache-2.0
// The numbers of a run by name.
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace kerf {

using Metrics = std::map<std::string, double>;

// Every number of a result.json by its path, "front_depth" or "kerf.middle.width"; true counts 1
// and false 0. Lists, and what is null, have no number; nor have the ledger and the counts of
// limits and times, which describe the run and not the cut.
Metrics read_metrics(const std::string& result_json);

// The SI unit of a metric; "" = a pure number, or one that this program does not know.
std::string_view metric_unit(std::string_view name);

// Those of every table of a study.
inline constexpr std::string_view standard_metrics[] = {
    "cut_through", "cut_through_time",    "front_depth", "kerf.depth",   "kerf.middle.width",
    "kerf.taper",  "kerf.removed_volume", "kerf.margin", "energy_drift", "kerf.specific_energy"};

}  // namespace kerf
