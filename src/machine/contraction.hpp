// SPDX-License-Identifier: Apache-2.0
// How much narrower a free jet is than its orifice: the plane flow of an ideal fluid out of a wide
// vessel whose walls meet the axis at the angle beta. With the conjugate velocity (over that of the
// free surface) as the variable, a sector of the unit disc of half-angle beta, and t = zeta^(pi /
// beta), the potential is that of a source at t = 0 and a sink at t = 1 of the whole disc; along
// the free surface, t = exp(i theta), this gives
//   1 / C_c = 1 + (1 / pi) integral_0^pi sin(beta theta / pi) cot(theta / 2) d theta,
// pi / (pi + 2) for a slit in a wall (90 degrees), 1/2 for Borda's mouthpiece (180 degrees). After
// the method of Kirchhoff; numbers by von Mises, Z. VDI 61 (1917) 447. A round orifice in a plate
// contracts much the same (0.62 measured; Batchelor, An Introduction to Fluid Dynamics, 1967).
#pragma once

namespace kerf {

// Area of the jet over that of the orifice. `angle` between wall and axis, rad, from 0 (excluded)
// to pi.
double contraction(double angle);

}  // namespace kerf
