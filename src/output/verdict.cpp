// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "model/case.hpp"
#include "output/readable.hpp"
#include "output/result.hpp"

namespace kerf {
namespace {

std::string depth_sentence(const RunOutcome& outcome) {
  const std::string end = readable(outcome.time, "s");
  const std::string front = readable(outcome.cut.last.front_depth, "m");
  if (outcome.cut.last.fractured_mass == 0.0)
    return fmt::format("The jet breaks nothing within {}; its front presses {} into the workpiece.",
                       end, front);
  return fmt::format("The jet does not cut through within {}; its front is {} deep.", end, front);
}

// With a moving nozzle one hole is not a cut, so the cut share of its path is stated.
std::string way_clause(const RunOutcome& outcome) {
  const auto& travel = outcome.description.jets.front().traverse;
  if (travel == std::array<double, 3>{} || !outcome.kerf) return "";
  return fmt::format(", and all the way down on {:.0f}% of its way so far",
                     100.0 * outcome.kerf->shape.through_share);
}

std::string cut_sentence(const RunOutcome& outcome) {
  const CutSummary& cut = outcome.cut;
  const std::string time = readable(cut.cut_through_time, "s");
  const int pieces = cut.last.pieces;
  if (pieces == 0)
    return fmt::format(
        "The jet cuts through after {}{}; at the end no piece of the workpiece is left that "
        "is larger than 5% of it.",
        time, way_clause(outcome));
  return fmt::format("The jet cuts through after {}{}; at the end the workpiece is in {} {}.", time,
                     way_clause(outcome), pieces, pieces == 1 ? "piece" : "pieces");
}

}  // namespace

bool still_cutting(const std::vector<CutState>& history) {
  if (history.empty() || history.back().cut_through || history.back().fractured_mass == 0.0)
    return false;
  const double late = history.front().time + 0.9 * (history.back().time - history.front().time);
  const auto before = std::find_if(history.begin(), history.end(),
                                   [late](const CutState& state) { return state.time >= late; });
  return history.back().front_depth > before->front_depth;
}

std::string verdict_of(const RunOutcome& outcome) {
  if (outcome.description.jets.empty())
    return fmt::format("The run reached {}; it has no jet, so there is nothing to cut.",
                       readable(outcome.time, "s"));
  return outcome.cut.cut_through ? cut_sentence(outcome) : depth_sentence(outcome);
}

}  // namespace kerf
