// SPDX-License-Identifier: Apache-2.0
// Matter whose shocks run at the speed U = c_0 + s u into matter at rest, u the speed behind them.
// Mass and momentum across the shock give, with eta = 1 - rho_0/rho = u/U,
//   p = rho_0 U u = rho_0 c_0^2 eta / (1 - s eta)^2
// (Rice, McQueen & Walsh, Solid State Physics 6 (1958) 1), which is the reference curve of the
// equation of Mie & Grueneisen. Taken as p(rho) it gives every single shock its exact speed and
// pressure; the heat that a shock leaves behind does not act on later pressures (docs/theory/
// water_equation_of_state.md has what that amounts to). rho stays below rho_0 s / (s - 1).
#pragma once

#include <cmath>

#include "core/select.hpp"
#include "particles/medium.hpp"

namespace kerf {

struct ShockHugoniot {
  template <class T>
  KERF_FUNCTION static T pressure(const Medium<T>& water, T compression) {  // Pa
    const T eta = compression / (T(1) + compression);
    const T room = T(1) - water.hugoniot_slope * eta;
    return water.density * water.sound_speed * water.sound_speed * eta / (room * room);
  }

  // Speed of sound at this density, m/s: c^2 = dp/drho. Opened matter has that at rest.
  template <class T>
  KERF_FUNCTION static T sound_speed(const Medium<T>& water, T compression) {
    return sound_speed(water.sound_speed, water.hugoniot_slope, compression);
  }
  // `at_rest`: c_0; `slope`: s.
  template <class T, class Number>
  KERF_FUNCTION static T sound_speed(Number at_rest, Number slope, T compression) {
    const T squeezed = maximum(compression, T(0));
    const T eta = squeezed / (T(1) + squeezed);
    const T steep = slope * eta;
    const T room = T(1) - steep;
    return at_rest * (T(1) - eta) * square_root((T(1) + steep) / room) / room;
  }

  // Stored energy per mass, J/kg: the integral of p / rho^2 d rho from rho_0.
  template <class T>
  KERF_FUNCTION static double energy(const Medium<T>& water, double compression) {
    const double s = water.hugoniot_slope, c = water.sound_speed;
    const double steep = s * compression / (1.0 + compression);
    return c * c / (s * s) * (std::log1p(-steep) + steep / (1.0 - steep));
  }

  // No pressure reaches this density.
  template <class T>
  KERF_FUNCTION static bool is_beyond(const Medium<T>& water, T compression) {
    return !(water.hugoniot_slope * compression < T(1) + compression);
  }
};

}  // namespace kerf
