// SPDX-License-Identifier: Apache-2.0
#include "output/exposure_sentence.hpp"

#include <fmt/format.h>

#include <cmath>

#include "machine/simulated_piece.hpp"
#include "model/case.hpp"
#include "output/readable.hpp"
#include "output/result.hpp"

namespace kerf {
namespace {

std::string decades_clause(const Exposure& exposure) {
  return exposure.decades() > 0.0
             ? fmt::format(", carried over {:.1f} decades of time,", exposure.decades())
             : std::string();
}

// Of a cut that holds of a nozzle at rest only (CutSummary::holds_at_rest_only).
std::string uncertain_sentence(const RunOutcome& outcome, const std::string& feed) {
  const Exposure& exposure = *outcome.exposure;
  const std::string reason = outcome.cut.cracked_ahead()
                                 ? "A moving nozzle leaves the crack of its first impact behind"
                                 : "What gives way evades a moving nozzle";
  const std::string possible =
      std::isnan(exposure.possible_feed)
          ? "the run shows none that is possible"
          : fmt::format("the cut is possible up to {}", readable(exposure.possible_feed, "m/s"));
  return fmt::format(
      " {}, so no feed is certain: one of {}{} {}; {}.", reason, feed, decades_clause(exposure),
      exposure.may_cut() ? "may cut through" : "is not shown to cut through", possible);
}

// Of water that has come through a cut.
std::string passage_sentence(const Exposure& exposure, const std::string& feed,
                             const char* verdict) {
  return fmt::format(
      " A feed of {}, which exposes each point for {} or more, {}; the cut is certain up to {} and "
      "possible up to {}.",
      feed, readable(exposure.shortest, "s"), verdict, readable(exposure.greatest_feed, "m/s"),
      readable(exposure.possible_feed, "m/s"));
}

// Of a run that ends before its water is through.
std::string carried_sentence(const RunOutcome& outcome, const std::string& feed,
                             const char* verdict) {
  const Exposure& exposure = *outcome.exposure;
  const std::string interval =
      exposure.cuts() ? fmt::format("; by the same law it would up to {} at least and {} at most",
                                    readable(exposure.greatest_feed, "m/s"),
                                    readable(exposure.possible_feed, "m/s"))
      : outcome.cut.cut_through
          ? std::string(
                ": the run ended before its water was through the cut, which a later end "
                "shows")
          : fmt::format(": the cut is {} to {} deep", readable(exposure.depth_low, "m"),
                        readable(exposure.depth_high, "m"));
  return fmt::format(" A feed of {} exposes each point for {} to {}{} and {}{}.", feed,
                     readable(exposure.shortest, "s"), readable(exposure.longest, "s"),
                     decades_clause(exposure), verdict, interval);
}

// Of a run that tells no depth at the feed.
std::string untold_sentence(const RunOutcome& outcome, const std::string& feed) {
  const Exposure& exposure = *outcome.exposure;
  if (!outcome.cut.cut_through && outcome.cut.last.front_depth >= exposure.thickness)
    return fmt::format(
        " The front is below a workpiece that is not cut through yet: this says nothing about a "
        "feed of {}; a later end may show the cut.",
        feed);
  if (std::isnan(exposure.depth_low))
    return fmt::format(" No law of the depth shows that could be carried to a feed of {}.", feed);
  return fmt::format(
      " The front rests at the end of the run, which shows {} of the {} or more for which a feed "
      "of "
      "{} exposes each point: this says no more of that feed than a depth of {} at least; a later "
      "end tells whether the front moves on.",
      readable(exposure.simulated, "s"), readable(exposure.longest, "s"), feed,
      readable(exposure.depth_low, "m"));
}

std::string sentence_of(const RunOutcome& outcome, const std::string& feed) {
  const Exposure& exposure = *outcome.exposure;
  if (std::isnan(exposure.depth_high)) return untold_sentence(outcome, feed);
  if (exposure.is_uncertain) return uncertain_sentence(outcome, feed);
  const char* verdict = exposure.cuts()      ? "cuts through"
                        : exposure.may_cut() ? "may cut through"
                                             : "does not cut through";
  const bool is_carried = !outcome.cut.cut_through || !std::isnan(exposure.exponent);
  return is_carried ? carried_sentence(outcome, feed, verdict)
                    : passage_sentence(exposure, feed, verdict);
}

// Of a jet in drops, whose pauses the run counts as water.
std::string pauses_sentence(const Exposure& exposure) {
  if (!exposure.has_pauses || std::isnan(exposure.depth_high)) return "";
  return fmt::format(
      " The jet has broken up into drops, whose pauses leave gaps on the path of a nozzle that is "
      "faster than {}: no such feed is certain.",
      readable(exposure.pausing_feed, "m/s"));
}

// Of a nozzle that is said to stand where it would move by more than its jet on the way of the
// water: the interval of the depths leaves out what a front gains on its way.
std::string motion_sentence(const RunOutcome& outcome) {
  const Case& description = outcome.description;
  const Machine& machine = *description.machine;
  const Jet& jet = description.jets.back();
  const double thickness = description.workpiece->size[1];
  if (outcome.exposure->cuts() || std::isnan(outcome.exposure->depth_high) ||
      may_stand(machine, jet, thickness, description.dimension))
    return "";
  return fmt::format(
      " At this feed the nozzle moves by {:.2g} widths of its jet while that could pass the "
      "workpiece: the cut may be deeper than this; motion = \"travelling\" simulates it.",
      passage_time(jet, thickness) / exposure_time(machine, jet, description.dimension));
}

}  // namespace

std::string exposure_sentence(const RunOutcome& outcome) {
  const Case& description = outcome.description;
  if (!stands_for_traverse(description)) return "";
  const Machine& machine = *description.machine;
  const std::string feed = readable(machine.traverse_speed, "m/s");
  if (cuts_nothing(outcome))
    return fmt::format(
        " A feed of {} exposes each point for {} or more; a dent is not carried on to that.", feed,
        readable(exposure_time(machine, description.jets.back(), description.dimension), "s"));
  if (machine.is_pulsed())
    return fmt::format(
        " The pauses of a pulsed jet leave gaps along its path, which a nozzle that stands does "
        "not "
        "show: this says nothing about a feed of {}; motion = \"travelling\" simulates it.",
        feed);
  if (outcome.exposure)
    return sentence_of(outcome, feed) + pauses_sentence(*outcome.exposure) +
           motion_sentence(outcome);
  return outcome.cut.cut_through
             ? fmt::format(" No water has entered the crack: this says nothing about a feed of {}.",
                           feed)
             : "";
}

}  // namespace kerf
