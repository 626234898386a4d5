// SPDX-License-Identifier: Apache-2.0
// The result of a run in which the first of several jets met nothing: what is cut is the work of
// the others.
#include <fmt/format.h>

#include <cmath>
#include <utility>

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
  const auto number = static_cast<std::size_t>(cut.cut_jet);
  const std::string other = jets_of_whole(outcome.description) <= 2 ? "the other one"
                            : number > 0 ? outcome.description.jets.at(number).name
                                         : "another of them";
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

bool is_cut_beside_first(const RunOutcome& outcome) {
  const CutSummary& cut = outcome.cut;
  return is_of_other_jet(outcome) && cut.cut_through && cut.cut_jet != 0 &&
         cut.first_touch_time <= cut.cut_through_time;
}

RunOutcome as_of_cutting_jet(const RunOutcome& outcome) {
  RunOutcome seen = outcome;
  auto& jets = seen.description.jets;
  std::swap(jets.front(), jets.at(static_cast<std::size_t>(seen.cut.cut_jet)));
  if (seen.kerf_of_cut) seen.kerf = seen.kerf_of_cut;
  seen.cut.is_of_other_jet = false;
  return seen;
}

std::string other_jet_sentence(const RunOutcome& outcome) {
  return fmt::format("{}; {}{}.", first_jet_clause(outcome), deed_of_other(outcome),
                     pieces_clause(outcome));
}

}  // namespace kerf
