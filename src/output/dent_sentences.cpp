// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "model/case.hpp"
#include "output/readable.hpp"
#include "output/result.hpp"
#include "output/verdict_parts.hpp"

namespace kerf {
namespace {

// Returns when the first water can reach the point at which the jet aims, s.
double arrival_time(const Jet& jet) {
  return jet.start + jet.standoff / jet.speed;
}

double magnitude(const std::array<double, 3>& vector) {
  return std::hypot(vector[0], vector[1], vector[2]);
}

double dent_of(const RunOutcome& outcome) {
  return outcome.kerf ? outcome.kerf->of<Dent>().depth : 0.0;
}

// Says how far the workpiece has moved, if that is measurable and more than the dent.
std::string motion_clause(const RunOutcome& outcome) {
  return motion_clause_beyond(outcome, std::max(dent_of(outcome), least_length(outcome)));
}

// Names the bodies that have left the domain.
std::string gone_clause(const RunOutcome& outcome) {
  std::string text;
  for (const BodyVerdict& verdict : outcome.cut.bodies)
    if (verdict.cut.left)
      text += fmt::format("; {} has left the domain",
                          outcome.description.bodies.at(std::size_t(verdict.body)).name);
  return text;
}

// Whether a solid that is neither rigid nor of the workpiece can have taken an impulse of the
// water, such as a body that is fixed.
bool has_other_solids(const RunOutcome& outcome) {
  const auto& bodies = outcome.description.bodies;
  return std::any_of(bodies.begin(), bodies.end(),
                     [](const Body& body) { return body.role == Role::elastic && body.fixed; });
}

// Whether solid has broken before the water came. Solid that leaves the domain whole takes bonds
// with it, and what stays of it beside the edge may come off: where that is most, nothing is known.
bool breaks_without_water(const RunOutcome& outcome) {
  if (breaks_nothing(outcome)) return false;
  const double left = outcome.cut.mass_left_whole;
  return left == 0.0 || outcome.cut.last.fractured_mass - left > left;
}

}  // namespace

std::string motion_clause_beyond(const RunOutcome& outcome, double least) {
  const Dent dent = outcome.kerf ? outcome.kerf->of<Dent>() : Dent{};
  if (!(dent.motion > least)) return "";
  constexpr double mostly = 0.87;  // within 30 degrees of the plane across the jet
  const bool is_sideways = dent.aside > mostly * dent.motion;
  return fmt::format("the workpiece has {} by {}", is_sideways ? "moved sideways" : "bent or moved",
                     readable(dent.motion, "m"));
}

std::string the_jet(const RunOutcome& outcome, bool begins_sentence) {
  const std::size_t jets = jets_of_whole(outcome.description);
  const char* article = begins_sentence ? "The" : "the";
  if (jets < 2) return fmt::format("{} jet", article);
  const CutSummary& cut = outcome.cut;
  if (cut.cut_jet == 0 || cut.is_of_other_jet)
    return fmt::format("{} first of {} jets", article, jets);
  constexpr std::array<const char*, 6> ordinals{"first",  "second", "third",
                                                "fourth", "fifth",  "sixth"};
  const auto number = static_cast<std::size_t>(cut.cut_jet);
  const std::string which =
      number < ordinals.size() ? ordinals[number] : fmt::format("{}th", number + 1);
  return fmt::format("{} {} of {} jets ({})", article, which, jets,
                     outcome.description.jets.front().name);
}

double finest_spacing(const RunOutcome& outcome) {
  double finest = std::numeric_limits<double>::infinity();
  for (const Body& body : outcome.description.bodies) finest = std::min(finest, body.spacing);
  return finest;
}

double least_length(const RunOutcome& outcome) {
  constexpr double least = 1e-3;  // of the finest spacing
  const double finest = finest_spacing(outcome);
  return std::isfinite(finest) ? least * finest : 0.0;
}

bool has_workpiece(const Case& description) {
  return std::any_of(description.bodies.begin(), description.bodies.end(),
                     [](const Body& body) { return body.role == Role::elastic; });
}

bool has_touched(const RunOutcome& outcome) {
  if (!outcome.cut.bodies.empty() && has_other_solids(outcome) && !outcome.cut.last.is_touched)
    return false;
  // The impulse is the sum of the forces on the water, of which those within the water cancel but
  // for rounding: that of the momenta by magnitude, as those of opposed jets cancel, too.
  constexpr double rounding = 1e-6;
  double fastest = 0.0;
  for (const Jet& jet : outcome.description.jets) fastest = std::max(fastest, jet.speed);
  const double scale = std::max({outcome.balance.mass_in * fastest, outcome.balance.momentum_scale,
                                 magnitude(outcome.balance.momentum_in)});
  return magnitude(outcome.balance.impulse_water) > rounding * scale;
}

std::string untouched_sentence(const RunOutcome& outcome) {
  const std::string end = readable(outcome.time, "s");
  double arrival = std::numeric_limits<double>::infinity();
  for (const Jet& jet : outcome.description.jets) arrival = std::min(arrival, arrival_time(jet));
  std::string text =
      arrival < outcome.time
          ? fmt::format("The water has not touched the workpiece within {}", end)
          : fmt::format("No water has come to the workpiece within {}: it would come after {}", end,
                        readable(arrival, "s"));
  if (breaks_without_water(outcome)) text += "; solid has broken without it";
  const std::string motion = motion_clause(outcome);
  if (!motion.empty()) text += "; " + motion;
  return text + pieces_clause(outcome) + gone_clause(outcome) + ".";
}

bool makes_dent(const RunOutcome& outcome) {
  return dent_of(outcome) > least_length(outcome);
}

std::string dent_clause(const RunOutcome& outcome) {
  const std::string motion = motion_clause(outcome);
  if (!makes_dent(outcome)) return motion;
  const std::string dent =
      fmt::format("it presses a dent of {} into the workpiece", readable(dent_of(outcome), "m"));
  return motion.empty() ? dent : dent + "; " + motion;
}

std::string pieces_clause(const RunOutcome& outcome) {
  const int before = std::max(outcome.cut.initial_pieces, 1), now = outcome.cut.last.pieces;
  if (now <= before) return "";
  return fmt::format("; the workpiece is in {} pieces{}", now,
                     before > 1 ? fmt::format(", of {} at the start", before) : "");
}

std::string dent_sentence(const RunOutcome& outcome) {
  const std::string start =
      fmt::format("{} breaks nothing within {}{}", the_jet(outcome), readable(outcome.time, "s"),
                  makes_dent(outcome) ? "" : " and makes no measurable dent");
  const std::string dent = dent_clause(outcome);
  // What leaves the domain takes bonds with it, whose energy is told from softening by nothing.
  const double left = outcome.cut.mass_left_whole;
  const bool softens = outcome.balance.dissipated_fracture != 0.0 && left == 0.0;
  return start + (dent.empty() ? "" : "; ") + dent +
         (softens ? "; the solid has begun to soften" : "") +
         (left > 0.0 ? fmt::format("; {:.2g}% of the workpiece has left the domain unbroken",
                                   100.0 * outcome.cut.left_fraction())
                     : "") +
         ".";
}

}  // namespace kerf
