// SPDX-License-Identifier: Apache-2.0
#include "measure/removal.hpp"

namespace kerf {

double removed_volume(const Workpiece& workpiece, const std::vector<std::uint8_t>& standing,
                      int body) {
  double sum = 0.0;
  for (std::size_t slot = 0; slot < standing.size(); ++slot)
    if (!standing[slot] && (body < 0 || workpiece.body[slot] == body))
      sum += workpiece.volume[slot];
  return sum;
}

Removal measure_removal(double volume, const JetWork& work) {
  Removal removal;
  removal.volume = volume;
  if (work.duration > 0.0) removal.rate = volume / work.duration;
  if (volume > 0.0) removal.specific_energy = work.energy / volume;
  return removal;
}

}  // namespace kerf
