// SPDX-License-Identifier: Apache-2.0
// BodyForce is the body force f of the momentum equation (26): gravity. It initialises the
// acceleration and the other fields to which the other terms add.
#pragma once

#include "pairs/pair.hpp"

namespace kerf {

template <int D, class P>
struct BodyForce {
  using Real = typename P::Real;
  static constexpr bool includes_rigid = false;
  struct Sum {};
  Vector<D, Real> gravity;  // m/s^2

  KERF_FUNCTION void add(const ParticleView<D, P>&, const Pair<D, P>&, Sum&) const {}
  KERF_FUNCTION void finish(const ParticleView<D, P>& particles, Index i, const Sum&) const {
    particles.acceleration[i] = gravity;
    if (particles.artificial_power != nullptr) particles.artificial_power[i] = Real(0);
    particles.repulsion_potential[i] = Real(0);
  }
};

}  // namespace kerf
