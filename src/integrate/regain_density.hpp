// SPDX-License-Identifier: Apache-2.0
// Water in motion regains the density of the room that it fills. Continuity adds up rates along the
// way, and what it adds up departs from where the particles are: the difference in pressure in U*
// diffuses density, and a particle that comes to a wall is compressed as by a mirror that comes to
// meet it, while the particles of the wall stay. In a stagnation flow particles stay at the wall
// for long; in a plane jet their row ended up a tenth sparser than those further in at about the
// same density, and its pressure 18% too high. So the density is drawn to
//   rho_0 phi / phi_0,   phi = sum V W,  phi_0 that of the lattice (rates/lattice_sums.hpp),
// the faster, the faster neighbours change places (rates/filling.hpp): d rho/dt = 4 stir (...). Not
// in a shock: the room is seen blurred there, over 2 h, and would take density away behind the
// front. Water at rest and waves of sound are hardly touched, and a uniform motion changes nothing.
// The row of a free surface, where phi falls short for lack of neighbours, is left out; the row
// beneath it is drawn to half a percent too little. Replacing the density by a sum over neighbours
// at intervals is common (Colagrossi & Landrini, J. Comput. Phys. 191 (2003) 448); the rate that
// follows the motion is of this program.
#pragma once

#include "rates/filling.hpp"

namespace kerf {

template <int D, class P>
struct RegainDensity {
  using Real = typename P::Real;
  ParticleView<D, P> particles;
  double dt;                           // s
  double lattice_filling;              // phi_0
  static constexpr double rate = 4.0;  // of `stir`; chosen: see docs/theory

  KERF_FUNCTION void operator()(Index i) const {
    if (particles.medium(i).phase != Phase::water || particles.has(i, flag::upstream)) return;
    const Real filling = particles.filling[i];
    if (filling < Real(whole_filling)) return;
    const Real turned = turning(particles, i);
    if (!(turned > Real(0))) return;
    const Real part = Real(rate * dt) * turned;
    const Real gap = filling / Real(lattice_filling) - Real(1) - particles.compression[i];
    particles.compression[i] += (part < Real(1) ? part : Real(1)) * gap;
  }
};

}  // namespace kerf
