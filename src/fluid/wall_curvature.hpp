// SPDX-License-Identifier: Apache-2.0
// WallCurvature finds how a curved wall bends the path of the fluid beside it. As the foot of the
// particle on the wall moves by f along its velocity v, the normal n turns towards v by f times the
// curvature 1/R. With weights a over the faces that look at the particle, 1/R is the slope of the
// line of least squares through (f, n . v/|v|). Fluid that follows the wall is accelerated by v^2/R
// towards its centre, for which its pressure rises by rho v^2/R away from a convex wall.
#pragma once

#include "core/vector.hpp"

namespace kerf {

template <int D, class Real>
struct WallCurvature {
  // Sums of a v.f, a (v.f)^2, a v.n, a (v.f)(v.n), a v. `a` in any unit.
  Real foot{}, foot_squared{}, turn{}, foot_turn{};
  Vector<D, Real> velocity{};
  static constexpr double least_spread = 0.03;  // of the feet, spacings

  // `of_foot`: relative to the particle, m; `v`: relative to the wall, m/s.
  KERF_FUNCTION void add(Real a, const Vector<D, Real>& of_foot, const Vector<D, Real>& normal,
                         const Vector<D, Real>& v) {
    const Real f = dot(v, of_foot), n = dot(v, normal);
    foot += a * f;
    foot_squared += a * f * f;
    turn += a * n;
    foot_turn += a * f * n;
    velocity += a * v;
  }
  // Returns v^2/R, m/s^2: positive where the wall is convex, 0 where too few faces tell. `all`: the
  // sum of a.
  KERF_FUNCTION Real centripetal(Real all, Real spacing) const {
    if (!(all > Real(0))) return Real(0);
    const Real inverse = Real(1) / all;
    const Real speed_squared = inverse * inverse * dot(velocity, velocity);
    const Real spread = foot_squared - inverse * foot * foot;
    const Real least = Real(least_spread) * spacing;
    if (!(spread > all * speed_squared * least * least)) return Real(0);
    return speed_squared * (foot_turn - inverse * foot * turn) / spread;
  }
};

}  // namespace kerf
