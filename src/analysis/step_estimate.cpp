// SPDX-License-Identifier: Apache-2.0
#include "analysis/step_estimate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/joint_step.hpp"
#include "materials/elastic_moduli.hpp"
#include "model/case.hpp"
#include "model/material_laws.hpp"
#include "solid/joint_courant.hpp"

namespace kerf {

namespace {

// Returns the sound speed of water behind a shock that leaves it at the speed u, m/s: that of real
// shocks rises with their pressure, that of weakly compressible water hardly does.
double sound_speed_behind(const Material& water, double u) {
  const auto& law = water.laws->shock_hugoniot;
  if (water.equation_of_state != EquationOfState::shock_hugoniot) return water.sound_speed;
  const RestState<double> rest{water.density, water.sound_speed};
  const double eta = u / (water.sound_speed + law.slope * u);
  return law.sound_speed(rest, eta / (1.0 - eta));
}

// How fast the water of a case moves, and how much a shock changes its speed, m/s.
struct Impact {
  double speed = 0.0;
  double shock = 0.0;
};

// Returns the largest speed of the water of a case, m/s: it moves along with its nozzle.
double fastest_water_of(const Case& description, const DerivedNumbers& numbers) {
  double fastest = numbers.jet_speed;
  for (const Jet& jet : description.jets)
    fastest = std::max(fastest, std::hypot(jet.speed, jet.traverse[0], jet.traverse[2]));
  return fastest;
}

// The impedances of water and solid determine the shock, V Z_s / (Z_s + Z_w). A solid whose waves
// are slower than the front of the jet is compacted until it stops the water as a wall does.
Impact impact_of(const DerivedNumbers& numbers, const MeetingMaterials& meeting) {
  const auto [water, solid] = meeting;
  Impact impact{numbers.jet_speed, numbers.jet_speed};
  if (!water || !solid || numbers.hydrodynamic_front_speed > numbers.longitudinal_speed)
    return impact;
  const double solid_impedance = solid->density * numbers.longitudinal_speed;
  const double water_impedance = water->density * water->sound_speed;
  impact.shock *= solid_impedance / (solid_impedance + water_impedance);
  return impact;
}

// Returns the acoustic limit of the time step, s, with its term of artificial viscosity: courant
// h / (c + V + 1.2 A c). The water is that behind the strongest shock of the case.
double acoustic_step(const Case& description, const Material& material, double spacing,
                     const Impact& impact) {
  double sound_speed = material.sound_speed;
  double fastest_wave = sound_speed_behind(material, impact.shock);
  if (material.kind == MaterialKind::elastic) {
    const auto moduli = ElasticModuli<double>::of(material.youngs_modulus, material.poisson_ratio);
    sound_speed = std::sqrt(moduli.bulk_modulus / material.density);
    fastest_wave =
        std::sqrt((moduli.bulk_modulus + 4.0 / 3.0 * moduli.shear_modulus) / material.density);
  }
  return description.time.courant * description.smoothing_ratio * spacing /
         (fastest_wave + impact.speed + 1.2 * material.artificial_linear * sound_speed);
}

// Returns the shortest estimate for the joints of unlike bodies, s; infinity without any.
double step_of_joints(const Case& description) {
  double step = std::numeric_limits<double>::infinity();
  if (description.formulation != Formulation::standard) return step;
  for (const Body& body : description.bodies)
    for (const Body& other : description.bodies)
      if (!body.joined_to.empty() && other.name == body.joined_to &&
          body.material != other.material)
        step = std::min(step, joint_step(description, body, other));
  return std::min(1.0, description.time.courant / joint_courant) * step;
}

}  // namespace

double estimated_step(const Case& description, const DerivedNumbers& numbers,
                      const MeetingMaterials& meeting) {
  double step = std::min(description.time.maximum_step, description.time.end);
  Impact impact = impact_of(numbers, meeting);
  impact.speed = fastest_water_of(description, numbers);
  const auto limit = [&](int material, double spacing) {
    step = std::min(
        step, acoustic_step(description, description.materials[static_cast<std::size_t>(material)],
                            spacing, impact));
  };
  for (const Body& body : description.bodies)
    if (body.role != Role::rigid) limit(body.material, body.spacing);
  for (const Jet& jet : description.jets) limit(jet.material, jet.spacing);
  return std::min(step, step_of_joints(description));
}

}  // namespace kerf
