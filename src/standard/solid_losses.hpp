// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace kerf {

// The losses of the solids since the start, J (2D: J/m).
struct SolidLosses {
  double viscous = 0.0;   // by the viscosity of bonds
  double released = 0.0;  // by bonds that broke, and by damage
  double plastic = 0.0;   // by plastic flow
};

}  // namespace kerf
