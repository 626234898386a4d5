// SPDX-License-Identifier: Apache-2.0
// This header declares the plan of a limit: the least or greatest value of one quantity of a case
// at which it still cuts, as a study with a threshold search.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "study/laboratory.hpp"
#include "study/study_plan.hpp"

namespace kerf {

struct Case;

// What is asked. Texts are as on the command line; "" = not given.
struct LimitQuestion {
  std::string of;           // a word of limit_quantities(), or the path of a key
  std::string find;         // "least" or "greatest"
  std::string where;        // the condition, such as "kerf.depth >= 5 mm"
  std::string from, to;     // ends of the range, such as "20 kPa"
  double tolerance = 0.05;  // half-width of the bracket over its middle
  double refinement = 1.0;  // divides every spacing of the case
  int layouts = 0;          // in which the bracket must hold; 0 = 1, with `converge` 3
  int most_runs = 24;
  bool converge = false;  // also searches at a coarser spacing
};

// A quantity of a case that has a limit, and the keys that state it.
struct LimitQuantity {
  std::string_view name;
  std::string_view of_machine;  // the key of a case with a [machine]; "" = none
  std::string_view of_jet;      // the key of the first [[jet]] of any other case; "" = none
  bool least;                   // the least value that cuts is its limit, else the greatest
  std::string_view meaning;
};
const std::vector<LimitQuantity>& limit_quantities();

// The end of each run. Where the case states none, each run has the one that follows from its own
// setting, as a run of the case with that value has, so that the verdict is that of such a run.
// Where the case states one, all runs of a search are the same task: a jet that does not travel
// acts for the time of the case, and a nozzle travels the path of the case, t_end(v) = t_0 + L / v.
struct LimitEnd {
  double path = 0.0;   // m, L, from the time t_0 on; 0 = the end is that of the case
  double start = 0.0;  // s, t_0, when the nozzle moves and its water has reached the workpiece
  double end = 0.0;    // s, of the case
  // Whether each run has the end that follows from its own setting, as the case states none.
  bool follows = false;
  double at(double speed) const { return path > 0.0 ? start + path / speed : end; }
};

struct LimitPlan {
  StudyPlan study;       // with the threshold
  std::string quantity;  // as asked
  double stated = 0.0;   // SI, the value of the case
  bool is_own_range;     // the range was chosen by the factor below
  LimitEnd end;
  // Whether the feed of a nozzle that stands in the run is asked: one run answers for all feeds.
  bool by_exposure = false;
  double jet_speed = 0.0;         // m/s, of the case; bounds the feeds of such a nozzle
  double feed = 0.0;              // m/s, of the case, of a nozzle that moves in the runs
  std::vector<std::string> held;  // sentences on what is the same in all runs
};

// The factor by which the range extends beyond the stated value to both sides.
inline constexpr double limit_range_factor = 32.0;
// The metrics of the feeds up to which a nozzle that stands in the run cuts for certain, and may
// cut (analysis/exposure.hpp).
inline constexpr std::string_view certain_feed = "exposure.greatest_feed";
inline constexpr std::string_view possible_feed = "exposure.possible_feed";
// The key of a case that sets the end of a run.
inline constexpr std::string_view end_key = "time.end";

// Reads the case file and makes the plan. Throws UserError, which names key, value, allowed values
// and remedy: for a quantity that the case does not have, a stated value of 0, a wrong condition or
// range.
LimitPlan plan_limit(const std::filesystem::path& case_file, const LimitQuestion& question);

// Whether the nozzle moves in the runs of a case.
bool travels(const Case& description);

// Returns sentences on what is the same in all runs, and on the condition where it is more than
// cut-through.
std::vector<std::string> held_in(const LimitPlan& plan, const Case& description);

// Returns the trial with the end of its run.
Trial with_end(const LimitPlan& plan, Trial trial);

}  // namespace kerf
