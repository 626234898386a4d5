// SPDX-License-Identifier: Apache-2.0
// This functor reflects fluid at symmetry planes. A fluid particle that has passed through a plane
// has met its mirror image there; the two have the same state, so that the particle continues as
// its image does. Solids are not reflected: contact with their mirror images holds them back.
#pragma once

#include "particles/fields.hpp"

namespace kerf {

template <int D, class P>
struct ReflectAtSymmetry {
  using Real = typename P::Real;
  using Point = Vector<D, double>;
  ParticleView<D, P> particles;
  double dt;  // s, of the step

  KERF_FUNCTION void operator()(Index i) const {
    const auto& mirrors = particles.mirrors;
    if (mirrors.faces == 0 || !particles.is_fluid(i) || particles.is_constrained(i)) return;
    const auto& x = particles.position[i];
    MirrorCode passed = 0;
    for (int a = 0; a < D; ++a) {
      if (x[a] < mirrors.low[a]) passed |= mirrors.low_face(a);
      if (x[a] > mirrors.high[a]) passed |= mirrors.high_face(a);
    }
    passed &= mirrors.faces;
    if (passed == 0) return;
    const auto velocity = mirrors.image(passed, particles.velocity[i]);
    particles.mirror_acceleration[i] +=
        Real(1.0 / dt) * (velocity - particles.velocity[i]);  // for the balance of momentum
    particles.velocity[i] = velocity;
    particles.conservative_acceleration[i] =
        mirrors.image(passed, particles.conservative_acceleration[i]);
    const Point before = x;
    particles.position[i] = mirrors.image_position(passed, x);
    keep_damping_work(i, before);
  }

 private:
  // For the balance of energy: the damping did its work on the way to where the particle passed
  // through the plane and behind it, `before`, not on that to its image.
  KERF_FUNCTION void keep_damping_work(Index i, const Point& before) const {
    const Point& start = particles.start_position[i];
    const Point& now = particles.position[i];
    auto& damping = particles.damping_acceleration[i];
    for (int a = 0; a < D; ++a)
      if (now[a] != before[a] && now[a] != start[a])
        damping[a] *= static_cast<Real>((before[a] - start[a]) / (now[a] - start[a]));
  }
};

}  // namespace kerf
