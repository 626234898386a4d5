// SPDX-License-Identifier: Apache-2.0
// The emulated engine of the tests has some of the eight only: the others would take minutes more
// to compile and say nothing new.
#include "core/error.hpp"
#include "simulation/instantiate.hpp"

namespace kerf {

#define KERF_MISSING(formulation, D, P)                                           \
  template <>                                                                     \
  std::unique_ptr<Simulation> make<Formulation::formulation, D, P>(const Case&) { \
    throw UserError("the emulated engine of the tests has no such run");          \
  }
KERF_MISSING(shinohara2004, 2, Double)
KERF_MISSING(shinohara2004, 3, Mixed)
KERF_MISSING(shinohara2004, 3, Double)
KERF_MISSING(standard, 2, Double)
KERF_MISSING(standard, 3, Double)
#undef KERF_MISSING

}  // namespace kerf
