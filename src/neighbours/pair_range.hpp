// SPDX-License-Identifier: Apache-2.0
// A pair scheme decides which particles interact and up to which distance: one rule for the
// neighbour list, the pair loops and the brute-force oracle.
#pragma once

#include "kernels/wendland_c2.hpp"
#include "particles/fields.hpp"

namespace kerf {

// The class of a pair when the list was built. `same_fluid`: of one fluid, or of one nearly
// incompressible solid, with the same parameters in all formulas; for particles beside a jump of
// the spacing of such a solid also those of its other levels. `same_body`: of one other solid.
// `unlike`: of a fluid and another fluid or a solid; two waters, rigid bodies, smooth walls and
// images are not. `image`: of a particle and a mirror image, one of them fluid, or both of one
// nearly incompressible solid.
enum class PairClass : std::uint8_t { other, same_body, unlike, same_fluid, image };

// Whether the SIMD kernel sums over neighbours of every spacing of the particle's own nearly
// incompressible solid (fluid/simd/graded_pairs.hpp). On a GPU the general pair loop does.
template <int D, class P>
KERF_FUNCTION bool sums_over_levels(const ParticleView<D, P>& particles, Index i) {
  return !on_gpu && particles.has(i, flag::fitted) && !particles.fractured[i] &&
         is_weakly_compressible(particles.medium(i));
}

// A scheme has the kernel of a formulation, the smoothing length of two media, and the reach of j,
// or of its mirror image, on i in m; 0 where j does not act on i. Nothing acts on rigid bodies.

// The `standard` formulation: water and what it wets interact over the larger of their smoothing
// lengths, so that neither penetrates between the particles of the other. Fractured solid is a
// fluid too, and so is nearly incompressible solid for its own piece. Other particles of one solid
// piece interact only within the distance of contact.
struct ContactPairs {
  template <int D>
  using Kernel = WendlandC2<D>;
  static constexpr bool rigid_repels = false;

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
  // The class of two particles within reach.
  template <int D, class P>
  KERF_FUNCTION static PairClass pair_class(const ParticleView<D, P>& particles, Index i, Index j) {
    if (particles.has_density(i)) {
      bool same = particles.source[i] == particles.source[j];
      if (particles.has(i, flag::fitted)) {
        if (sums_over_levels(particles, i))
          same = same || are_levels_of_one_body(particles.medium(i), particles.medium(j));
        else
          same = same && (particles.fractured[i] || !particles.has(j, flag::fitted));
      }
      same = same && particles.fractured[i] == particles.fractured[j];
      if (same) return PairClass::same_fluid;
    }
    const auto &a = particles.medium(i), &b = particles.medium(j);
    if (a.phase == Phase::rigid || b.phase == Phase::rigid) return PairClass::other;
    if (may_be_smooth_wall(particles, i, j)) return PairClass::other;
    if (particles.is_fluid(i) || particles.is_fluid(j))
      return a.phase == Phase::water && b.phase == Phase::water ? PairClass::other
                                                                : PairClass::unlike;
    return !particles.has_density(i) && a.piece == b.piece ? PairClass::same_body
                                                           : PairClass::other;
  }
  // The class of a particle and the image of one within reach.
  template <int D, class P>
  KERF_FUNCTION static PairClass image_class(const ParticleView<D, P>& particles, Index i, Index j,
                                             MirrorCode mirror) {
    const auto &a = particles.medium(i), &b = particles.medium(j);
    if (a.phase == Phase::rigid || b.phase == Phase::rigid) return PairClass::other;
    if (may_be_smooth_wall(particles, i, j)) return PairClass::other;
    if (particles.is_fluid(i) || particles.is_fluid(j)) return PairClass::image;
    const bool one_volume =
        a.excess_bulk_modulus > 0 && b.excess_bulk_modulus > 0 && a.is_one_piece_with(b, mirror);
    return one_volume ? PairClass::image : PairClass::other;
  }
  template <int D, class P>
  KERF_FUNCTION static std::uint32_t kind(const ParticleView<D, P>& particles, Index i) {
    const auto& medium = particles.medium(i);
    if (medium.phase == Phase::rigid) return 0u;
    if (particles.has(i, flag::fitted) && !is_weakly_compressible(medium)) return 0u;
    return 2u * particles.source[i] + (particles.fractured[i] ? 2u : 1u);
  }
  // Whether the pairs of i may have other classes than those of other particles of its kind. The
  // kinds of both, neither of them 0, and this together determine the reach and the class.
  template <int D, class P>
  KERF_FUNCTION static bool has_own_classes(const ParticleView<D, P>& particles, Index i) {
    return particles.has(i, flag::fitted);
  }
  // Returns the distance from which on the two do not interact, m: within a solid that of contact.
  template <class Kernel, class View, class Pair>
  KERF_FUNCTION static auto cutoff(const View& particles, const Pair& pair) {
    using Real = decltype(pair.distance);
    if (pair.is_one_piece() && !particles.has_density(pair.i) && !particles.is_fluid(pair.j))
      return Real(0.5) * (pair.medium_i->spacing + pair.medium_j->spacing);
    return Real(Kernel::support) * pair.smoothing_length;
  }

 private:
  // Whether one is water and the other intact solid, whose faces may be those of a smooth wall
  // (fluid/smooth_wall.hpp), which the SIMD kernels do not know.
  template <int D, class P>
  KERF_FUNCTION static bool may_be_smooth_wall(const ParticleView<D, P>& particles, Index i,
                                               Index j) {
    return particles.face_normal != nullptr &&
           particles.medium(i).phase != particles.medium(j).phase &&
           particles.fractured[i] == particles.fractured[j];
  }
  // Whether two media, the first of them nearly incompressible, differ in their spacing alone in
  // the formulas of pairs.
  template <class Medium>
  KERF_FUNCTION static bool are_levels_of_one_body(const Medium& a, const Medium& b) {
    return a.piece == b.piece && b.phase == Phase::solid && a.density == b.density &&
           a.sound_speed == b.sound_speed && a.excess_bulk_modulus == b.excess_bulk_modulus;
  }
};

}  // namespace kerf
