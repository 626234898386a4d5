// SPDX-License-Identifier: Apache-2.0
// The plan of `kerf verify`, read from the reference.toml of a folder of validation/ or
// experiments/: which cases run, what is measured in them, and with what it is compared.
// docs/validation.md describes the format.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/embedded_text.hpp"
#include "verification/parameters.hpp"
#include "verification/placement.hpp"

namespace kerf {

struct Case;

struct PlannedRun {
  std::string name;
  std::string case_text;         // the case with its overrides, as TOML
  double refinement = 1.0;       // every spacing is divided by it
  double sample_interval = 0.0;  // s; 0 = the case's series interval
  bool is_long = false;
  bool is_left_out = false;            // only other runs are requested
  std::optional<double> picture_time;  // s; of the picture for the page
  Placement placement;                 // where the case is set up

  // The case as it is written, before it is placed.
  Case description() const;
};

// A check: one row of the table for each of `runs`.
struct Check {
  std::string quantity;
  std::vector<std::string> runs;  // from coarse to fine
  // Runs: the value is the ratio to that of them, or to the mean of theirs; empty: it is its own.
  std::vector<std::string> relative_to;
  // Runs that differ from the judged ones by what is not known, such as the resolution, the layout
  // or a strength within its interval: the row tells the range of the values of all.
  std::vector<std::string> interval;
  std::string unit;                 // of the numbers below, as UDUNITS writes it; "1" = none
  std::optional<double> reference;  // in `unit`; absent: bounds, or reported only
  std::optional<double> tolerance;  // relative
  // Of the reference where it was measured, in `unit`: the half width of the range that holds, if
  // that is wider than the tolerance.
  std::optional<double> scatter;
  std::optional<double> at_least, at_most;
  // The coarsest of `runs` that is judged, with all finer ones; if empty, the finest run that was
  // made is judged alone.
  std::string judged_from;
  // Whether the mean of the runs is judged in place of each: of runs that differ by less than any
  // measurement, as in their layouts, where fracture amplifies such differences.
  bool of_mean = false;
  // A number for each run, such as a speed of the jet: the exponent of the law that the values
  // follow over it is judged in place of them; empty: they are.
  std::vector<double> exponent_over;
  // Whether a constant of the case was fitted to this reference.
  bool is_calibrated = false;
  bool plot = false;          // draw the signal over time for the page
  std::string source;         // of the reference
  Parameters parameters{""};  // signal, reduction and theirs

  // The runs that the rows need beside their own.
  std::vector<std::string> other_runs() const;
  bool is_judged() const { return reference.has_value() || at_least || at_most; }
  // Returns whether a run is judged. `made` are those of `runs` that were made, the last of which
  // is the finest.
  bool judges(const std::string& run, const std::vector<std::string>& made) const;
};

struct VerificationCase {
  std::string name;
  std::string title;
  std::vector<PlannedRun> runs;
  std::vector<Check> checks;
  PlacementRefusals refuses;

  const PlannedRun& run(const std::string& name) const;
  // Leaves out all other runs; the named ones are made even if they are long. Returns false, and
  // changes nothing, if there is none of them.
  bool keep_runs(const std::vector<std::string>& names);
  // Returns the runs of a check that are not long, or all of them; none when another run that it
  // needs is not made.
  std::vector<std::string> due_runs(const Check& check, bool all) const;
};

// Reads all verification cases, in alphabetical order. `folders` holds "NAME/case" and
// "NAME/reference", `templates` the shipped cases by name; a run uses one of either.
std::vector<VerificationCase> read_verification_cases(std::span<const EmbeddedText> folders,
                                                      std::span<const EmbeddedText> templates);

}  // namespace kerf
