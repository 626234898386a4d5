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

template <int D, class P>
struct StretchLimit {
  using Real = typename P::Real;
  SolidView<D, P> solid;

  KERF_FUNCTION WaveTime operator()(Index i) const {
    const auto& medium = solid.medium(i);
    const double wave =
        double(medium.longitudinal_speed()) * (1.0 + 1.2 * double(medium.artificial_linear));
    const double unsqueezed = double(medium.smoothing_length) / wave;
    if (solid.loose[i]) return {unsqueezed, i};
    const auto strain = principal_values(green_strain(solid.gradient[i]));
    Real least = strain[0] < strain[1] ? strain[0] : strain[1];
    least = least < strain[2] ? least : strain[2];
    if (!(least < Real(0))) return {unsqueezed, i};
    const Real square = Real(1) + Real(2) * least;
    // A deformation that is not one any more is left to those who look for it.
    return {unsqueezed * (square > Real(1e-4) ? std::sqrt(double(square)) : 0.01), i};
  }
};

}  // namespace kerf
