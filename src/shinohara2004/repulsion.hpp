// SPDX-License-Identifier: Apache-2.0
// Repulsion by the outermost layer of a rigid body, eq. (43) of Shinohara et al. (2004), after
// Monaghan (1994):  f = D [ (d_0/d)^4 - (d_0/d)^2 ] d_ij / d^2   for d <= d_0, per unit mass.
// d_0 is the mean spacing of the two particles, the distance at which they were laid out.
#pragma once

#include "pairs/pair.hpp"

namespace kerf {

template <int D, class P>
struct Repulsion {
  using Real = typename P::Real;
  static constexpr bool includes_rigid = true;
  struct Sum {
    Vector<D, Real> repulsion{};
    Real potential{}, power{};
  };

  KERF_FUNCTION void add(const ParticleView<D, P>&, const Pair<D, P>&, Sum&) const {}

  KERF_FUNCTION void add_rigid(const ParticleView<D, P>& particles, const Pair<D, P>& pair,
                               Sum& sum) const {
    const Real rest = Real(0.5) * (pair.medium_i->spacing + pair.medium_j->spacing);
    const Real d = pair.distance;
    if (d >= rest || !(d > Real(0))) return;
    const Real ratio2 = rest * rest / (d * d);
    const Real strength = pair.medium_j->repulsion;
    const auto repulsion = (strength * (ratio2 * ratio2 - ratio2) / (d * d)) * pair.separation;
    sum.repulsion += repulsion;
    sum.power += dot(repulsion, pair.of_j(particles.velocity[pair.j]));
    // Integral of f from d to d_0.
    sum.potential += strength * (Real(0.25) * ratio2 * ratio2 - Real(0.5) * ratio2 + Real(0.25));
  }
  KERF_FUNCTION void finish(const ParticleView<D, P>& particles, Index i, const Sum& sum) const {
    particles.repulsion[i] = sum.repulsion;
    particles.repulsion_potential[i] = sum.potential;
    particles.acceleration[i] += sum.repulsion;
    if (particles.rigid_power != nullptr) particles.rigid_power[i] = {Real(0), Real(0), sum.power};
  }
};

}  // namespace kerf
