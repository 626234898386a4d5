// SPDX-License-Identifier: Apache-2.0
// A material as a case or the library describes it, as plain data in SI units.
#pragma once

#include <string>

#include "materials/laws.hpp"

namespace kerf {

enum class MaterialKind { elastic, water };

// Members of another kind or law keep their defaults and are not read.
struct Material {
  std::string name;
  MaterialKind kind = MaterialKind::water;
  std::string source;       // where the values come from
  double density = 1000.0;  // kg/m^3, reference

  // Solids.
  ElasticLaw elasticity = ElasticLaw::neo_hookean;
  PlasticLaw plasticity = PlasticLaw::none;
  BondCriterion criterion = BondCriterion::principal_strain;
  double youngs_modulus = 0.0;    // Pa
  double poisson_ratio = 0.0;     // 1
  double failure_strain = 0.0;    // 1, of the criterion; 0 = never fractures
  double tensile_strength = 0.0;  // Pa, of the criterion principal_stress
  double fracture_energy = 0.0;   // J/m^2 of crack; where it is given there is no failure_strain
  // Of the criterion grady_kipp: weibull_k strain^weibull_m flaws per volume.
  double weibull_k = 0.0;          // 1/m^3
  double weibull_m = 0.0;          // 1
  double crack_speed_share = 0.4;  // 1, of the longitudinal wave's speed
  double flaw_depth = 1.0;         // m, of a 2D slice

  double friction = 0.0;  // 1, coefficient of dry friction

  // Metals: von Mises with hardening, Johnson & Cook.
  double yield_strength = 0.0;         // Pa
  double hardening_modulus = 0.0;      // Pa
  double saturation_stress = 0.0;      // Pa
  double saturation_strain = 1.0;      // 1
  double hardening_coefficient = 0.0;  // Pa, B
  double hardening_exponent = 1.0;     // 1, n
  double rate_coefficient = 0.0;       // 1, C
  double reference_rate = 1.0;         // 1/s
  double thermal_exponent = 1.0;       // 1, m
  double heat_capacity = 0.0;          // J/(kg K); 0 = plastic work warms nothing
  double heat_share = 0.9;             // 1, of the plastic work
  double temperature = 0.0;            // K, at the start
  double reference_temperature = 0.0;  // K
  double melting_temperature = 0.0;    // K; 0 = temperature changes no strength
  double damage_d1 = 0.0;              // 1, D1 to D5 of Johnson & Cook (1985)
  double damage_d2 = 0.0;              // 1
  double damage_d3 = 0.0;              // 1
  double damage_d4 = 0.0;              // 1
  double damage_d5 = 0.0;              // 1
  double least_plastic_failure = 0.0;  // 1; 0 = no damage

  // Rock and soil: Drucker & Prager.
  double cohesion = 0.0;         // Pa
  double friction_angle = 0.0;   // rad
  double dilation_angle = 0.0;   // rad
  double tension_cut_off = 0.0;  // Pa; infinity = the apex of the cone

  // Water.
  EquationOfState equation_of_state = EquationOfState::tait;
  double viscosity = 0.0;       // Pa s
  double sound_speed = 0.0;     // m/s; resolved by the reader where it is not given
  double tait_exponent = 7.0;   // 1
  double hugoniot_slope = 0.0;  // 1, s of the shock speed c + s u

  double artificial_linear = 0.0;     // A of eq. (38)
  double artificial_quadratic = 0.0;  // B of eq. (38)
  double artificial_softening = 0.1;  // C of eq. (39)

  // Whether by a strain, an energy or ductile damage.
  bool can_fracture() const {
    return criterion == BondCriterion::grady_kipp || failure_strain > 0.0 ||
           fracture_energy > 0.0 || tensile_strength > 0.0 || least_plastic_failure > 0.0;
  }
  bool operator==(const Material&) const = default;
};

}  // namespace kerf
