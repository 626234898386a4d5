// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>

#include "machine/simulated_piece.hpp"
#include "model/case.hpp"
#include "output/readable.hpp"
#include "output/result.hpp"
#include "output/verdict_parts.hpp"

namespace kerf {

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
  if (!outcome.exposure) return "";
  const Exposure& exposure = *outcome.exposure;
  const char* verdict = exposure.cuts()      ? "cuts through"
                        : exposure.may_cut() ? "may cut through"
                                             : "does not cut through";
  if (std::isnan(exposure.depth))
    return fmt::format(" No law of the depth shows that could be carried to a feed of {}.", feed);
  if (outcome.cut.cut_through)
    return fmt::format(
        " A feed of {}, which exposes each point for {} or more, {}; the cut is certain up to {} "
        "and possible up to {}.",
        feed, readable(exposure.shortest, "s"), verdict, readable(exposure.greatest_feed, "m/s"),
        readable(exposure.possible_feed, "m/s"));
  const std::string carried =
      exposure.decades() > 0.0
          ? fmt::format(", carried over {:.1f} decades of time,", exposure.decades())
          : std::string();
  const std::string interval =
      exposure.cuts() ? fmt::format("; by the same law it would up to {} at least and {} at most",
                                    readable(exposure.greatest_feed, "m/s"),
                                    readable(exposure.possible_feed, "m/s"))
                      : fmt::format(": the cut is {} to {} deep", readable(exposure.depth_low, "m"),
                                    readable(exposure.depth_high, "m"));
  return fmt::format(" A feed of {} exposes each point for {} to {}{} and {}{}.", feed,
                     readable(exposure.shortest, "s"), readable(exposure.longest, "s"), carried,
                     verdict, interval);
}

std::string stationary_sentence(const RunOutcome& outcome) {
  if (!outcome.stationary) return "";
  const StationaryCut& cut = *outcome.stationary;
  const std::string travelled = readable(cut.travelled, "m");
  if (cut.reached)
    return fmt::format(
        " The cut is stationary after {} of travel: {} deep, and its front lags by {}.", travelled,
        readable(cut.depth, "m"), readable(cut.lag, "m"));
  if (std::isnan(cut.change))
    return fmt::format(" The cut did not become stationary within {} of travel.", travelled);
  return fmt::format(
      " The cut did not become stationary within {} of travel: over the last {:g} jet widths it "
      "changed by {:.1f}%.",
      travelled, stretch_widths, 100.0 * cut.change);
}

}  // namespace kerf
