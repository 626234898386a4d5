// SPDX-License-Identifier: Apache-2.0
#include "analysis/cut_over.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "machine/simulated_piece.hpp"
#include "model/case.hpp"

namespace kerf {

namespace {

// Returns the first row in which the workpiece is cut through.
std::vector<CutState>::const_iterator row_of_cut(const std::vector<CutState>& history) {
  return std::find_if(history.begin(), history.end(),
                      [](const CutState& state) { return state.cut_through; });
}

// Returns whether the water that has cut the workpiece is still on its way through it, under a
// nozzle that stands in place of one that moves: when it is through tells the feed. Water that
// follows a crack may never be.
bool awaits_water(const Case& description, const std::vector<CutState>& history) {
  if (!stands_for_traverse(description)) return false;
  const WorkpieceSetting& workpiece = *description.workpiece;
  const double depth = workpiece.size[1] / std::cos(description.jets.back().angle);
  const auto cut = row_of_cut(history);
  if (cut->front_depth < CutSummary::least_share * depth) return false;
  return std::none_of(cut, history.end(), [&](const CutState& state) {
    return state.front_depth >= depth - workpiece.spacing;
  });
}

}  // namespace

bool may_end_early(const Case& description) {
  return std::isfinite(description.time.after_cut) || std::isfinite(last_front_depth(description));
}

bool is_cut_over(const Case& description, const std::vector<CutState>& history, double time) {
  if (history.empty()) return false;
  if (history.back().front_depth >= last_front_depth(description)) return true;
  if (!history.back().cut_through) return false;
  return time >= row_of_cut(history)->time + description.time.after_cut &&
         !awaits_water(description, history);
}

double expected_end(const Case& description, const std::vector<CutState>& history) {
  const double end = description.time.end, after_cut = description.time.after_cut;
  if (history.empty()) return end;
  const CutState& last = history.back();
  if (last.cut_through && awaits_water(description, history)) return end;
  if (last.cut_through) return std::min(end, row_of_cut(history)->time + after_cut);
  if (!(last.front_depth > 0.0)) return end;
  const double per_depth = last.time / last.front_depth;
  const double at_part = per_depth * last_front_depth(description);
  const double after = description.workpiece
                           ? per_depth * description.workpiece->size[1] + after_cut
                           : std::numeric_limits<double>::infinity();
  return std::max(last.time, std::min({end, at_part, after}));
}

}  // namespace kerf
