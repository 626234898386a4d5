// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "machine/simulated_piece.hpp"
#include "model/case.hpp"
#include "output/exposure_sentence.hpp"
#include "output/layer_metrics.hpp"
#include "output/readable.hpp"
#include "output/result.hpp"
#include "output/verdict_parts.hpp"

namespace kerf {
namespace {

// Whether the jet has pushed a body out of the domain.
bool has_left(const RunOutcome& outcome) {
  const auto& bodies = outcome.cut.bodies;
  return std::any_of(bodies.begin(), bodies.end(),
                     [](const BodyVerdict& body) { return body.cut.left; });
}

// Returns the thickness of a layer of the finest particles, m; 0 without bodies.
double least_layer(const RunOutcome& outcome) {
  return outcome.description.bodies.empty() ? 0.0 : finest_spacing(outcome);
}

// Names the layers that are unbroken in part, where the jet has cut through others.
std::string unbroken_names(const RunOutcome& outcome) {
  std::vector<std::string> names;
  bool has_cut = false;
  for (const NamedLayer& layer : named_layers(*outcome.kerf, outcome.description)) {
    has_cut = has_cut || layer.layer.verdict.cut.through;
    if (layer.layer.verdict.is_in_way && layer.layer.unbroken > 0.0) names.push_back(layer.name);
  }
  return names.empty() || !has_cut ? "" : " of " + join_names(names);
}

// Whether the cut in one body, or in a stack whose bodies fill the way of the jet, reaches solid
// that is whole on all lines along the jet: its path leads past it.
bool is_inclined(const RunOutcome& outcome) {
  if (!outcome.kerf) return false;
  for (const NamedLayer& layer : named_layers(*outcome.kerf, outcome.description))
    if (layer.layer.verdict.is_in_way && !fills_the_way(layer, outcome)) return false;
  const CutMargin& margin = outcome.kerf->of<CutMargin>();
  if (!(margin.value < 0.0 && margin.unbroken > least_length(outcome) &&
        margin.unbroken >= least_layer(outcome)))
    return false;
  // That from face to face has the voids, which the cut passes, and the solid does not.
  const double thickness = std::max(-margin.unbroken / margin.value, outcome.kerf->shape.thickness);
  return outcome.cut.last.cut_depth + margin.unbroken > thickness + finest_spacing(outcome);
}

// Returns the thickness that the jet has left, where it has broken a part.
std::string unbroken_clause(const RunOutcome& outcome) {
  if (!outcome.kerf) return "";
  const double unbroken = outcome.kerf->of<CutMargin>().unbroken, spacing = least_layer(outcome);
  if (unbroken > least_length(outcome) && unbroken < spacing)
    return fmt::format(
        ", and less than {} of the thickness{}, a spacing of the particles, is unbroken",
        readable(spacing, "m"), unbroken_names(outcome));
  if (unbroken > least_length(outcome))
    return fmt::format(", and {} of the thickness{} is unbroken{}", readable(unbroken, "m"),
                       unbroken_names(outcome),
                       is_inclined(outcome) ? " on each line along the jet" : "");
  return has_left(outcome)
             ? ""
             : ", and none of the thickness is unbroken: torn solid that still stands "
               "in the way of the water joins the sides";
}

// Whether the front has come to the end of a part that ends within the workpiece.
bool is_at_end_of_part(const RunOutcome& outcome) {
  return outcome.cut.last.front_depth >= last_front_depth(outcome.description);
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
      join_names(names));
}

// Says how deep the cut and the water in it are, or how deep the dent.
std::string reach_clause(const RunOutcome& outcome) {
  const std::string front = readable(outcome.cut.last.front_depth, "m");
  if (is_inclined(outcome))
    return fmt::format("cracks reach {} deep along an inclined path and its front {}",
                       readable(outcome.cut.last.cut_depth, "m"), front);
  if (!cuts_nothing(outcome))
    return fmt::format("the cut is {}{} and its front {} deep",
                       readable(outcome.cut.last.cut_depth, "m"), beside_clause(outcome), front);
  if (has_left(outcome)) return fmt::format("its front is {} deep", front);
  const std::string broken = "what has broken opens no path from the face";
  const std::string dent = dent_clause(outcome);
  return dent.empty() ? broken : dent + "; " + broken;
}

// Says how far a workpiece that is cut has moved, if by more than the width of the jet: the cut is
// elsewhere in it than where the jet aimed at first.
std::string shift_clause(const RunOutcome& outcome) {
  if (cuts_nothing(outcome) || has_left(outcome)) return "";
  const std::string motion = motion_clause_beyond(outcome, outcome.description.jets.front().width);
  return motion.empty() ? "" : "; " + motion;
}

// Says what several jets have broken together, because the verdict is on the first.
std::string other_jets_sentence(const RunOutcome& outcome) {
  const std::size_t jets = jets_of_whole(outcome.description);
  if (jets < 2 || breaks_nothing(outcome)) return "";
  return fmt::format(
      " The {} jets together have broken {:.2g}% of the workpiece; which of them "
      "broke what is not told.",
      jets, 100.0 * outcome.cut.broken_fraction());
}

// Says that the state at the end is none of rest.
std::string tearing_clause(const RunOutcome& outcome) {
  return outcome.still_cutting ? "; the run ended while solid still tore or the front went deeper"
                               : "";
}

std::string depth_sentence(const RunOutcome& outcome) {
  if (breaks_nothing(outcome) && !has_left(outcome)) return dent_sentence(outcome);
  const std::string end = readable(outcome.time, "s");
  if (is_at_end_of_part(outcome))
    return fmt::format(
        "The front of the jet has come to the end of the depth that is simulated, {}, after {}{}.",
        readable(outcome.description.workpiece->depth, "m"), end, layers_clause(outcome));
  const bool is_dent = cuts_nothing(outcome) && !has_left(outcome);
  return fmt::format("{} {} within {}{}; {}{}{}.", the_jet(outcome),
                     is_dent ? "cuts nothing" : "does not cut through", end, layers_clause(outcome),
                     reach_clause(outcome), unbroken_clause(outcome),
                     left_clause(outcome) + shift_clause(outcome) + pieces_clause(outcome) +
                         tearing_clause(outcome));
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

// Says what is lost above and along a crack. A flap at the face that stands in the way of the jet
// ends the kerf, whatever is gone below it; a depth of less than a spacing is none.
std::string loss_clause(const RunOutcome& outcome) {
  const double depth = outcome.kerf->shape.depth;
  const Removal& removal = outcome.kerf->of<Removal>();
  const bool is_cut = depth > 0.0;
  if (!removal.loses_below())
    return is_cut ? fmt::format(" below a cut of {}", readable(depth, "m"))
                  : " without loss of material in its way";
  const std::string loss =
      fmt::format(" and by loss of {:.0f}% of the material", 100.0 * removal.share_below);
  return is_cut && depth >= finest_spacing(outcome)
             ? fmt::format(" below a cut of {}{} below that", readable(depth, "m"), loss)
             : loss + " in the way of " + the_jet(outcome, false);
}

// Says what the jet does, and how where it removes no material down to the far face or a crack runs
// ahead of its water.
std::string deed(const RunOutcome& outcome) {
  const bool removed =
      !outcome.kerf || outcome.kerf->shape.through || outcome.kerf->shape.through_share > 0.0;
  if (outcome.cut.punched && !removed)
    return fmt::format("{} punches out a plug after {}{}", the_jet(outcome),
                       readable(outcome.cut.cut_through_time, "s"),
                       outcome.cut.cracked_ahead() ? water_clause(outcome) : way_clause(outcome));
  if (removed && outcome.cut.cracked_ahead()) return crack_clause(outcome) + water_clause(outcome);
  if (removed)
    return fmt::format("{} cuts through after {}{}", the_jet(outcome),
                       readable(outcome.cut.cut_through_time, "s"), way_clause(outcome));
  if (outcome.kerf->of<CutMargin>().is_whole)
    return fmt::format("{} beside the way of {}, where it is whole", crack_clause(outcome),
                       the_jet(outcome, false));
  return crack_clause(outcome) + loss_clause(outcome);
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
  const std::string before =
      cut.initial_pieces > 1 ? fmt::format(", of {} at the start", cut.initial_pieces) : "";
  return fmt::format("{}; at the end the workpiece is in {} {}{}.", start, pieces,
                     pieces == 1 ? "piece" : "pieces", before);
}

// Whether solid in the way has torn between two states: what is torn is a sum over the same
// particles, which where nothing breaks differs by rounding at most.
bool has_torn(const CutState& before, const CutState& after) {
  constexpr double more = 1.0 + 1e-9;
  for (std::size_t n = 0; n < after.bodies.size() && n < before.bodies.size(); ++n)
    if (after.bodies[n].torn > more * before.bodies[n].torn) return true;
  return false;
}

}  // namespace

bool breaks_nothing(const RunOutcome& outcome) {
  const bool is_changed = outcome.has_broken_bonds && outcome.balance.dissipated_fracture != 0.0;
  // What stood until it left the domain counts as fractured.
  constexpr double rounding = 1e-9;
  const double fractured = outcome.cut.last.fractured_mass;
  return fractured - outcome.cut.mass_left_whole <= rounding * fractured && !is_changed;
}

bool cuts_nothing(const RunOutcome& outcome) {
  return outcome.cut.last.cut_depth == 0.0 && !outcome.cut.cut_through;
}

bool still_cutting(const std::vector<CutState>& history) {
  if (history.empty() || history.back().cut_through) return false;
  const double late = history.front().time + 0.9 * (history.back().time - history.front().time);
  const auto before = std::find_if(history.begin(), history.end(),
                                   [late](const CutState& state) { return state.time >= late; });
  const bool goes_deeper = history.back().front_depth > before->front_depth;
  return has_torn(*before, history.back()) || (history.back().cut_depth > 0.0 && goes_deeper);
}

std::string still_cutting_sentence(const RunOutcome& outcome) {
  return is_at_end_of_part(outcome)
             ? "The run ended as the front came to the end of the depth that is simulated: a "
               "greater depth of the [workpiece] tells more."
             : "The run ended while the jet was still cutting: in its last tenth solid in the way "
               "tore, or the front of a cut went deeper. Set a later `end` in [time] of the case "
               "and continue the run with --resume.";
}

std::string verdict_of(const RunOutcome& outcome) {
  if (outcome.description.jets.empty()) return jetless_sentence(outcome);
  if (aims_at_nothing(outcome)) return aimless_sentence(outcome);
  if (!has_touched(outcome)) return untouched_sentence(outcome);
  if (is_cut_beside_first(outcome))
    return cut_sentence(as_of_cutting_jet(outcome)) + other_jets_sentence(outcome);
  if (is_of_other_jet(outcome)) return other_jet_sentence(outcome);
  return (outcome.cut.cut_through ? cut_sentence(outcome) : depth_sentence(outcome)) +
         other_jets_sentence(outcome) + exposure_sentence(outcome) + stationary_sentence(outcome);
}

}  // namespace kerf
