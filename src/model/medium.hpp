// SPDX-License-Identifier: Apache-2.0
// A medium has the properties that all particles of one body or one jet share. The loops over
// particles, pairs and bonds read it.
#pragma once

#include <cmath>
#include <cstdint>

#include "core/host_device.hpp"
#include "core/mirror_planes.hpp"
#include "fracture/bond_criterion.hpp"
#include "materials/equation_of_state.hpp"
#include "materials/plastic_law.hpp"

namespace kerf {

enum class Phase : std::uint8_t { water, solid, rigid };

// NUMBER(name): meaning, unit.
#define KERF_MEDIUM_NUMBERS(NUMBER)                                                \
  NUMBER(spacing)              /* m */                                             \
  NUMBER(smoothing_length)     /* m */                                             \
  NUMBER(mass)                 /* kg per particle (2D: kg/m) */                    \
  NUMBER(volume)               /* m^3 per particle without pressure (2D: m^2) */   \
  NUMBER(longitudinal_speed)   /* m/s, fastest wave: c_p in a solid, c in water */ \
  NUMBER(initial_compression)  /* 1, as laid out */                                \
  NUMBER(viscosity)            /* Pa s */                                          \
  NUMBER(total_bulk_modulus)   /* Pa, K; bonds carry bulk_modulus of it */         \
  NUMBER(excess_bulk_modulus)  /* Pa, the part of K that acts by the density */    \
  NUMBER(tensile_excess)       /* Pa, that of an undamaged solid that expands */   \
  NUMBER(artificial_linear)    /* A of eq. (38), and of the bond viscosity */      \
  NUMBER(artificial_quadratic) /* B of eq. (38), and of the bond viscosity */      \
  NUMBER(artificial_softening) /* C of eq. (39) */                                 \
  NUMBER(friction)             /* 1, coefficient of dry friction */                \
  NUMBER(repulsion)            /* m^2/s^2, D of eq. (43) */

// Its bases hold the laws that it chooses: equation of state, elastic law, fracture criterion.
template <class T>
struct Medium : BarotropicMatter<T>, BondedSolid<T> {
  Phase phase = Phase::water;
  bool constrained = false;  // fixed, or moved by prescription
  std::uint8_t level = 0;    // of resolution; 0: the finest of its body
  std::uint16_t piece = 0;   // solids of one piece are bonded; different pieces are in contact
  // The symmetry planes that the initial layout of the piece touches: its mirror images at these
  // planes belong to the piece, those at other planes are other pieces.
  MirrorCode joined_mirrors = 0;
  PlasticParameters<T> plastic;
  T hourglass = T(0.5);  // zeta; 0 = no control. Why 0.5: docs/theory/total_lagrangian.md
#define KERF_NUMBER(name) T name = 0;
  KERF_MEDIUM_NUMBERS(KERF_NUMBER)
#undef KERF_NUMBER

  // Returns the reference volume of a particle of a solid, m^3 (2D: m^2).
  KERF_FUNCTION T reference_volume() const {
    return mass / this->density;
  }
  // Returns the P-wave modulus K + 4 G / 3 of a solid, Pa.
  KERF_FUNCTION T p_wave_modulus() const {
    return total_bulk_modulus + T(4) / T(3) * this->shear_modulus;
  }
  // Returns the modulus of the hourglass control, Pa.
  KERF_FUNCTION T hourglass_modulus() const {
    return hourglass * this->young_modulus();
  }
  // Returns the speed of longitudinal waves that bonds alone carry, m/s.
  KERF_FUNCTION T bond_wave_speed() const {
    return std::sqrt((this->bulk_modulus + T(4) / T(3) * this->shear_modulus) / this->density);
  }
  // Returns whether bonds can break, by the criterion or by ductile damage.
  KERF_FUNCTION bool can_break() const {
    return this->bonds_can_break() || plastic.can_break();
  }

  // Returns whether particles of this medium and of `other`, or the mirror images of the latter
  // (code not 0), belong to one piece.
  KERF_FUNCTION bool is_one_piece_with(const Medium& other, MirrorCode mirror) const {
    return piece == other.piece && (mirror & ~joined_mirrors) == 0;
  }

  template <class Other>
  static Medium from(const Medium<Other>& other) {
    Medium medium;
    static_cast<BarotropicMatter<T>&>(medium) = BarotropicMatter<T>::from(other);
    static_cast<BondedSolid<T>&>(medium) = BondedSolid<T>::from(other);
    medium.plastic = PlasticParameters<T>::from(other.plastic);
    medium.phase = other.phase;
    medium.constrained = other.constrained;
    medium.level = other.level;
    medium.piece = other.piece;
    medium.joined_mirrors = other.joined_mirrors;
    medium.hourglass = static_cast<T>(other.hourglass);
#define KERF_NUMBER(name) medium.name = static_cast<T>(other.name);
    KERF_MEDIUM_NUMBERS(KERF_NUMBER)
#undef KERF_NUMBER
    return medium;
  }
};

}  // namespace kerf
