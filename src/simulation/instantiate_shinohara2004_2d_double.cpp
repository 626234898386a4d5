// SPDX-License-Identifier: Apache-2.0
#include "simulation/instantiate.hpp"
#include "simulation/shinohara2004.hpp"

namespace kerf {

template <>
std::unique_ptr<Simulation> make<Formulation::shinohara2004, 2, Double>(const Case& description) {
  return std::make_unique<Shinohara2004<2, Double>>(description);
}

}  // namespace kerf
