// SPDX-License-Identifier: Apache-2.0
// The characteristic speeds of a case, in m/s.
#pragma once

#include "materials/shock_hugoniot.hpp"

namespace kerf {

struct Case;

// Of water at 20 C and 0.1 MPa (Wagner & Pruss, J. Phys. Chem. Ref. Data 31 (2002) 387: 1482).
inline constexpr double real_water_sound_speed = 1481.0;
// Above this speed ten times the speed exceeds the sound speed of real water.
inline constexpr double fast_water = 150.0;
// Up to shocks that stop water of this speed the law of water is compared with data
// (docs/theory/water_equation_of_state.md).
inline constexpr double fastest_compared_water = 900.0;

// Returns the speed of the fastest water of all jets, on the axis of one with a profile; 0 without
// a jet.
double fastest_jet(const Case& description);
// Returns the largest initial or prescribed speed of the bodies, sampled at particles and times.
double fastest_body(const Case& description);
// Returns sqrt(2 g H) with H the height of the water along gravity; 0 without water or gravity.
double falling_speed(const Case& description);
// Returns V of eq. (18): the speed of the fastest jet or body, else that of falling water.
double characteristic_speed(const Case& description);

}  // namespace kerf
