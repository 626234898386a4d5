// SPDX-License-Identifier: Apache-2.0
// Pair holds what the pair terms need of two particles, computed once per pair.
#pragma once

#include "kernels/cubic_spline.hpp"
#include "particles/fields.hpp"

namespace kerf {

template <int D, class P>
struct Pair {
  using Real = typename P::Real;

  Index i, j;
  MirrorCode mirror;  // 0: j itself, else its image in these planes; what follows is the image's
  const Medium<Real>*medium_i, *medium_j;
  Vector<D, Real> separation;  // d_ij = r_i - r_j, m
  Vector<D, Real> velocity;    // v_ij = v_i - v_j, m/s
  Real slope_per_distance;     // S = - (dW/dr) / r, 1/m^(D+2)
  Vector<D, Real> gradient;    // nabla_i W_ij = - S d_ij, 1/m^(D+1)
  Real distance;               // m
  Real smoothing_length;       // m, mean of both
  // Water with water, or intact solid of one piece. Fractured solid and different pieces only repel
  // one another.
  bool cohesive;
  bool same_phase;

  // A vector of particle j, or of its mirror image.
  template <class T>
  KERF_FUNCTION Vector<D, T> of_j(const Vector<D, T>& v) const {
    return MirrorPlanes<D>::image(mirror, v);
  }
  KERF_FUNCTION bool are_water() const {
    return medium_i->phase == Phase::water && medium_j->phase == Phase::water;
  }
  KERF_FUNCTION bool is_one_piece() const { return medium_i->is_one_piece_with(*medium_j, mirror); }
};

// Returns the volume of a particle, m^3 (2D: m^2): by its density where it has one, else the
// initial.
template <int D, class P>
KERF_FUNCTION typename P::Real volume_of(const ParticleView<D, P>& particles, Index i,
                                         const Medium<typename P::Real>& medium) {
  return particles.has_density(i) ? medium.mass / particles.density(i) : medium.volume;
}

// Whether the two are of one nearly incompressible solid, whose excess pressure follows its
// density.
template <int D, class P>
KERF_FUNCTION bool is_one_volume(const ParticleView<D, P>& particles, const Pair<D, P>& pair) {
  return pair.medium_i->excess_bulk_modulus > 0 && pair.medium_j->excess_bulk_modulus > 0 &&
         pair.is_one_piece() && !particles.fractured[pair.i] && !particles.fractured[pair.j];
}

template <int D, class P>
KERF_FUNCTION bool is_cohesive(const ParticleView<D, P>& particles, Index i, Index j) {
  const auto& a = particles.medium(i);
  const auto& b = particles.medium(j);
  if (a.phase != b.phase) return false;
  if (a.phase == Phase::water) return true;
  return a.piece == b.piece && !particles.fractured[i] && !particles.fractured[j];
}

}  // namespace kerf
