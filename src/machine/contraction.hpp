// SPDX-License-Identifier: Apache-2.0
// The contraction of a free jet behind its orifice: the plane flow of an ideal fluid out of a
// vessel with parallel walls that ends in a funnel whose walls meet the axis at the angle beta.
// With the conjugate velocity (over that of the free surface) as the variable, half of the flow
// fills a sector of the unit disc: the axis and the wall of the vessel are its real side, the wall
// of the funnel the side at beta, the free surface its arc. t = zeta^(pi / beta) opens the sector
// to half a disc, in which the potential is that of a source at t_0, far up in the vessel, its
// mirror image at 1 / t_0, and a sink at t = 1; along the free surface, t = exp(i theta), this
// gives
//   1 / C_c = 1 + (1 / pi) integral_0^pi sin(beta theta / pi)
//                 [cot(theta / 2) - sin theta / ((t_0 + 1/t_0) / 2 - cos theta)] d theta,
//   t_0 = (C_c s)^(pi / beta),   s: width of the orifice over that of the vessel, by continuity.
// In a wide vessel that is pi / (pi + 2) for a slit in a wall (90 degrees) and 1/2 for Borda's
// mouthpiece (180 degrees). After the method of Kirchhoff; numbers by von Mises, Z. VDI 61 (1917)
// 447. A round orifice in a plate contracts much the same (0.62 measured; Batchelor, An
// Introduction to Fluid Dynamics, 1967).
#pragma once

namespace kerf {

// Returns the area of the jet over that of the orifice. `angle`: between wall and axis, rad, from 0
// (excluded) to pi; `share`: width of the orifice over that of the vessel, from 0 to less than 1.
double contraction(double angle, double share = 0.0);

}  // namespace kerf
