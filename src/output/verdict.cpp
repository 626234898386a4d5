// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "output/result.hpp"

namespace kerf {
namespace {

std::string depth_sentence(const RunOutcome& outcome) {
  const double end = 1e3 * outcome.time, front = 1e3 * outcome.cut.last.front_depth;
  if (outcome.cut.last.fractured_mass == 0.0)
    return fmt::format(
        "The jet breaks nothing within {:.4g} ms; its front presses {:.3g} mm into the workpiece.",
        end, front);
  return fmt::format("The jet does not cut through within {:.4g} ms; its front is {:.3g} mm deep.",
                     end, front);
}

std::string cut_sentence(const CutSummary& cut) {
  const double time = 1e3 * cut.cut_through_time;
  const int pieces = cut.last.pieces;
  if (pieces == 0)
    return fmt::format(
        "The jet cuts through after {:.4g} ms; at the end no piece of the workpiece is left that "
        "is larger than 5% of it.",
        time);
  return fmt::format("The jet cuts through after {:.4g} ms; at the end the workpiece is in {} {}.",
                     time, pieces, pieces == 1 ? "piece" : "pieces");
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
    return fmt::format("The run reached {:.4g} ms; it has no jet, so there is nothing to cut.",
                       1e3 * outcome.time);
  return outcome.cut.cut_through ? cut_sentence(outcome.cut) : depth_sentence(outcome);
}

}  // namespace kerf
