// SPDX-License-Identifier: Apache-2.0
// ArtificialViscosity is that of the paper's formulation, eqs. (38) and (39) of Shinohara et al.
// (2004), over all pairs, eq. (26). In the standard formulation solids have solid/bond_terms.hpp
// and water fluid/riemann.hpp.
//   Pi_ij = (-A c theta + B theta^2) / rho   for v_ij . d_ij < 0, else 0,
//   theta = h v_ij . d_ij / (d_ij^2 + C h^2),   c, rho, h: means of i and j.
// Two misprints of the paper are corrected: (39) prints C h, which has the wrong dimension, and in
// (26) the term must oppose approach, so it enters with the sign of a pressure: dv_i/dt = -sum m_j
// Pi nabla W. A and B belong to a phase; a pair of water and solid, which the paper leaves open,
// takes their geometric mean, so that nearly inviscid water stays so beside a strongly damped
// solid.
#pragma once

#include <cmath>

#include "pairs/pair.hpp"

namespace kerf {

template <int D, class P>
struct ArtificialViscosity {
  using Real = typename P::Real;
  static constexpr bool includes_rigid = false;
  struct Sum {
    Vector<D, Real> viscous{};
    Real power{};
  };

  KERF_FUNCTION void add(const ParticleView<D, P>& particles, const Pair<D, P>& pair,
                         Sum& sum) const {
    const Real approach = dot(pair.velocity, pair.separation);
    if (approach >= Real(0)) return;
    const auto& a = *pair.medium_i;
    const auto& b = *pair.medium_j;
    const Real h = pair.smoothing_length;
    const Real linear = std::sqrt(a.artificial_linear * b.artificial_linear);
    const Real quadratic = std::sqrt(a.artificial_quadratic * b.artificial_quadratic);
    const Real softening = Real(0.5) * (a.artificial_softening + b.artificial_softening);
    const Real sound_speed = Real(0.5) * (a.sound_speed + b.sound_speed);
    const Real density = Real(0.5) * (particles.density(pair.i) + particles.density(pair.j));
    const Real theta = h * approach / (pair.distance * pair.distance + softening * h * h);
    const Real pi = (-linear * sound_speed * theta + quadratic * theta * theta) / density;
    sum.viscous -= (b.mass * pi) * pair.gradient;
    // Each side accounts for half of the dissipation of the pair.
    sum.power += Real(0.5) * b.mass * pi * dot(pair.velocity, pair.gradient);
  }
  KERF_FUNCTION void finish(const ParticleView<D, P>& particles, Index i, const Sum& sum) const {
    particles.acceleration[i] += sum.viscous;
    particles.artificial_power[i] += sum.power;
  }
};

}  // namespace kerf
