// SPDX-License-Identifier: Apache-2.0
// The result of a run in which no jet aims at a body that it could cut.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geometry/water_line.hpp"
#include "model/case.hpp"
#include "output/readable.hpp"
#include "output/result.hpp"
#include "output/verdict_parts.hpp"

namespace kerf {
namespace {

// Names the bodies in the way of the first jet that are fixed, which no jet can cut.
std::vector<std::string> fixed_in_way(const Case& description) {
  const Jet& jet = description.jets.front();
  std::vector<WaterLine> lines = lines_at_edge(jet, description.dimension);
  lines.push_back(axis_line(jet));
  std::vector<std::string> names;
  for (const Body& body : description.bodies) {
    if (body.role != Role::elastic || !body.fixed) continue;
    if (std::any_of(lines.begin(), lines.end(), [&](const WaterLine& line) {
          return std::isfinite(way_into(body, line, description.dimension));
        }))
      names.push_back(body.name);
  }
  return names;
}

}  // namespace

bool aims_at_nothing(const RunOutcome& outcome) {
  return outcome.kerf && outcome.kerf->shape.thickness == 0.0 && outcome.kerf->layers.empty() &&
         !outcome.cut.cut_through;
}

bool has_broken(const RunOutcome& outcome) {
  // What is loose as laid out counts as fractured in the balance.
  const bool has_debris = outcome.balance.mass_fractured > 0.0 && outcome.loose.empty();
  return has_debris || outcome.balance.dissipated_fracture > 0.0;
}

std::string aimless_sentence(const RunOutcome& outcome) {
  const std::string start = the_jet(outcome) + " aims at no body that it could cut";
  const std::string broken = has_broken(outcome) ? ", and solid has broken" : "";
  const std::vector<std::string> fixed = fixed_in_way(outcome.description);
  if (!fixed.empty())
    return fmt::format("{}: {} in its way {} fixed{}.", start, join_names(fixed),
                       fixed.size() == 1 ? "is" : "are", broken);
  if (!has_workpiece(outcome.description) || !has_touched(outcome)) return start + ".";
  if (outcome.cut.is_of_other_jet)
    return fmt::format("{} at the start, and its water has met none{}.", start,
                       has_broken(outcome) ? "; solid has broken under another jet" : "");
  return fmt::format(
      "{} at the start; its water has met one beside its way or that moved into it{}.", start,
      broken);
}

std::string jetless_sentence(const RunOutcome& outcome) {
  const CutSummary& cut = outcome.cut;
  const std::string start = "The run reached " + readable(outcome.time, "s");
  if (cut.initial_pieces == 0 && cut.last.pieces == 0)
    return start + "; it has no jet, so there is nothing to cut.";
  std::string text = pieces_clause(outcome);
  if (!text.empty())
    text += fmt::format(", since {}", readable(cut.pieces_since, "s"));
  else if (cut.last.pieces == 0)
    text = "; at the end no piece of the workpiece that is larger than 5% of it is in the domain";
  else
    text =
        fmt::format("; the workpiece is in {}{}",
                    cut.last.pieces == 1 ? "one piece" : fmt::format("{} pieces", cut.last.pieces),
                    cut.last.pieces == cut.initial_pieces
                        ? ", as at the start"
                        : fmt::format(", of {} at the start", cut.initial_pieces));
  if (cut.broken_fraction() > 0.0)
    text += fmt::format("; {:.2g}% of it has broken", 100.0 * cut.broken_fraction());
  return start + " without a jet" + text + ".";
}

}  // namespace kerf
