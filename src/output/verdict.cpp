// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "machine/simulated_piece.hpp"
#include "model/case.hpp"
#include "output/exposure_sentence.hpp"
#include "output/layer_metrics.hpp"
#include "output/readable.hpp"
#include "output/result.hpp"

namespace kerf {
namespace {

std::string join(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t n = 0; n < names.size(); ++n)
    text += (n == 0 ? "" : n + 1 == names.size() ? " and " : ", ") + names[n];
  return text;
}

// Names the bodies in the way of the jet by their fate: "liver is cut through, vessel is whole";
// empty where there is one body.
std::string layers_clause(const RunOutcome& outcome) {
  if (!outcome.kerf) return "";
  std::vector<std::pair<std::string, std::vector<std::string>>> by_fate;
  std::size_t count = 0;
  for (const NamedLayer& layer : named_layers(*outcome.kerf, outcome.description)) {
    if (!layer.layer.verdict.is_in_way) continue;
    ++count;
    const std::string fate = fate_of(layer.layer);
    const auto known = std::find_if(by_fate.begin(), by_fate.end(),
                                    [&](const auto& entry) { return entry.first == fate; });
    if (known == by_fate.end())
      by_fate.push_back({fate, {layer.name}});
    else
      known->second.push_back(layer.name);
  }
  std::string text;
  if (count < 2) return text;
  for (const auto& [fate, names] : by_fate)
    text += fmt::format("{}{} {} {}", text.empty() ? "; " : ", ", join(names),
                        names.size() == 1 ? "is" : "are", fate);
  return text;
}

// Returns the least length that means anything beside the spacing of the particles, m.
double least_length(const RunOutcome& outcome) {
  constexpr double least = 1e-3;  // of the finest spacing
  double finest = std::numeric_limits<double>::infinity();
  for (const Body& body : outcome.description.bodies) finest = std::min(finest, body.spacing);
  return std::isfinite(finest) ? least * finest : 0.0;
}

// The verdict is on the first jet (docs/metrics.md).
std::string the_jet(const RunOutcome& outcome) {
  const std::size_t jets = outcome.description.jets.size();
  return jets > 1 ? fmt::format("The first of {} jets", jets) : std::string("The jet");
}

// Returns when the first water can reach the point at which the jet aims, s.
double arrival_time(const Jet& jet) {
  return jet.start + jet.standoff / jet.speed;
}

// Whether the jet has pushed a body out of the domain.
bool has_left(const RunOutcome& outcome) {
  const auto& bodies = outcome.cut.bodies;
  return std::any_of(bodies.begin(), bodies.end(),
                     [](const BodyVerdict& body) { return body.cut.left; });
}

// Returns the thickness that the jet has left, where it has broken a part.
std::string unbroken_clause(const RunOutcome& outcome) {
  if (!outcome.kerf) return "";
  const double unbroken = outcome.kerf->of<CutMargin>().unbroken;
  if (unbroken > least_length(outcome))
    return fmt::format(", and {} of the thickness is unbroken", readable(unbroken, "m"));
  return has_left(outcome) ? "" : ", and none of the thickness is unbroken";
}

// Whether the front has come to the end of a part that ends within the workpiece.
bool is_at_end_of_part(const RunOutcome& outcome) {
  return outcome.cut.last.front_depth >= last_front_depth(outcome.description);
}

// Whether the front has moved by more than the positions of particles are known.
bool is_measurable(const RunOutcome& outcome) {
  const double depth = outcome.cut.last.front_depth;
  return depth > 0.0 && !(depth < least_length(outcome));
}

std::string dent_sentence(const RunOutcome& outcome) {
  const std::string end = readable(outcome.time, "s");
  const Jet& jet = outcome.description.jets.front();
  if (outcome.cut.last.front_depth == 0.0 && !(arrival_time(jet) < outcome.time))
    return fmt::format("No water has come to the workpiece within {}: it would come after {}.", end,
                       readable(arrival_time(jet), "s"));
  if (!is_measurable(outcome))
    return fmt::format("{} breaks nothing within {} and makes no measurable dent.",
                       the_jet(outcome), end);
  return fmt::format("{} breaks nothing within {}; its front presses {} into the workpiece.",
                     the_jet(outcome), end, readable(outcome.cut.last.front_depth, "m"));
}

// Names the bodies that the jet has pushed out of the domain.
std::string left_clause(const RunOutcome& outcome) {
  std::vector<std::string> names;
  for (const BodyVerdict& verdict : outcome.cut.bodies)
    if (verdict.cut.left)
      names.push_back(outcome.description.bodies.at(std::size_t(verdict.body)).name);
  if (names.empty()) return "";
  return fmt::format(
      "; it has pushed {} out of the domain unbroken, where nothing is known of it: a larger "
      "[domain] would tell",
      join(names));
}

// Says how deep the cut and the water in it are, or that the water is in a dent.
std::string reach_clause(const RunOutcome& outcome) {
  const std::string front = readable(outcome.cut.last.front_depth, "m");
  if (!cuts_nothing(outcome))
    return fmt::format("the cut is {} and its front {} deep",
                       readable(outcome.cut.last.cut_depth, "m"), front);
  if (has_left(outcome)) return fmt::format("its front is {} deep", front);
  const std::string broken = "what has broken opens no path from the face";
  return is_measurable(outcome)
             ? fmt::format("its front presses a dent of {} into the workpiece; {}", front, broken)
             : broken;
}

std::string depth_sentence(const RunOutcome& outcome) {
  if (outcome.kerf && outcome.kerf->shape.thickness == 0.0 && outcome.kerf->layers.empty())
    return "The jet aims at no body that it could cut.";
  if (breaks_nothing(outcome)) return dent_sentence(outcome);
  const std::string end = readable(outcome.time, "s");
  if (is_at_end_of_part(outcome))
    return fmt::format(
        "The front of the jet has come to the end of the depth that is simulated, {}, after {}{}.",
        readable(outcome.description.workpiece->depth, "m"), end, layers_clause(outcome));
  const bool is_dent = cuts_nothing(outcome) && !has_left(outcome);
  return fmt::format("{} {} within {}{}; {}{}{}.", the_jet(outcome),
                     is_dent ? "cuts nothing" : "does not cut through", end, layers_clause(outcome),
                     reach_clause(outcome), unbroken_clause(outcome), left_clause(outcome));
}

// With a moving nozzle one hole is not a cut, so the cut share of its path is stated, and the open
// one where material has given way that is not removed.
std::string way_clause(const RunOutcome& outcome) {
  const auto& travel = outcome.description.jets.front().traverse;
  if (travel == std::array<double, 3>{} || !outcome.kerf) return "";
  const double removed = 100.0 * outcome.kerf->shape.through_share;
  const double open = 100.0 * outcome.kerf->opening.through_share;
  std::string text = fmt::format(", and all the way down on {:.0f}% of its way so far", removed);
  if (open > removed + 5.0) text += fmt::format(" ({:.0f}% is open, as it lies at the end)", open);
  return text;
}

// Says when and how a crack parts or pierces the workpiece.
std::string crack_clause(const RunOutcome& outcome) {
  return fmt::format("The workpiece is {} after {} by a crack",
                     outcome.cut.severed ? "parted" : "pierced",
                     readable(outcome.cut.cut_through_time, "s"));
}

// Says what becomes of the water, of which a crack was ahead.
std::string water_clause(const RunOutcome& outcome) {
  if (!std::isnan(outcome.cut.water_through_time))
    return fmt::format(" ahead of the water, which is through after {}{}",
                       readable(outcome.cut.water_through_time, "s"), way_clause(outcome));
  return fmt::format(" ahead of the water, which is {} deep at the end{}",
                     readable(outcome.cut.last.front_depth, "m"), way_clause(outcome));
}

// Says what the jet does, and how where it removes no material down to the far face or a crack runs
// ahead of its water.
std::string deed(const RunOutcome& outcome) {
  const bool removed =
      !outcome.kerf || outcome.kerf->shape.through || outcome.kerf->shape.through_share > 0.0;
  if (removed && outcome.cut.cracked_ahead()) return crack_clause(outcome) + water_clause(outcome);
  if (removed)
    return fmt::format("{} cuts through after {}{}", the_jet(outcome),
                       readable(outcome.cut.cut_through_time, "s"), way_clause(outcome));
  const double depth = outcome.kerf->shape.depth;
  return crack_clause(outcome) + (depth > 0.0
                                      ? fmt::format(" below a cut of {}", readable(depth, "m"))
                                      : std::string(" without loss of material in its way"));
}

std::string cut_sentence(const RunOutcome& outcome) {
  const CutSummary& cut = outcome.cut;
  const std::string start = deed(outcome) + layers_clause(outcome);
  const int pieces = cut.last.pieces;
  if (pieces == 0)
    return start +
           "; at the end no piece of the workpiece that is larger than 5% of it is in the domain: "
           "what was larger has broken up or left it.";
  if (pieces == 1 && cut.severed)
    return start + "; at the end one piece of the workpiece is larger than 5% of it.";
  return fmt::format("{}; at the end the workpiece is in {} {}.", start, pieces,
                     pieces == 1 ? "piece" : "pieces");
}

// Says whether the cut under a nozzle with which a frame travels is the same all along its path.
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

}  // namespace

