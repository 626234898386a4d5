// SPDX-License-Identifier: Apache-2.0
// The pressure at the exit of a nozzle: the force of all other matter on the water inside it,
// against the direction of the jet, over its section. Forces within that water cancel. With the
// pressure that the water inside has this is the momentum that crosses the exit per time and area,
// less that of the flow itself.
#pragma once

#include "parallel/ordered_sum.hpp"
#include "particles/fields.hpp"

namespace kerf {

template <int D, class P>
struct ExitForce {
  ParticleView<D, P> particles;
  Vector<D, double> direction, gravity;
  std::uint16_t source;  // medium of the jet

  KERF_FUNCTION void add(Index i, Terms<1>& sum) const {
    if (!particles.has(i, flag::upstream) || particles.source[i] != source) return;
    const auto acceleration = Vector<D, double>::from(particles.acceleration[i]) - gravity;
    sum.value[0] -= double(particles.medium(i).mass) * dot(acceleration, direction);
  }
};

}  // namespace kerf
