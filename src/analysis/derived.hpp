// SPDX-License-Identifier: Apache-2.0
// These numbers follow from a case before it runs: wave speeds, dimensionless groups, counts.
#pragma once

#include <cstddef>
#include <string>

#include "analysis/metric.hpp"

namespace kerf {

struct Body;
struct Case;
struct ParticleEstimate;

struct DerivedNumbers {
  // These are of the elastic body that the water meets first (analysis/target_body.hpp), or of the
  // first one without a jet; 0 if there is none.
  double bulk_modulus = 0.0;        // Pa, E / 3(1 - 2 nu)
  double shear_modulus = 0.0;       // Pa, E / 2(1 + nu)
  double bulk_speed = 0.0;          // m/s, sqrt(K / rho), the c of eq. (32)
  double longitudinal_speed = 0.0;  // m/s, c_p = sqrt((K + 4G/3) / rho)
  double shear_speed = 0.0;         // m/s, c_s
  double rayleigh_speed = 0.0;      // m/s, c_R, root of the Rayleigh equation
  // s, 2 L / c_p: time until the first wave returns from an edge of the solid beside the jet that
  // does not absorb; 0 if there is no such edge.
  double reflection_time = 0.0;
  double jet_speed = 0.0;          // m/s, fastest water of a jet; else fastest initial body speed
  double water_sound_speed = 0.0;  // m/s, numerical
  double mach = 0.0;               // V / c of the water
  bool water_is_weakly_compressible = true;  // by its equation of state
  double speed_over_rayleigh = 0.0;          // V / c_R
  double speed_over_longitudinal = 0.0;      // V / c_p
  double cauchy_number = 0.0;                // rho_water V^2 / E
  double stagnation_pressure = 0.0;          // Pa, rho V^2 / 2
  double hammer_pressure_numerical = 0.0;    // Pa, rho U V with the run's shock
  double hammer_pressure_real = 0.0;         // Pa, with c = 1481 m/s
  double contact_stress = 0.0;               // Pa, V Z1 Z2 / (Z1 + Z2)
  double hydrodynamic_front_speed = 0.0;     // m/s, V / (1 + sqrt(rho_t / rho_j))
  double jet_resolution = 0.0;               // width / spacing of the coarsest jet
  double failure_strain = 0.0;               // of the solid, by its fracture energy if it has one
  double resistance = 0.0;                   // Pa, least stress at which the solid gives way
  double solid_to_water_spacing = 0.0;       // largest solid spacing over smallest water spacing
  std::size_t particles_initial = 0;
  std::size_t particles_elastic = 0;   // of them, in solids
  std::size_t particles_jittered = 0;  // and of these, off the lattice
  std::size_t particles_expected = 0;  // most at one time, with water of jets
  std::size_t particles_likely = 0;    // until the likely end
  double particles_mean = 0.0;         // until then
  double time_step = 0.0;              // s, estimate from the acoustic limit
  double likely_end = 0.0;             // s, at most the end of the case
  double likely_share = 1.0;           // of the time of the case until then
  double steps = 0.0;                  // until then
  double particle_memory = 0.0;        // bytes, estimate, of the engine for its particles
  double memory = 0.0;                 // bytes, of the process of a run at its peak
  // "no jet", "nothing to cut", "elastic dimple", "crack-led", "erosion", "hydrodynamic"
  std::string regime;

  // Returns the metrics of these numbers that result.json contains.
  static const MetricList<DerivedNumbers>& metrics();
};

// Takes a bounded time and memory, whatever the size of the case: particles are not laid out.
DerivedNumbers derive(const Case& description);

// Returns the numbers of particles of a body, without those beyond symmetry planes.
ParticleEstimate estimated_particles(const Case& description, const Body& body);

}  // namespace kerf
