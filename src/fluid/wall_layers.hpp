// SPDX-License-Identifier: Apache-2.0
// WallLayers has the sums over a plane wall of layers that are parallel to its surface, one spacing
// d apart, as a lattice in line with the surface has them: over the planes (2D: lines) at the
// distances x_l = y + (l + 1/2) d, l = 0, 1, 2, ..., from a particle at the height y,
//   sum V F -> sum_l d integral of F over the plane l.
#pragma once

#include <cmath>

#include "core/host_device.hpp"

namespace kerf {

template <int D, class Real>
struct WallLayers {
  Real volume{};  // 1, F = W
  Real force{};   // 1/m, F = S d.n
  Real across{};  // 1, F = S (d.n)^2
  Real along{};   // 1, F = S d.t^2, with t along the wall

  // `height`, `spacing` and the smoothing length `h` in m.
  template <class Kernel>
  KERF_FUNCTION static WallLayers at(Real height, Real spacing, Real h) {
    WallLayers sums;
    for (Real x = height + Real(0.5) * spacing; x < Real(Kernel::support) * h; x += spacing)
      sums.template add_plane<Kernel>(x, spacing, h);
    return sums;
  }

 private:
  // Integrates over the plane at the distance x by the rule of Gauss and Legendre with eight points
  // along the radius.
  template <class Kernel>
  KERF_FUNCTION void add_plane(Real x, Real spacing, Real h) {
    constexpr double point[] = {0.1834346424956498, 0.5255324099163290, 0.7966664774136267,
                                0.9602898564975363};
    constexpr double weight[] = {0.3626837833783620, 0.3137066458778873, 0.2223810344533745,
                                 0.1012285362903763};
    const Real reach = Real(Kernel::support) * h;
    const Real half = Real(0.5) * std::sqrt(reach * reach - x * x);
    for (int k = 0; k < 8; ++k) {
      const Real side = k % 2 == 0 ? Real(1) : Real(-1);
      const Real t = half * (Real(1) + side * Real(point[k / 2]));
      const Real r = std::sqrt(x * x + t * t);
      const Real ring = D == 2 ? Real(2) : Real(6.283185307179586) * t;
      const Real area = spacing * half * Real(weight[k / 2]) * ring;
      const Real slope = area * Kernel::slope_per_distance(r, h);
      volume += area * Kernel::value(r, h);
      force += slope * x;
      across += slope * x * x;
      along += slope * t * t / Real(D - 1);
    }
  }
};

}  // namespace kerf
