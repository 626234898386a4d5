// SPDX-License-Identifier: Apache-2.0
#include "simulation/instantiate.hpp"

namespace kerf {

std::unique_ptr<Simulation> make_simulation(const Case& description) {
  const bool mixed = description.precision == PrecisionKind::mixed;
  if (description.dimension == 2)
    return mixed ? make_2d_mixed(description) : make_2d_double(description);
  return mixed ? make_3d_mixed(description) : make_3d_double(description);
}

}  // namespace kerf
