// SPDX-License-Identifier: Apache-2.0
// This header declares the answer to a question for a limit as the terminal, limit.json and
// limit.html present it, and the table of its trials.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "study/limit_plan.hpp"
#include "study/searches.hpp"
#include "study/study_database.hpp"

namespace kerf {

struct LimitAnswer {
  std::optional<ThresholdAnswer> threshold;  // of a search that has ended
  std::vector<RunRow> runs;                  // in the order in which they were asked for
};

// What causes the width of the interval, in SI units of the key; null where it was not examined.
struct LimitCauses {
  double bracket = 0.0;           // half-width of the bracket of the first layout
  std::optional<double> layout;   // by which the other layouts extend that bracket
  std::optional<double> spacing;  // change from the value to that for a spacing of 0
};
LimitCauses causes_of(const ThresholdAnswer& answer);

// Returns the bracket that the completed runs of one layout and resolution make; nothing while all
// of them have the same verdict.
std::optional<Bracket> bracket_of(const LimitPlan& plan, const std::vector<RunRow>& runs,
                                  const Trial& of);
// Returns how many more rounds of `side_by_side` runs narrow the bracket to the tolerance, where
// each round divides it into side_by_side + 1 parts.
int rounds_left(const Bracket& bracket, double tolerance, int side_by_side);

// The answer in words.
struct LimitWords {
  std::string question;            // "Greatest feed that still cuts"
  std::string finding;             // "12.4 mm/s, between ..."; why there is none; how far it is
  std::vector<std::string> notes;  // causes of the interval, the stated value, what was held
};
LimitWords describe_limit(const LimitPlan& plan, const LimitAnswer& answer);

// Returns whether a completed run would satisfy the condition only if solid that left the domain
// whole had been cut.
bool rests_on_what_left(const LimitPlan& plan, const RunRow& row);
// Returns whether a completed run does not satisfy the condition and ended while its jet was still
// cutting, or rests on what left the domain: it counts as not satisfying it, and a later end or a
// wider domain may show otherwise.
bool is_undecided(const LimitPlan& plan, const RunRow& row);
// Returns whether a completed run cuts, in the words of the tables: "cuts" or "does not cut",
// "undecided" where it was still cutting or rests on what left the domain, "not reached" without
// water at the workpiece, "may cut" at a feed between the certain and the possible one; of another
// condition "holds" or "does not hold"; "failed" of a failed run.
std::string trial_verdict(const LimitPlan& plan, const RunRow& row);
// Returns the value of the quantity in a run.
double value_of_trial(const LimitPlan& plan, const RunRow& row);
// Returns a number of the result of a run; nan where it has none.
double metric_of(const RunRow& row, const char* name);
// Says how many runs are undecided, and on which side of the limit later ends may take it; empty
// where none is.
std::string undecided_sentence(const LimitPlan& plan, const std::vector<RunRow>& runs);
// Says which runs rest on what left the domain, with the share of the workpiece; empty where none
// does.
std::string left_whole_sentence(const LimitPlan& plan, const std::vector<RunRow>& runs);
// Says of which runs too few particles lie across the jet for a verdict; empty where there is none.
std::string thin_jet_sentence(const LimitPlan& plan, const std::vector<RunRow>& runs);
// Says of which runs the way of the nozzle is too short for a verdict on all of it, less than a few
// times as long as the kerf lags; empty where there is none.
std::string short_way_sentence(const LimitPlan& plan, const std::vector<RunRow>& runs);

// Returns the heading of the table of trials and one line of it, of equal widths.
std::string trial_heading(const LimitPlan& plan);
std::string trial_line(const LimitPlan& plan, std::size_t number, const RunRow& row);

// Returns limit.json, which docs/limits.md describes.
nlohmann::ordered_json limit_json(const LimitPlan& plan, const LimitAnswer& answer);
// Returns limit.html, which loads nothing.
std::string limit_page(const LimitPlan& plan, const LimitAnswer& answer);

}  // namespace kerf
