// SPDX-License-Identifier: Apache-2.0
#include "simulation/media.hpp"

#include <cmath>
#include <map>
#include <string>

#include "core/error.hpp"
#include "geometry/fill.hpp"
#include "geometry/graded_fill.hpp"
#include "geometry/surface_fit.hpp"
#include "model/case.hpp"
#include "model/material_laws.hpp"
#include "simulation/media_order.hpp"

namespace kerf {
namespace {

// The exponent n of detached solid is that of water. Solids have 3 to 7; it determines how much the
// stiffness exceeds K at pressures of the order of K.
constexpr double detached_exponent = 7.0;

void set_material(Medium<double>& medium, const Material& material) {
  medium.density = material.density;
  medium.artificial_linear = material.artificial_linear;
  medium.artificial_quadratic = material.artificial_quadratic;
  medium.artificial_softening = material.artificial_softening;
  if (material.kind == MaterialKind::water) {
    medium.phase = Phase::water;
    medium.viscosity = material.viscosity;
    medium.sound_speed = material.sound_speed;
    medium.longitudinal_speed = material.sound_speed;
    static_cast<EquationOfStateSet<double>&>(medium) = *material.laws;
    medium.equation_of_state = material.equation_of_state;
    return;
  }
  medium.phase = Phase::solid;
  static_cast<ElasticModuli<double>&>(medium) =
      ElasticModuli<double>::of(material.youngs_modulus, material.poisson_ratio);
  static_cast<ElasticLawSet<double>&>(medium) = *material.laws;
  static_cast<BondCriterionSet<double>&>(medium) = *material.laws;
  medium.total_bulk_modulus = medium.bulk_modulus;
  medium.friction = material.friction;
  medium.elasticity = material.elasticity;
  medium.criterion = material.criterion;
  medium.strength_rate = material.laws->strength_rate;
  medium.plastic = plastic_parameters(material);
  medium.sound_speed = std::sqrt(medium.bulk_modulus / material.density);
  medium.tait = {detached_exponent, medium.bulk_modulus / detached_exponent};
  medium.longitudinal_speed =
      std::sqrt((medium.bulk_modulus + 4.0 / 3.0 * medium.shear_modulus) / material.density);
}

// Parameters that the chosen laws derive from the body.
void derive_parameters(Medium<double>& medium, int dimension, std::uint64_t seed) {
  const BodyNumbers body{dimension,          medium.density,
                         medium.sound_speed, medium.longitudinal_speed,
                         medium.volume,      seed};
  if (medium.phase == Phase::water) {
    EquationOfStateSet<double>::for_each([&]<auto law>(std::string_view) {
      DeriveParameters{body}(medium.*law);
    });
    return;
  }
  ElasticLawSet<double>::visit(medium, medium.elasticity, DeriveParameters{body});
  BondCriterionSet<double>::visit(medium, medium.criterion, DeriveParameters{body});
  medium.plastic.derive(body);
}

// Returns the volume of a particle of a body that has so many, m^3 (2D: m^2).
double volume_of_each(const Body& body, int dimension, std::size_t particles) {
  return particles > 0 && shares_volume(body, dimension)
             ? fitted_volume(body, dimension) / static_cast<double>(particles)
             : particle_volume(body, dimension);
}

Medium<double> body_medium(const Case& description, const Body& body, std::size_t particles,
                           std::uint16_t piece) {
  Medium<double> medium;
  if (body.role == Role::rigid) {
    medium.phase = Phase::rigid;
    medium.repulsion = body.repulsion;
    medium.friction = body.friction;
  } else {
    const auto& material = description.materials.at(static_cast<std::size_t>(body.material));
    set_material(medium, material);
    const FractureLimits limits = fracture_limits(material, body.spacing);
    medium.failure_strain = limits.end;
    medium.softening_strain = limits.softens() ? limits.start : 0.0;
    medium.confinement = limits.confinement;
  }
  medium.volume = volume_of_each(body, description.dimension, particles);
  if (body.role != Role::rigid) derive_parameters(medium, description.dimension, body.seed);
  if (body.pressure > 0.0) {
    medium.initial_compression = medium.tait.compression(body.pressure);
    medium.volume *= 1.0 + medium.initial_compression;
  }
  medium.mass = medium.density * medium.volume;
  medium.spacing = body.spacing;
  medium.piece = piece;
  medium.constrained = body.fixed || !body.displacement[0].empty() || body.role == Role::rigid;
  return medium;
}

Medium<double> jet_medium(const Case& description, const Jet& jet, const Nozzle& nozzle) {
  Medium<double> medium;
  set_material(medium, description.materials.at(static_cast<std::size_t>(jet.material)));
  derive_parameters(medium, description.dimension, 0);
  medium.mass = nozzle.particle_mass();
  medium.volume = medium.mass / medium.density;
  medium.spacing = jet.spacing;
  return medium;
}

}  // namespace

std::vector<std::uint16_t> pieces_of(const std::vector<Body>& bodies) {
  std::map<std::string, std::size_t> by_name;
  for (std::size_t b = 0; b < bodies.size(); ++b) by_name[bodies[b].name] = b;
  std::vector<std::uint16_t> piece(bodies.size());
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    std::size_t root = b;
    for (std::size_t hop = 0; hop < bodies.size() && !bodies[root].joined_to.empty(); ++hop)
      root = by_name.at(bodies[root].joined_to);
    piece[b] = static_cast<std::uint16_t>(root);
  }
  return piece;
}

std::vector<Medium<double>> make_media(const Case& description, const std::vector<Nozzle>& nozzles,
                                       const std::vector<std::size_t>& particles) {
  require(nozzles.size() == description.jets.size(), "one nozzle per jet");
  std::vector<Medium<double>> media;
  const auto pieces = pieces_of(description.bodies);
  const std::size_t bodies = description.bodies.size();
  for (const auto [source, level] : medium_origins(description)) {
    if (source < bodies) {
      media.push_back(body_medium(description, at_level(description.bodies[source], level),
                                  particles[source], pieces[source]));
      media.back().level = static_cast<std::uint8_t>(level);
    } else {
      media.push_back(
          jet_medium(description, description.jets[source - bodies], nozzles[source - bodies]));
    }
  }
  for (Medium<double>& medium : media) {
    medium.smoothing_length = description.smoothing_ratio * medium.spacing;
    if (medium.phase == Phase::solid && description.formulation == Formulation::standard) {
      medium.excess_bulk_modulus =
          medium.total_bulk_modulus -
          bond_bulk_modulus(medium.total_bulk_modulus, medium.shear_modulus);
      medium.bulk_modulus = medium.total_bulk_modulus - medium.excess_bulk_modulus;
      // The yield surface of a solid that flows bounds the tension that its bonds bear.
      if (!medium.plastic.flows())
        medium.tensile_excess =
            tensile_excess_modulus(medium.total_bulk_modulus, medium.shear_modulus);
    }
    medium.cavitates =
        medium.phase != Phase::rigid && description.formulation == Formulation::standard;
  }
  return media;
}

}  // namespace kerf
