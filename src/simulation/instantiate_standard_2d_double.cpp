// SPDX-License-Identifier: Apache-2.0
#include "simulation/instantiate.hpp"
#include "simulation/standard.hpp"

namespace kerf {

template <>
std::unique_ptr<Simulation> make<Formulation::standard, 2, Double>(const Case& description) {
  return std::make_unique<Standard<2, Double>>(description);
}

}  // namespace kerf