bool breaks_nothing(const RunOutcome& outcome) {
  return outcome.cut.last.fractured_mass == 0.0 && outcome.balance.dissipated_fracture == 0.0;
}

bool cuts_nothing(const RunOutcome& outcome) {
  return outcome.cut.last.cut_depth == 0.0 && !outcome.cut.cut_through;
}

bool still_cutting(const std::vector<CutState>& history) {
  if (history.empty() || history.back().cut_through || history.back().cut_depth == 0.0)
    return false;
  const double late = history.front().time + 0.9 * (history.back().time - history.front().time);
  const auto before = std::find_if(history.begin(), history.end(),
                                   [late](const CutState& state) { return state.time >= late; });
  return history.back().front_depth > before->front_depth;
}

std::string still_cutting_sentence(const RunOutcome& outcome) {
  return is_at_end_of_part(outcome)
             ? "The run ended as the front came to the end of the depth that is simulated: a "
               "greater depth of the [workpiece] tells more."
             : "The run ended while the jet was still cutting: set a later `end` in [time] of the "
               "case and "
               "continue the run with --resume.";
}

std::string verdict_of(const RunOutcome& outcome) {
  if (outcome.description.jets.empty())
    return fmt::format("The run reached {}; it has no jet, so there is nothing to cut.",
                       readable(outcome.time, "s"));
  return (outcome.cut.cut_through ? cut_sentence(outcome) : depth_sentence(outcome)) +
         exposure_sentence(outcome) + stationary_sentence(outcome);
}

}  // namespace kerf
