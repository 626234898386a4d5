// SPDX-License-Identifier: Apache-2.0
// What all particles of one body or one jet share, as the loops need it.
#pragma once

#include <cstdint>

#include "core/mirror_planes.hpp"
#include "exec/host_device.hpp"
#include "materials/laws.hpp"

namespace kerf {

enum class Phase : std::uint8_t { water, solid, rigid };

// NUMBER(name): meaning, unit.
#define KERF_MEDIUM_NUMBERS(NUMBER)                                                           \
  NUMBER(spacing)              /* m */                                                        \
  NUMBER(smoothing_length)     /* m */                                                        \
  NUMBER(mass)                 /* kg per particle (2D: kg/m) */                               \
  NUMBER(volume)               /* m^3 per particle without pressure (2D: m^2) */              \
  NUMBER(density)              /* kg/m^3, reference */                                        \
  NUMBER(sound_speed)          /* m/s, the c of eqs. (18) and (32) */                         \
  NUMBER(longitudinal_speed)   /* m/s, fastest wave: c_p in a solid, c in water */            \
  NUMBER(tait_coefficient)     /* Pa, B of eq. (15) */                                        \
  NUMBER(tait_exponent)        /* 1, n */                                                     \
  NUMBER(initial_compression)  /* 1, as laid out */                                           \
  NUMBER(hugoniot_slope)       /* 1, s of the shock speed c + s u */                          \
  NUMBER(viscosity)            /* Pa s */                                                     \
  NUMBER(bulk_modulus)         /* Pa, K */                                                    \
  NUMBER(excess_bulk_modulus)  /* Pa, the part of K that acts by the density, not by bonds */ \
  NUMBER(shear_modulus)        /* Pa */                                                       \
  NUMBER(failure_strain)       /* 1; 0 = never fractures */                                   \
  NUMBER(softening_strain)     /* 1, where softening begins; 0 = brittle */                   \
  NUMBER(tensile_strength)     /* Pa; 0 = never fractures by stress */                        \
  NUMBER(artificial_linear)    /* A of eq. (38) */                                            \
  NUMBER(artificial_quadratic) /* B of eq. (38) */                                            \
  NUMBER(artificial_softening) /* C of eq. (39) */                                            \
  NUMBER(friction)             /* 1, coefficient of dry friction */                           \
  NUMBER(repulsion)            /* m^2/s^2, D of eq. (43) */

template <class T>
struct Medium {
  Phase phase = Phase::water;
  bool constrained = false;  // fixed, or moved by prescription
  bool cavitates = false;    // opens instead of being pulled once it holds on to nothing
  EquationOfState equation_of_state = EquationOfState::tait;  // of what has a density
  ElasticLaw elasticity = ElasticLaw::neo_hookean;
  BondCriterion criterion = BondCriterion::principal_strain;
  std::uint8_t level = 0;   // of resolution; 0: the finest of its body
  std::uint16_t piece = 0;  // solids of one piece hold together; different pieces only touch
  // The symmetry planes that the piece is laid out at: its mirror image is part of it there, beyond
  // other planes it is another piece.
  MirrorCode joined_mirrors = 0;
#define KERF_NUMBER(name) T name = 0;
  KERF_MEDIUM_NUMBERS(KERF_NUMBER)
#undef KERF_NUMBER

  // Pa, in a solid.
  KERF_FUNCTION T p_wave_modulus() const {
    return bulk_modulus + T(4) / T(3) * shear_modulus;
  }

  // Of K, the share that acts by the density: all of it in what is loose. Solids only.
  template <class Real>
  KERF_FUNCTION Real share_by_density(bool is_loose) const {
    return is_loose ? Real(1) : Real(excess_bulk_modulus) / Real(bulk_modulus);
  }

  // Whether particles of this medium and of `other`, the latter seen in a mirror or not (code 0),
  // belong to one piece.
  KERF_FUNCTION bool is_one_piece_with(const Medium& other, MirrorCode mirror) const {
    return piece == other.piece && (mirror & ~joined_mirrors) == 0;
  }

  template <class Other>
  static Medium from(const Medium<Other>& other) {
    Medium medium;
    medium.phase = other.phase;
    medium.constrained = other.constrained;
    medium.level = other.level;
    medium.cavitates = other.cavitates;
    medium.equation_of_state = other.equation_of_state;
    medium.elasticity = other.elasticity;
    medium.criterion = other.criterion;
    medium.piece = other.piece;
    medium.joined_mirrors = other.joined_mirrors;
#define KERF_NUMBER(name) medium.name = static_cast<T>(other.name);
    KERF_MEDIUM_NUMBERS(KERF_NUMBER)
#undef KERF_NUMBER
    return medium;
  }
};

}  // namespace kerf
