// SPDX-License-Identifier: Apache-2.0
// This header declares the numbers of a run by name.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace kerf {

using Metrics = std::map<std::string, double>;

// Returns every number of result.json by its path, "front_depth" or "kerf.middle.width"; true is 1
// and false 0. Lists and null are left out, but for the flags below, as are the balance, the counts
// of limits and the times of stages, which describe the run and not the cut.
Metrics read_metrics(const std::string& result_json);

// Flags of the validity of a run that are metrics too, 1 where they are raised (docs/results.md);
// of `left_whole` the share of the workpiece.
inline constexpr std::string_view still_cutting_metric = "validity.still_cutting";
inline constexpr std::string_view not_reached_metric = "validity.not_reached";
inline constexpr std::string_view left_whole_metric = "validity.left_whole";

// Returns why no run has a number of that name, such as "verdict", which is a text; "" where runs
// may have it.
std::string why_no_number(const std::string& name);
// Returns the names of all numbers that a run may have.
std::vector<std::string> number_names();

// Returns whether no water has come to the workpiece within the run, which then tells of no cut.
bool is_not_reached(const Metrics& metrics);
// Returns whether the jet was still cutting when the run ended, before it was through.
bool was_still_cutting(const Metrics& metrics);

// Returns the share of the workpiece that stood until it left the domain, where nobody can tell
// whether the jet cut it.
double left_whole(const Metrics& metrics);

// Returns whether a run cuts: under a nozzle that stands in place of one that moves, whether its
// feed is certain to (analysis/exposure.hpp), since it leaves no path; nothing where it tells none,
// as without water at the workpiece.
std::optional<bool> cuts(const Metrics& metrics);

// Returns whether the feed of such a nozzle may cut but is not certain to.
bool may_cut(const Metrics& metrics);

// The metrics of every table of a study.
inline constexpr std::string_view standard_metrics[] = {
    "cut_through", "cut_through_time",    "front_depth", "kerf.depth",   "kerf.middle.width",
    "kerf.taper",  "kerf.removed_volume", "kerf.margin", "energy_drift", "kerf.specific_energy"};

}  // namespace kerf
