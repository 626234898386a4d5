// SPDX-License-Identifier: Apache-2.0
#include "analysis/cut_over.hpp"

#include <algorithm>
#include <cmath>

#include "machine/simulated_piece.hpp"
#include "model/case.hpp"

namespace kerf {

bool may_end_early(const Case& description) {
  return std::isfinite(description.time.after_cut) || std::isfinite(last_front_depth(description));
}

bool is_cut_over(const Case& description, const std::vector<CutState>& history, double time) {
  if (history.empty()) return false;
  if (history.back().front_depth >= last_front_depth(description)) return true;
  if (!history.back().cut_through) return false;
  const auto cut = std::find_if(history.begin(), history.end(),
                                [](const CutState& state) { return state.cut_through; });
  return time >= cut->time + description.time.after_cut;
}

}  // namespace kerf
