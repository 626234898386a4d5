// SPDX-License-Identifier: Apache-2.0
#include "machine/jet_breakup.hpp"

namespace kerf {

JetAtWorkpiece jet_after(double standoff, double diameter, double speed, double coherent_length) {
  if (!(standoff > coherent_length)) return {diameter, 1.0, 0.0};
  const double spread = standoff / coherent_length;
  return {diameter * spread, 1.0 / (spread * spread), speed / (drop_distance * diameter)};
}

}  // namespace kerf
