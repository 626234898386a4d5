// SPDX-License-Identifier: Apache-2.0
// The result of a run in which the first of several jets met nothing: what is cut is the work of
// the others.
#include <fmt/format.h>

#include <cmath>

#include "analysis/whole_frame.hpp"
#include "model/case.hpp"
#include "output/readable.hpp"
#include "output/result.hpp"
#include "output/verdict_parts.hpp"

namespace kerf {
namespace {

// Says what the first jet did not do.
std::string first_jet_clause(const RunOutcome& outcome) {
  const Jet& first = outcome.description.jets.front();
  const std::string name = the_jet(outcome), end = readable(outcome.time, "s");
  if (first.start >= outcome.time)
    return fmt::format("{} has not opened within {}: it opens after {}", name, end,
                       readable(first.start, "s"));
  if (!std::isnan(outcome.cut.first_touch_time))
    return fmt::format("{} met no solid before {}", name,
                       readable(outcome.cut.first_touch_time, "s"));
  return fmt::format("{} has met no solid within {}", name, end);
}

std::string deed_of_other(const RunOutcome& outcome) {
  const CutSummary& cut = outcome.cut;
  const std::string other =
      jets_of_whole(outcome.description) > 2 ? "another of them" : "the other one";
  if (!cut.cut_through) return other + (has_broken(outcome) ? " breaks solid" : " breaks nothing");
  const std::string deed = cut.punched   ? "punches a plug out of the workpiece"
                           : cut.severed ? "parts the workpiece"
                                         : "pierces the workpiece";
  return fmt::format("{} {} after {}", other, deed, readable(cut.cut_through_time, "s"));
}

}  // namespace

bool is_of_other_jet(const RunOutcome& outcome) {
  return outcome.cut.is_of_other_jet && has_touched(outcome);
}

std::string other_jet_sentence(const RunOutcome& outcome) {
  return fmt::format("{}; {}{}.", first_jet_clause(outcome), deed_of_other(outcome),
                     pieces_clause(outcome));
}

}  // namespace kerf
