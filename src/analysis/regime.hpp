// SPDX-License-Identifier: Apache-2.0
// The regime of a cut follows from a pressure and three speeds. With U = V / (1 + sqrt(rho_t /
// rho_j)) the speed of the front in a target without strength (hydrodynamic penetration) and R the
// resistance of the target:
//   rho V^2 / 2 < R     elastic dimple: the stagnation pressure does not overcome the target
//   U < c_R             crack-led: cracks, which run at up to c_R, are faster than the front
//   c_R <= U <= c_p     erosion: the front is faster than cracks, but not than elastic waves
//   U > c_p             hydrodynamic: the front is faster than every elastic wave
// A jet without strength of its own penetrates from V = sqrt(2 R / rho_j) on (Tate, J. Mech. Phys.
// Solids 15 (1967) 387; Alekseevskii, Fiz. Goreniya Vzryva 2 (1966) 99). R is the least stress at
// which the target gives way: E e with e the failure strain, its tensile strength, the stress of
// its first plastic flow, or 5/2 G, the pressure that expands a cavity in a neo-Hookean solid
// without bound (Gent & Lindley, Proc. R. Soc. A 249 (1959) 195). The last one holds for every
// solid, so that a material without a limit has a regime too.
// For the solid of Shinohara et al. (2004) these limits lie at V = 4.6, 12 and 24 m/s: its case at
// 5 m/s is crack-led and its case at 50 m/s hydrodynamic.
#pragma once

#include <string>

namespace kerf {

struct DerivedNumbers;
struct Material;

// What determines the limits of a solid besides its material.
struct SolidScale {
  double failure_strain = 0.0;  // 1, at this spacing; 0 = none
  double spacing = 0.0;         // m
  int dimension = 2;
};

// Returns the resistance R of a solid, Pa.
double resistance_of(const Material& solid, const SolidScale& scale);

// Returns the regime of a jet on a solid.
std::string regime_of(const DerivedNumbers& numbers);

}  // namespace kerf
