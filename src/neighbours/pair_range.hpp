// SPDX-License-Identifier: Apache-2.0
// Which particles see which, and how far: the one rule behind the neighbour list, the loops and the
// brute-force oracle.
#pragma once

#include "kernels/cubic_spline.hpp"
#include "kernels/wendland_c2.hpp"
#include "particles/fields.hpp"

namespace kerf {

// Reach of the pair (i, j) in m, as i sees j; 0 when j does not act on i. Water and solid see each
// other over the support of the mean smoothing length; rigid bodies act by their repelling layer
// only, within the mean spacing d_0 of eq. (43), and are not acted upon.
struct MeanReach {
  template <int D, class P>
  KERF_FUNCTION static double of(const ParticleView<D, P>& particles, Index i, Index j) {
    const auto& a = particles.medium(i);
    const auto& b = particles.medium(j);
    if (a.phase == Phase::rigid) return 0.0;
    if (b.phase == Phase::rigid)
      return particles.has(j, flag::repelling) ? 0.5 * (double(a.spacing) + double(b.spacing))
                                               : 0.0;
    return CubicSpline<D>::support * 0.5 *
           (double(a.smoothing_length) + double(b.smoothing_length));
  }
};

// Reach in the `standard` formulation: water sees water over the support of the mean smoothing
// length, and solid or rigid particles over that of the larger one, as these see water; solids see
// solids and rigid bodies when they touch. Rigid bodies see nothing.
struct ContactReach {
  template <int D, class P>
  KERF_FUNCTION static double of(const ParticleView<D, P>& particles, Index i, Index j) {
    const auto& a = particles.medium(i);
    const auto& b = particles.medium(j);
    if (a.phase == Phase::rigid) return 0.0;
    if (a.phase != Phase::water && b.phase != Phase::water)
      return 0.5 * (double(a.spacing) + double(b.spacing));
    const double h_a = a.smoothing_length, h_b = b.smoothing_length;
    const bool both = a.phase == b.phase;
    return WendlandC2<D>::support * (both ? 0.5 * (h_a + h_b) : (h_a > h_b ? h_a : h_b));
  }
};

}  // namespace kerf
