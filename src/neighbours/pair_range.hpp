// SPDX-License-Identifier: Apache-2.0
// Which particles see which, and how far: the one rule behind the neighbour list, the loops and the
// brute-force oracle.
#pragma once

#include "kernels/cubic_spline.hpp"
#include "kernels/wendland_c2.hpp"
#include "particles/fields.hpp"

namespace kerf {

// Alike: of one fluid, or of one nearly incompressible solid, in all that their formulas ask for.
// Own: of one solid that is neither. As they were when the list was built.
enum class Kinship : std::uint8_t { other, own, alike };

// A scheme says how a formulation sees a pair: its kernel, the smoothing length of two media, and
// the reach of the pair (i, j) in m as i sees j, or its image in a mirror; 0 when j does not act on
// i. Rigid bodies see nothing.

// Shinohara et al. (2004): one kernel over the mean smoothing length for all; rigid bodies act by
// their repelling layer only, within the mean spacing d_0 of eq. (43).
struct JointPairs {
  template <int D>
  using Kernel = CubicSpline<D>;
  static constexpr bool rigid_repels = true, stress_by_rate = true;

  template <class Real, class T>
  KERF_FUNCTION static Real smoothing_length(const Medium<T>& a, const Medium<T>& b) {
    return Real(0.5) * (Real(a.smoothing_length) + Real(b.smoothing_length));
  }
  template <int D, class P>
  KERF_FUNCTION static double reach(const ParticleView<D, P>& particles, Index i, Index j,
                                    MirrorCode = 0) {
    const auto& a = particles.medium(i);
    const auto& b = particles.medium(j);
    if (a.phase == Phase::rigid) return 0.0;
    if (b.phase == Phase::rigid)
      return particles.has(j, flag::repelling) ? 0.5 * (double(a.spacing) + double(b.spacing))
                                               : 0.0;
    return Kernel<D>::support * smoothing_length<double>(a, b);
  }
  template <int D, class P>
  KERF_FUNCTION static Kinship kinship(const ParticleView<D, P>&, Index, Index) {
    return Kinship::other;
  }
  // Two of one kind have one reach and are kin alike; 0 where there is more to ask.
  template <int D, class P>
  KERF_FUNCTION static std::uint32_t kind(const ParticleView<D, P>& particles, Index i) {
    return particles.medium(i).phase == Phase::rigid ? 0u : particles.source[i] + 1u;
  }
  // Distance from which on the two do nothing to one another, m.
  template <class Kernel, class View, class Pair>
  KERF_FUNCTION static auto cutoff(const View&, const Pair& pair) {
    return decltype(pair.distance)(Kernel::support) * pair.smoothing_length;
  }
};

// The `standard` formulation: water and what it wets see one another over the larger of their
// smoothing lengths, so that neither slips between the particles of the other. Solid that has come
// loose is a liquid too, and so is nearly incompressible solid to its own piece. Others see what
// else there is of their piece when it touches them.
struct ContactPairs {
  template <int D>
  using Kernel = WendlandC2<D>;
  static constexpr bool rigid_repels = false, stress_by_rate = false;

  template <class Real, class T>
  KERF_FUNCTION static Real smoothing_length(const Medium<T>& a, const Medium<T>& b) {
    const Real h_a = a.smoothing_length, h_b = b.smoothing_length;
    if (a.phase == b.phase) return Real(0.5) * (h_a + h_b);
    return h_a > h_b ? h_a : h_b;
  }
  template <int D, class P>
  KERF_FUNCTION static double reach(const ParticleView<D, P>& particles, Index i, Index j,
                                    MirrorCode mirror = 0) {
    const auto& a = particles.medium(i);
    const auto& b = particles.medium(j);
    if (a.phase == Phase::rigid) return 0.0;
    const bool one_piece = a.is_one_piece_with(b, mirror);
    const bool one_volume = a.excess_bulk_modulus > 0 && one_piece;
    if (one_piece && !one_volume && !particles.is_fluid(i) && !particles.is_fluid(j))
      return 0.5 * (double(a.spacing) + double(b.spacing));
    return Kernel<D>::support * smoothing_length<double>(a, b);
  }
  // Of two that see one another.
  template <int D, class P>
  KERF_FUNCTION static Kinship kinship(const ParticleView<D, P>& particles, Index i, Index j) {
    if (particles.has_density(i)) {
      const bool same = particles.source[i] == particles.source[j] &&
                        particles.fractured[i] == particles.fractured[j];
      const bool fitted = particles.has(i, flag::fitted) && particles.has(j, flag::fitted);
      return same && !fitted ? Kinship::alike : Kinship::other;
    }
    const auto& b = particles.medium(j);
    const bool own = b.phase == Phase::solid && particles.medium(i).piece == b.piece;
    return own && !particles.is_fluid(j) ? Kinship::own : Kinship::other;
  }
  template <int D, class P>
  KERF_FUNCTION static std::uint32_t kind(const ParticleView<D, P>& particles, Index i) {
    if (particles.medium(i).phase == Phase::rigid || particles.has(i, flag::fitted)) return 0u;
    return 2u * particles.source[i] + (particles.fractured[i] ? 2u : 1u);
  }
  // Distance from which on the two do nothing to one another, m: within a solid they only touch.
  template <class Kernel, class View, class Pair>
  KERF_FUNCTION static auto cutoff(const View& particles, const Pair& pair) {
    using Real = decltype(pair.distance);
    if (pair.is_one_piece() && !particles.has_density(pair.i) && !particles.is_fluid(pair.j))
      return Real(0.5) * (pair.medium_i->spacing + pair.medium_j->spacing);
    return Real(Kernel::support) * pair.smoothing_length;
  }
};

}  // namespace kerf
