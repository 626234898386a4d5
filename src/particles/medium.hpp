// SPDX-License-Identifier: Apache-2.0
// What all particles of one body or one jet share, as the loops need it.
#pragma once

#include <cstdint>

namespace kerf {

enum class Phase : std::uint8_t { water, solid, rigid };

template <class T>
struct Medium {
  Phase phase = Phase::water;
  bool constrained = false;    // fixed, or moved by prescription
  bool cavitates = false;      // water that opens instead of being pulled
  std::uint16_t piece = 0;     // solids of one piece hold together; different pieces only touch
  T spacing = 0;               // m
  T smoothing_length = 0;      // m
  T mass = 0;                  // kg per particle (2D: kg/m)
  T volume = 0;                // m^3 per particle as laid out (2D: m^2)
  T density = 0;               // kg/m^3, reference
  T sound_speed = 0;           // m/s, the c of eqs. (18) and (32)
  T longitudinal_speed = 0;    // m/s, fastest wave: c_p in a solid, c in water
  T tait_coefficient = 0;      // Pa, B of eq. (15)
  T tait_exponent = 0;         // 1
  T viscosity = 0;             // Pa s
  T bulk_modulus = 0;          // Pa
  T shear_modulus = 0;         // Pa
  T failure_strain = 0;        // 1; 0 = never fractures
  T artificial_linear = 0;     // A of eq. (38)
  T artificial_quadratic = 0;  // B of eq. (38)
  T artificial_softening = 0;  // C of eq. (39)
  T repulsion = 0;             // m^2/s^2, D of eq. (43)
};

}  // namespace kerf
