// SPDX-License-Identifier: Apache-2.0
// WallReaction gives the particles of a smooth solid wall the reaction to what the gradient along
// it has added to the fluid beside it (fluid/gradient_at_wall.hpp): of the push m_j a_j on the
// fluid particle j the face of i takes the share that it has in the wall beside j,
//   m_i a_i -= m_j a_j w_ij / sum_k w_kj,   w_ij = V_i S_ij d_ji . n_i.
#pragma once

#include "fluid/smooth_wall.hpp"

namespace kerf {

template <int D, class P>
struct WallReaction {
  using Real = typename P::Real;
  static constexpr bool includes_rigid = false;
  static constexpr bool only_adds = true;
  struct Sum {
    Vector<D, Real> all{}, mirrored{};  // N; the part of images of fluid
  };

  KERF_FUNCTION void add(const ParticleView<D, P>& particles, const Pair<D, P>& pair,
                         Sum& sum) const {
    const auto& push = particles.wall_push[pair.j];
    if (pair.medium_j->phase != Phase::water || !(push.inverse_weight > Real(0))) return;
    const Vector<D, Real> separation = Real(-1) * pair.separation;
    const Real along = dot(separation, seen_face(particles, pair.i, separation));
    if (!(along > particles.face_depth[pair.i])) return;
    const Real share =
        push.inverse_weight * pair.medium_i->volume * pair.slope_per_distance * along;
    const auto force = (-pair.medium_j->mass * share) * pair.of_j(push.acceleration);
    sum.all += force;
    if (pair.mirror != 0) sum.mirrored += force;
  }
  KERF_FUNCTION void finish(const ParticleView<D, P>& particles, Index i, const Sum& sum) const {
    const Real inverse = Real(1) / particles.medium(i).mass;
    particles.pressure_acceleration[i] += inverse * sum.all;
    particles.acceleration[i] += inverse * sum.all;
    if (particles.mirrors.faces != 0) particles.mirror_acceleration[i] += inverse * sum.mirrored;
  }
};

// A loop over the particles of smooth solid walls.
template <int D, class P, class Loop>
struct OfSmoothSolids {
  ParticleView<D, P> particles;
  Loop loop;

  KERF_FUNCTION void operator()(Index i) const {
    if (particles.medium(i).phase != Phase::solid || particles.fractured[i]) return;
    const auto& normal = particles.face_normal[i];
    if (dot(normal, normal) > typename P::Real(0)) loop(i);
  }
};

}  // namespace kerf
