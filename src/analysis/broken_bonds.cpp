// SPDX-License-Identifier: Apache-2.0
#include "analysis/broken_bonds.hpp"

#include <algorithm>
#include <utility>

#include "analysis/left_whole.hpp"
#include "analysis/workpiece.hpp"

namespace kerf {

double broken_bond_sum(const Workpiece& workpiece, const Frame& frame,
                       const std::vector<std::uint8_t>& traces) {
  const Column* damage = find_column(frame, "damage");
  const std::size_t slots = workpiece.slot_of_id.size();
  // What left the domain whole, and what it has left behind beside it, counts as unbroken.
  std::vector<std::uint8_t> closed(workpiece.position.size(), 1);
  if (!traces.empty()) closed = closed_where_left(workpiece, std::move(closed), traces);
  std::size_t solid = static_cast<std::size_t>(std::count(
      closed.begin(), closed.begin() + static_cast<std::ptrdiff_t>(slots), stands_as_laid_out));
  double sum = 0.0;
  for (std::size_t row = 0; row < frame.id.size(); ++row) {
    if (frame.category[row] != Category::solid) continue;
    const auto slot = workpiece.slot_of_id.find(frame.id[row]);
    if (slot == workpiece.slot_of_id.end() || closed[slot->second] == stands_as_laid_out) continue;
    ++solid;
    if (damage != nullptr) sum += static_cast<double>(damage->values[row]);
  }
  return sum + static_cast<double>(slots - solid);
}

}  // namespace kerf
