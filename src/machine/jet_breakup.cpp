// SPDX-License-Identifier: Apache-2.0
#include "machine/jet_breakup.hpp"

namespace kerf {

JetAtWorkpiece jet_after(const FreeJet& jet, double standoff, double coherent_length) {
  if (!(standoff > coherent_length)) return {jet.diameter, 1.0, 0.0};
  const double spread = standoff / coherent_length;
  const double section = jet.is_plane ? spread : spread * spread;
  return {jet.diameter * spread, 1.0 / section, jet.speed / (drop_distance * jet.diameter)};
}

}  // namespace kerf
