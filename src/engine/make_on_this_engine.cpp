// SPDX-License-Identifier: Apache-2.0
#include "engine/instantiate.hpp"
#include "model/case.hpp"

namespace kerf {
namespace {

template <Formulation F>
std::unique_ptr<Simulation> make_of(const Case& description) {
  const RunSettings settings = run_settings(description);
  const bool mixed = description.precision == PrecisionKind::mixed;
  if (description.dimension == 2)
    return mixed ? make<F, 2, Mixed>(settings) : make<F, 2, Double>(settings);
  return mixed ? make<F, 3, Mixed>(settings) : make<F, 3, Double>(settings);
}

}  // namespace

std::unique_ptr<Simulation> make_here(const Case& description) {
  return description.formulation == Formulation::standard
             ? make_of<Formulation::standard>(description)
             : make_of<Formulation::shinohara2004>(description);
}

}  // namespace kerf
