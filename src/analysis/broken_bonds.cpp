// SPDX-License-Identifier: Apache-2.0
#include "analysis/broken_bonds.hpp"

#include "analysis/workpiece.hpp"

namespace kerf {

double broken_bond_sum(const Workpiece& workpiece, const Frame& frame) {
  const Column* damage = find_column(frame, "damage");
  std::size_t solid = 0;
  double sum = 0.0;
  for (std::size_t row = 0; row < frame.id.size(); ++row) {
    if (frame.category[row] != Category::solid || workpiece.slot_of_id.count(frame.id[row]) == 0)
      continue;
    ++solid;
    if (damage != nullptr) sum += static_cast<double>(damage->values[row]);
  }
  return sum + static_cast<double>(workpiece.slot_of_id.size() - solid);
}

}  // namespace kerf
