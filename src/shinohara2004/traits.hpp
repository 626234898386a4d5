// SPDX-License-Identifier: Apache-2.0
// The traits of the formulation of Shinohara et al. (2004): which particles interact, which fields
// they have, and what a solid particle stores.
#pragma once

#include "kernels/cubic_spline.hpp"
#include "neighbours/pair_range.hpp"
#include "shinohara2004/hooke_solid.hpp"
#include "simulation/balance_sums.hpp"

namespace kerf {

// All pairs share one kernel over their mean smoothing length; rigid bodies act by their repelling
// layer only, within the mean spacing d_0 of eq. (43).
struct JointPairs {
  template <int D>
  using Kernel = CubicSpline<D>;
  static constexpr bool rigid_repels = true;

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
  KERF_FUNCTION static PairClass pair_class(const ParticleView<D, P>&, Index, Index) {
    return PairClass::other;
  }
  template <int D, class P>
  KERF_FUNCTION static PairClass image_class(const ParticleView<D, P>&, Index, Index, MirrorCode) {
    return PairClass::other;
  }
  // Returns the kind of a particle: two particles of one kind have the same reach and the class
  // same_fluid; 0 if that does not hold.
  template <int D, class P>
  KERF_FUNCTION static std::uint32_t kind(const ParticleView<D, P>& particles, Index i) {
    return particles.medium(i).phase == Phase::rigid ? 0u : particles.source[i] + 1u;
  }
  template <int D, class P>
  KERF_FUNCTION static bool has_own_classes(const ParticleView<D, P>&, Index) {
    return false;
  }
  // Returns the distance from which on the two do not interact, m.
  template <class Kernel, class View, class Pair>
  KERF_FUNCTION static auto cutoff(const View&, const Pair& pair) {
    return decltype(pair.distance)(Kernel::support) * pair.smoothing_length;
  }
};

struct Shinohara2004Traits {
  using Pairs = JointPairs;

  static FieldGroups field_groups(bool, bool, bool mirrored) {
    return {.rate_stress = true,
            .contact = false,
            .mirrored = mirrored,
            .density_losses = false,
            .smooth_walls = false};
  }

  template <int D, class P>
  KERF_FUNCTION static SolidStorage stored_by_solid(const ParticleView<D, P>& particles, Index i,
                                                    double mass) {
    const auto& medium = particles.medium(i);
    const double compression = particles.compression[i];
    const bool fractured = particles.fractured[i] != 0;
    return {mass * HookeSolid::volumetric_energy(medium, compression, fractured),
            mass * HookeSolid::deviatoric_energy(medium, particles.shear[i], compression)};
  }
};

}  // namespace kerf
