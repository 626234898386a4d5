// SPDX-License-Identifier: Apache-2.0
// The list of the engines: formulation, dimension and precision, one translation unit each, so that
// they build in parallel.
#pragma once

#include <memory>

#include "core/precision.hpp"
#include "model/formulation.hpp"
#include "simulation/run_settings.hpp"
#include "simulation/simulation.hpp"

namespace kerf {

template <Formulation, int D, class P>
std::unique_ptr<Simulation> make(const RunSettings& settings);

#define KERF_MAKE(formulation, D, P) \
  template <>                        \
  std::unique_ptr<Simulation> make<Formulation::formulation, D, P>(const RunSettings& settings);
KERF_MAKE(shinohara2004, 2, Mixed)
KERF_MAKE(shinohara2004, 2, Double)
KERF_MAKE(shinohara2004, 3, Mixed)
KERF_MAKE(shinohara2004, 3, Double)
KERF_MAKE(standard, 2, Mixed)
KERF_MAKE(standard, 2, Double)
KERF_MAKE(standard, 3, Mixed)
KERF_MAKE(standard, 3, Double)
#undef KERF_MAKE

// Makes the run of a case by the engine that this function is compiled into: for processors, or for
// a GPU (src/engine/gpu/).
std::unique_ptr<Simulation> make_here(const Case& description);

}  // namespace kerf
