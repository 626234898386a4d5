// SPDX-License-Identifier: Apache-2.0
// The only list of what is compiled: formulation, dimension and precision, one translation unit
// each so that they build side by side.
#pragma once

#include <memory>

#include "core/precision.hpp"
#include "simulation/simulation.hpp"

namespace kerf {

template <Formulation, int D, class P>
std::unique_ptr<Simulation> make(const Case& description);

#define KERF_MAKE(formulation, D, P) \
  template <>                        \
  std::unique_ptr<Simulation> make<Formulation::formulation, D, P>(const Case& description);
KERF_MAKE(shinohara2004, 2, Mixed)
KERF_MAKE(shinohara2004, 2, Double)
KERF_MAKE(shinohara2004, 3, Mixed)
KERF_MAKE(shinohara2004, 3, Double)
KERF_MAKE(standard, 2, Mixed)
KERF_MAKE(standard, 2, Double)
KERF_MAKE(standard, 3, Mixed)
KERF_MAKE(standard, 3, Double)
#undef KERF_MAKE

// One of them, as the case wants it: the engine that this is compiled into, for processors or for a
// GPU (src/gpu/), makes the run.
std::unique_ptr<Simulation> make_here(const Case& description);

}  // namespace kerf
