// SPDX-License-Identifier: Apache-2.0
// The speeds a case is built around, in m/s.
#pragma once

#include "materials/shock_hugoniot.hpp"
#include "model/case.hpp"

namespace kerf {

// Of water at 20 C and 0.1 MPa (Wagner & Pruss, J. Phys. Chem. Ref. Data 31 (2002) 387: 1482).
inline constexpr double real_water_sound_speed = 1481.0;
// Above this ten times the speed is no longer slower than sound in real water.
inline constexpr double fast_water = 150.0;

double fastest_jet(const Case& description);  // 0 without a jet
// Initial velocities and prescribed motions, sampled at particles and times; 0 when all rest.
double fastest_body(const Case& description);
// sqrt(2 g H) with H the height of the water along gravity; 0 without either.
double falling_speed(const Case& description);
// V of eq. (18): the fastest jet or body, else the speed of falling water.
double characteristic_speed(const Case& description);

}  // namespace kerf
