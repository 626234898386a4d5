// SPDX-License-Identifier: Apache-2.0
#include "input/refine.hpp"

#include "model/case.hpp"

namespace kerf {

Case refined(Case description, double refinement) {
  for (Body& body : description.bodies) body.spacing /= refinement;
  for (Jet& jet : description.jets) jet.spacing /= refinement;
  if (description.machine) description.machine->spacing /= refinement;
  return description;
}

}  // namespace kerf
