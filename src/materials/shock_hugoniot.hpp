// SPDX-License-Identifier: Apache-2.0
// This equation of state holds for matter whose shocks run at the speed U = c_0 + s u into matter
// at rest, u the speed behind them. Mass and momentum across the shock give, with eta = 1 -
// rho_0/rho = u/U,
//   p = rho_0 U u = rho_0 c_0^2 eta / (1 - s eta)^2
// (Rice, McQueen & Walsh, Solid State Physics 6 (1958) 1), which is the reference curve of the
// equation of Mie & Grueneisen. Taken as p(rho) it gives every single shock its exact speed and
// pressure; the heat that a shock leaves behind does not act on later pressures
// (docs/theory/water_equation_of_state.md gives the error). rho stays below rho_0 s / (s - 1).
#pragma once

#include <cmath>
#include <string_view>
#include <vector>

#include "core/case_key.hpp"
#include "core/select.hpp"
#include "materials/law_arguments.hpp"

namespace kerf {

// s of real water.
inline constexpr double real_water_hugoniot_slope = 1.975;

template <class T>
struct ShockHugoniot {
  T slope = 0;  // s, 1

  static constexpr std::string_view sentence =
      "Water whose shocks run as in real water, p = rho_0 c^2 eta / (1 - s eta)^2 with "
      "eta = 1 - rho_0/rho";
  static constexpr bool is_weakly_compressible = false;
  static std::vector<Key> rows() {
    return {{"hugoniot_slope",
             ValueKind::number,
             "",
             real_water_hugoniot_slope,
             {0.0, 10.0, true},
             {},
             "",
             "s of the speed c + s u of a shock that leaves matter at the speed u behind",
             stored_in<&ShockHugoniot<double>::slope>}};
  }

  KERF_FUNCTION T pressure(const RestState<T>& rest, T compression) const {  // Pa
    const T eta = compression / (T(1) + compression);
    const T room = T(1) - slope * eta;
    return rest.density * rest.sound_speed * rest.sound_speed * eta / (room * room);
  }

  // Sound speed at this density, m/s: c^2 = dp/drho; at rest where it is lower than rho_0. `Number`
  // is T or a SIMD register of it.
  template <class Number>
  KERF_FUNCTION Number sound_speed(const RestState<T>& rest, Number compression) const {
    const Number squeezed = maximum(compression, Number(0));
    const Number eta = squeezed / (Number(1) + squeezed);
    const Number steep = Number(slope) * eta;
    const Number room = Number(1) - steep;
    return Number(rest.sound_speed) * (Number(1) - eta) * square_root((Number(1) + steep) / room) /
           room;
  }

  // Stored energy per mass, J/kg: the integral of p / rho^2 d rho from rho_0.
  KERF_FUNCTION double energy(const RestState<T>& rest, double compression) const {
    const double s = slope, c = rest.sound_speed;
    const double steep = s * compression / (1.0 + compression);
    return c * c / (s * s) * (std::log1p(-steep) + steep / (1.0 - steep));
  }

  // Whether no pressure reaches this density.
  KERF_FUNCTION bool is_beyond(T compression) const {
    return !(slope * compression < T(1) + compression);
  }

  template <class Other>
  KERF_FUNCTION static ShockHugoniot from(const ShockHugoniot<Other>& other) {
    return {static_cast<T>(other.slope)};
  }
  bool operator==(const ShockHugoniot&) const = default;
};

}  // namespace kerf
