// SPDX-License-Identifier: Apache-2.0
// This file computes the numbers that follow from a case before it runs.
#include "analysis/derived.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "analysis/hydrodynamic_front.hpp"
#include "analysis/regime.hpp"
#include "analysis/step_estimate.hpp"
#include "analysis/target_body.hpp"
#include "geometry/nozzle.hpp"
#include "geometry/particle_estimate.hpp"
#include "geometry/shapes.hpp"
#include "machine/characteristic_speed.hpp"
#include "machine/jet_water.hpp"
#include "machine/simulated_piece.hpp"
#include "model/case.hpp"
#include "model/material_laws.hpp"
#include "neighbours/skin.hpp"

namespace kerf {

namespace {

const Material& material_of(const Case& description, int index) {
  return description.materials[static_cast<std::size_t>(index)];
}

// Returns the water of the fastest jet, else of the first body of water.
const Material* water_material(const Case& description) {
  const auto speed = [&](const Jet& jet) { return fastest_water(jet, description.dimension); };
  const auto fastest =
      std::max_element(description.jets.begin(), description.jets.end(),
                       [&](const Jet& a, const Jet& b) { return speed(a) < speed(b); });
  if (fastest != description.jets.end()) return &material_of(description, fastest->material);
  for (const Body& body : description.bodies)
    if (body.role == Role::water) return &material_of(description, body.material);
  return nullptr;
}

// Returns the Rayleigh wave speed, m/s, from the root of Rayleigh's equation (2 - x)^2 = 4
// sqrt((1
// - x)(1 - k x)) between 0 and 1, with x = (c_R / c_s)^2 and k = (c_s / c_p)^2. x is 0.47 for nu
// = -1 and 0.91 for nu = 1/2.
double rayleigh_speed(double shear_speed, double longitudinal_speed) {
  const double k = std::pow(shear_speed / longitudinal_speed, 2);
  const auto residual = [k](double x) {
    return (2.0 - x) * (2.0 - x) - 4.0 * std::sqrt((1.0 - x) * (1.0 - k * x));
  };
  std::uintmax_t iterations = 100;
  const auto bracket = boost::math::tools::toms748_solve(
      residual, 0.3, 1.0, boost::math::tools::eps_tolerance<double>(50), iterations);
  return shear_speed * std::sqrt(0.5 * (bracket.first + bracket.second));
}

// The numbers of the body that the water meets first.
void derive_resistance(DerivedNumbers& numbers, const Case& description, const Body& body) {
  const Material& solid = material_of(description, body.material);
  numbers.failure_strain = fracture_limits(solid, body.spacing).start;
  numbers.resistance =
      resistance_of(solid, {numbers.failure_strain, body.spacing, description.dimension});
}

void derive_solid(DerivedNumbers& numbers, const Material& solid) {
  const double young = solid.youngs_modulus, poisson = solid.poisson_ratio;
  numbers.bulk_modulus = young / (3.0 * (1.0 - 2.0 * poisson));
  numbers.shear_modulus = young / (2.0 * (1.0 + poisson));
  numbers.bulk_speed = std::sqrt(numbers.bulk_modulus / solid.density);
  numbers.longitudinal_speed =
      std::sqrt((numbers.bulk_modulus + 4.0 / 3.0 * numbers.shear_modulus) / solid.density);
  numbers.shear_speed = std::sqrt(numbers.shear_modulus / solid.density);
  numbers.rayleigh_speed = rayleigh_speed(numbers.shear_speed, numbers.longitudinal_speed);
  numbers.speed_over_rayleigh = numbers.jet_speed / numbers.rayleigh_speed;
  numbers.speed_over_longitudinal = numbers.jet_speed / numbers.longitudinal_speed;
}

void derive_water(DerivedNumbers& numbers, const Material& water) {
  const double speed = numbers.jet_speed;
  numbers.water_sound_speed = water.sound_speed;
  numbers.mach = speed / water.sound_speed;
  numbers.stagnation_pressure = 0.5 * water.density * speed * speed;
  // U = c + s V, the speed of the shock; s is 0 in weakly compressible water.
  const double shock = water.sound_speed + water.laws->shock_hugoniot.slope * speed;
  numbers.hammer_pressure_numerical = water.density * shock * speed;
  numbers.water_is_weakly_compressible =
      is_weakly_compressible(*water.laws, water.equation_of_state);
  numbers.hammer_pressure_real = water.density * real_water_sound_speed * speed;
}

// Returns the distance, m, from the axis of the first jet to the nearest side of the bounding box
// that is neither absorbing nor a plane of symmetry; infinite where there is none.
double nearest_edge(const Case& description, const Body& body) {
  const Box box = bounding_box(body.shape, description.dimension);
  const Point& aim = description.jets.front().position;
  double nearest = std::numeric_limits<double>::infinity();
  for (const std::size_t a : {std::size_t(0), std::size_t(2)}) {
    if (a >= static_cast<std::size_t>(description.dimension)) break;
    if (aim[a] < box.minimum[a] || aim[a] > box.maximum[a])
      return nearest;  // the jet does not hit this body
    const double low = aim[a] - box.minimum[a], high = box.maximum[a] - aim[a];
    if (!body.absorbing.minimum[a] && !description.symmetry.minimum[a])
      nearest = std::min(nearest, low);
    if (!body.absorbing.maximum[a] && !description.symmetry.maximum[a])
      nearest = std::min(nearest, high);
  }
  return nearest;
}

void derive_reflection(DerivedNumbers& numbers, const Case& description) {
  if (description.jets.empty() || numbers.longitudinal_speed == 0.0) return;
  double nearest = std::numeric_limits<double>::infinity();
  for (const Body& body : description.bodies)
    if (body.role == Role::elastic && !body.fixed)
      nearest = std::min(nearest, nearest_edge(description, body));
  if (std::isfinite(nearest)) numbers.reflection_time = 2.0 * nearest / numbers.longitudinal_speed;
}

// Returns the mean speed over the section of the fastest jet, which its front follows, m/s.
double mean_speed(const DerivedNumbers& numbers, const Case& description) {
  double fastest = 0.0;
  for (const Jet& jet : description.jets) fastest = std::max(fastest, jet.speed);
  return fastest > 0.0 ? fastest : numbers.jet_speed;
}

// Stress of the first contact of water with a solid, or of a solid with the same solid: the
// impedances Z = rho c of both determine it.
void derive_contact(DerivedNumbers& numbers, const Case& description, const Material& solid,
                    const Material* water) {
  const double solid_impedance = solid.density * numbers.longitudinal_speed;
  const double other = water ? water->density * water->sound_speed : solid_impedance;
  numbers.contact_stress = numbers.jet_speed * solid_impedance * other / (solid_impedance + other);
  if (!water) return;
  numbers.cauchy_number =
      water->density * numbers.jet_speed * numbers.jet_speed / solid.youngs_modulus;
  numbers.hydrodynamic_front_speed =
      hydrodynamic_front_speed(mean_speed(numbers, description), solid.density, water->density);
}

void derive_spacings(DerivedNumbers& numbers, const Case& description) {
  double coarsest_solid = 0.0, finest_water = 0.0;
  const auto water = [&](double spacing) {
    finest_water = finest_water > 0.0 ? std::min(finest_water, spacing) : spacing;
  };
  for (const Body& body : description.bodies) {
    if (body.role == Role::elastic) coarsest_solid = std::max(coarsest_solid, body.spacing);
    if (body.role == Role::water) water(body.spacing);
  }
  for (const Jet& jet : description.jets) {
    water(jet.spacing);
    const double resolution = jet.width / jet.spacing;
    numbers.jet_resolution =
        numbers.jet_resolution > 0.0 ? std::min(numbers.jet_resolution, resolution) : resolution;
  }
  if (coarsest_solid > 0.0 && finest_water > 0.0)
    numbers.solid_to_water_spacing = coarsest_solid / finest_water;
}

// What the jets add. Water enters at a constant rate until as much leaves.
void derive_jet_water(DerivedNumbers& numbers, const Case& description) {
  double most = 0.0, likely = 0.0, mean = 0.0;
  for (const Jet& jet : description.jets) {
    most += most_jet_water(description, jet, description.time.end);
    const double held = most_jet_water(description, jet, numbers.likely_end);
    const double emitted = emitted_water(description, jet, numbers.likely_end);
    likely += held;
    if (emitted > 0.0) mean += held * (1.0 - 0.5 * held / emitted);
  }
  numbers.particles_expected = numbers.particles_initial + static_cast<std::size_t>(most);
  numbers.particles_likely = numbers.particles_initial + static_cast<std::size_t>(likely);
  numbers.particles_mean = static_cast<double>(numbers.particles_initial) + mean;
}

void derive_particles(DerivedNumbers& numbers, const Case& description) {
  for (const Body& body : description.bodies) {
    const auto count =
        static_cast<std::size_t>(std::llround(estimated_particles(description, body).total()));
    numbers.particles_initial += count;
    if (body.role != Role::elastic) continue;
    numbers.particles_elastic += count;
    if (body.jitter > 0.0) numbers.particles_jittered += count;
  }
  derive_jet_water(numbers, description);
}

// Returns the number of particles of a square or cubic lattice within a radius in spacings.
double particles_within(double spacings, int dimension) {
  return dimension == 2 ? std::numbers::pi * spacings * spacings
                        : 4.0 / 3.0 * std::numbers::pi * spacings * spacings * spacings;
}

// Returns how far the fastest jet moves in a step that is limited by its sound waves, in spacings.
double jet_step(const DerivedNumbers& numbers, const Case& description) {
  if (description.jets.empty()) return 0.0;
  return description.time.courant * description.smoothing_ratio * numbers.jet_speed /
         (numbers.water_sound_speed + numbers.jet_speed);
}

// Returns an estimate of the memory of the engine, bytes: fields and the data of pair loops; 4
// bytes for every neighbour within 2 h and the skin of the list, and an eighth as reserve. Solids
// with bonds have no lists of neighbours and further fields; their lists of bonds are small in
// regular layouts, which share them, and take 4 bytes per bond in others. In cases with solids all
// particles have fields for contact, and where water meets them, or beside symmetry planes, a
// record of 16 numbers for the pairs of both. A test compares the estimate with the heap.
double estimate_particle_memory(const DerivedNumbers& numbers, const Case& description) {
  const int dimension = description.dimension;
  const bool plane = dimension == 2, bonds = description.formulation == Formulation::standard;
  const double reach = 2.0 * description.smoothing_ratio,
               skin = list_skin(dimension, jet_step(numbers, description));  // spacings
  const bool single = description.precision == PrecisionKind::mixed;
  const double wider = single ? 1.0 : 1.75;  // positions are in double precision in both
  const auto all = static_cast<double>(numbers.particles_expected);
  const double bonded = bonds ? static_cast<double>(numbers.particles_elastic) : 0.0;
  const double contact = bonded > 0.0 ? (plane ? 48.0 : 64.0) : 0.0;
  const bool unlike =
      bonds && ((bonded > 0.0 && !description.jets.empty()) || description.symmetry.any());
  const double record = unlike ? (single ? 64.0 : 128.0) : 0.0;
  const double particle =
      record + wider * (contact + (bonds ? (plane ? 256.0 : 326.0) : (plane ? 286.0 : 404.0)));
  const double list = 4.5 * particles_within(reach + skin, dimension);
  const double solid = wider * (plane ? 195.0 : 280.0);
  const double jittered = bonds ? static_cast<double>(numbers.particles_jittered) : 0.0;
  const double bond_list = 4.0 * particles_within(reach, dimension);
  return all * particle + (all - bonded) * list + bonded * solid + jittered * bond_list;
}

// Returns an estimate of the memory of the process of a run at its peak, bytes: the program with
// its libraries, the data of the engine, and for each particle what frames, the measurements of the
// kerf and the report hold beside them when they are made. The two constants were fitted to the
// largest resident size of runs of 460 to 120 000 particles in 2D and 3D, which they give within
// 10% (docs/performance.md); a test compares them with one.
double process_memory(const DerivedNumbers& numbers) {
  constexpr double program = 65e6, output = 1600.0;  // bytes, and bytes per particle
  return program + numbers.particle_memory +
         output * static_cast<double>(numbers.particles_expected);
}

// Returns when the run is likely to end, s. One that ends once its part is passed does so early
// where the jet presses far harder than the solid resists: its front then has the speed of two
// streams.
double likely_end(const DerivedNumbers& numbers, const Case& description) {
  constexpr double dwarfs = 10.0;  // stagnation pressure over the resistance
  const double end = description.time.end;
  if (!description.workpiece || description.machine->motion != NozzleMotion::standing ||
      !(numbers.stagnation_pressure > dwarfs * numbers.resistance))
    return end;
  const Jet& jet = description.jets.back();
  const double last = last_front_depth(description);
  const double passed = std::isinf(last)
                            ? description.workpiece->size[1] / std::cos(jet.angle) +
                                  numbers.hydrodynamic_front_speed * description.time.after_cut
                            : last;
  const double front = numbers.hydrodynamic_front_speed * jet.duty;
  return std::min(end, jet.standoff / jet.speed + passed / front);
}

}  // namespace

ParticleEstimate estimated_particles(const Case& description, const Body& body) {
  constexpr double most_of_all = 1e6, least = 1e3;  // nodes to look at
  const double share = most_of_all / static_cast<double>(description.bodies.size());
  return estimate_particles(body, description.dimension, {description.symmetry, description.domain},
                            std::clamp(share, least, most_laid_nodes));
}

DerivedNumbers derive(const Case& description) {
  DerivedNumbers numbers;
  numbers.jet_speed = fastest_jet(description);
  if (numbers.jet_speed == 0.0) numbers.jet_speed = fastest_body(description);
  const Body* target = target_body(description);
  const Material* solid = target ? &material_of(description, target->material) : nullptr;
  const Material* water = water_material(description);
  if (solid) derive_solid(numbers, *solid);
  if (water) derive_water(numbers, *water);
  if (solid) derive_contact(numbers, description, *solid, water);
  derive_reflection(numbers, description);
  derive_spacings(numbers, description);
  if (target) derive_resistance(numbers, description, *target);
  numbers.likely_end = likely_end(numbers, description);
  if (description.time.end > 0.0) numbers.likely_share = numbers.likely_end / description.time.end;
  derive_particles(numbers, description);
  numbers.time_step = estimated_step(description, numbers, {water, solid});
  numbers.steps = std::ceil(numbers.likely_end / numbers.time_step);
  numbers.particle_memory = estimate_particle_memory(numbers, description);
  numbers.memory = process_memory(numbers);
  numbers.regime = description.jets.empty() ? "no jet"
                   : !solid                 ? "nothing to cut"
                                            : regime_of(numbers);
  return numbers;
}

}  // namespace kerf
