// SPDX-License-Identifier: Apache-2.0
// Speed of the water that a pump drives through an orifice, by Bernoulli's integral
//   V^2 / 2 = integral dP / rho(P),   rho = rho_0 (1 + P / L)^n,
// with the compression of water as in Hashish, J. Eng. Mater. Technol. 111 (1989) 154: L = 300 MPa,
// n = 0.1368. They imply the sound speed at rest sqrt(L / (n rho_0)) = 1482 m/s, and
//   V^2 = 2 L / (rho_0 (1 - n)) [(1 + P / L)^(1 - n) - 1].
#pragma once

namespace kerf {

inline constexpr double compression_pressure = 300e6;   // L, Pa
inline constexpr double compression_exponent = 0.1368;  // n, 1

// Returns V, m/s, without friction. `pressure` in Pa, not negative; `density` at rest in kg/m^3.
double jet_speed(double pressure, double density);
// Returns the pressure that drives a jet of that speed, Pa: the inverse of the function above.
double pump_pressure(double speed, double density);

}  // namespace kerf
