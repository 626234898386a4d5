// SPDX-License-Identifier: Apache-2.0
// A model of the breakup of a jet in air; the air itself is not simulated. Up to its coherent
// length the jet is intact. Beyond it drops fill a cone with its tip at the nozzle: with x the
// distance over the coherent length, the diameter grows as x and the share of water falls as
// 1 / x^2, in the plane of a 2D case, across which nothing spreads, as 1 / x. The speed is constant
// (drag is small in the wake of other drops), so that mass and momentum are conserved. Water jets
// of 2 to 3 mm at 85 to 155 m/s have a water share of 2% on the axis after 200 diameters
// (Rajaratnam & Albers, J. Hydraul. Eng. 124 (1998) 647), which gives a coherent length of 200
// sqrt(0.02) = 28 diameters. Slow or very thin jets stay intact for longer. The drops arrive as
// pulses, one slug for each drop, every 4.508 diameters (Rayleigh, Proc. London Math. Soc. 10
// (1878) 4).
#pragma once

namespace kerf {

inline constexpr double coherent_diameters = 28.284271247461902;  // 200 sqrt(0.02)
inline constexpr double drop_distance = 4.508;                    // jet diameters

struct JetAtWorkpiece {
  double diameter = 0.0;         // m
  double water_share = 1.0;      // 1
  double pulse_frequency = 0.0;  // Hz, of slugs; 0 = an intact jet
};

// A jet as it leaves its nozzle.
struct FreeJet {
  double diameter = 0.0;  // m
  double speed = 0.0;     // m/s
  bool is_plane = false;  // of a 2D case
};

// Returns the state of a jet after the distance `standoff` (m) in air; `coherent_length` in m,
// infinity = no breakup.
JetAtWorkpiece jet_after(const FreeJet& jet, double standoff, double coherent_length);

}  // namespace kerf
