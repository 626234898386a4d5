// SPDX-License-Identifier: Apache-2.0
// How long a wave takes across the kernel of a solid that is squeezed. In the reference
// configuration, where the sums are, a solid squeezed to the stretch lambda carries waves 1 /
// lambda times as fast along that axis; so the time is  h lambda / (c (1 + 1.2 A)),  lambda the
// least principal stretch, A the viscosity of the bonds as in integrate/time_step.hpp.
#pragma once

#include <cmath>

#include "materials/finite_strain.hpp"
#include "solid/solid_fields.hpp"

namespace kerf {

struct WaveTime {
  double time;     // s
  Index particle;  // of the solid
};
struct ShorterWave {
  KERF_FUNCTION WaveTime operator()(const WaveTime& a, const WaveTime& b) const {
    if (a.time != b.time) return a.time < b.time ? a : b;
    return a.particle <= b.particle ? a : b;
  }
};

// Half of (lambda^2 - 1) of the axis that is squeezed most, and what it cannot be less than: the
// bound of Gershgorin, which asks for no angle of a cubic's roots.
template <int D, class T>
KERF_FUNCTION T least_strain(const SymmetricTensor<D, T>& green) {
  const auto strain = principal_values(green);
  const T least = strain[0] < strain[1] ? strain[0] : strain[1];
  return least < strain[2] ? least : strain[2];
}
template <int D, class T>
KERF_FUNCTION T bound_of_strain(const SymmetricTensor<D, T>& green) {
  T least = D == 2 ? green(2, 2) : green(0, 0);
  for (int a = 0; a < D; ++a) {
    T row = green(a, a);
    for (int b = 0; b < D; ++b)
      if (b != a) row -= std::abs(green(a, b));
    least = row < least ? row : least;
  }
  return least;
}

// Particles whose bound is beyond `longest` have not the shortest time and are passed over.
template <int D, class P>
struct StretchLimit {
  using Real = typename P::Real;
  static constexpr double never = 1e300;
  SolidView<D, P> solid;
  double longest = never;  // s

  KERF_FUNCTION WaveTime operator()(Index i) const {
    if (!(bound(i) < longest)) return {never, i};
    return {solid.loose[i] ? time(i, Real(0)) : time(i, least_strain(green(i))), i};
  }
  // The time is at least so long, s; a little less for the roundings of both.
  KERF_FUNCTION double bound(Index i) const {
    return (1.0 - 1e-5) * (solid.loose[i] ? time(i, Real(0)) : time(i, bound_of_strain(green(i))));
  }

 private:
  KERF_FUNCTION auto green(Index i) const { return green_strain(solid.gradient[i]); }
  KERF_FUNCTION double time(Index i, Real least) const {
    const auto& medium = solid.medium(i);
    const double wave =
        double(medium.longitudinal_speed()) * (1.0 + 1.2 * double(medium.artificial_linear));
    const double unsqueezed = double(medium.smoothing_length) / wave;
    if (!(least < Real(0))) return unsqueezed;
    const Real square = Real(1) + Real(2) * least;
    // A deformation that is not one any more is left to those who look for it.
    return unsqueezed * (square > Real(1e-4) ? std::sqrt(double(square)) : 0.01);
  }
};

// The least bound: whoever has it has about the shortest time.
template <int D, class P>
struct StretchBound {
  StretchLimit<D, P> limit;
  KERF_FUNCTION WaveTime operator()(Index i) const { return {limit.bound(i), i}; }
};

template <int D, class P>
struct StretchLimitOf {
  StretchLimit<D, P> limit;
  Index particle;
  KERF_FUNCTION WaveTime operator()(Index) const { return limit(particle); }
};

// The shortest time of all, exactly: by the bounds of all and the times of a few.
template <int D, class P>
WaveTime shortest_wave(const SolidView<D, P>& solid, Index count) {
  StretchLimit<D, P> limit{solid};
  const WaveTime none{StretchLimit<D, P>::never, 0};
  const auto suspect =
      reduce_unordered(count, StretchBound<D, P>{limit}, none, ShorterWave{}).particle;
  const auto found = reduce_unordered(1, StretchLimitOf<D, P>{limit, suspect}, none, ShorterWave{});
  limit.longest = found.time;
  return reduce_unordered(count, limit, found, ShorterWave{});
}

}  // namespace kerf
