// SPDX-License-Identifier: Apache-2.0
#include "app/check_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/fill.hpp"
#include "geometry/particle_estimate.hpp"
#include "geometry/shapes.hpp"
#include "geometry/surface_fit.hpp"
#include "input/material_library.hpp"
#include "kernels/wendland_c2.hpp"
#include "machine/characteristic_speed.hpp"
#include "model/calibration_need.hpp"
#include "model/case.hpp"
#include "model/material_laws.hpp"

namespace kerf {

namespace {

// Warns if the mass of a body differs from that of its shape because the lattice does not fit. A
// graded body has the mass of the uniform one.
void warn_of_misfits(const Case& description, std::vector<std::string>& warnings) {
  constexpr double noticeable = 0.02;
  for (const Body& body : description.bodies) {
    Body uniform = body;
    uniform.grading = {};
    const ParticleEstimate estimate = estimate_particles(uniform, description.dimension);
    const bool is_counted = estimate.is_exact || body.shape.kind == Shape::Kind::box;
    if (!is_counted) continue;  // many particles in a round or composed shape fit well
    if (shares_volume(body, description.dimension)) continue;
    const double filled = estimate.total() * particle_volume(body, description.dimension);
    const double misfit = filled / volume_estimate(body.shape, description.dimension) - 1.0;
    if (std::abs(misfit) > noticeable)
      warnings.push_back(
          fmt::format("the particles of \"{}\" fill {:.1f}% {} than its shape: a smaller spacing, "
                      "or edges that "
                      "are multiples of the spacing, fit better",
                      body.name, 100.0 * std::abs(misfit), misfit > 0.0 ? "more" : "less"));
  }
}

// The stress of a crack falls to zero at an opening of 2 Gc / (E e_0); e_0 is that of the material,
// or follows from the spacing.
void warn_of_wide_opening(const Material& material, const Body& body, const FractureLimits& limits,
                          std::vector<std::string>& warnings) {
  const Box box = bounding_box(body.shape, 3);
  double longest = 0.0;
  for (std::size_t a = 0; a < 3; ++a) longest = std::max(longest, box.maximum[a] - box.minimum[a]);
  const double opening = softening_band_width * body.spacing * limits.end;
  if (opening <= longest) return;
  const char* remedy =
      material.failure_strain > 0.0 ? "higher failure_strain" : "smaller spacing of the body";
  warnings.push_back(
      fmt::format("a crack in \"{}\" is complete when it has opened by {:.3g} m, more than the "
                  "body is long ({:.3g} m): tension alone parts it nowhere. A {} or a lower "
                  "fracture_energy of \"{}\" makes cracks",
                  body.name, opening, longest, remedy, material.name));
}

void warn_of_band(const Material& material, const Body& body, std::vector<std::string>& warnings) {
  const FractureLimits limits = fracture_limits(material, body.spacing);
  if (limits.softens()) return warn_of_wide_opening(material, body, limits, warnings);
  const double ratio = limits.end / material.failure_strain;
  warnings.push_back(fmt::format(
      "at the spacing of \"{}\" its material \"{}\" does not soften but breaks at {:.2g} of "
      "its failure_strain: a spacing of {:.3g} m or less keeps both its limits",
      body.name, material.name, ratio, body.spacing * ratio * ratio));
}

// Warns if ten times the jet speed exceeds the sound speed of real water, so that the pressures of
// impacts are too high.
void warn_of_fast_water(const Case& description, const DerivedNumbers& numbers,
                        std::vector<std::string>& warnings) {
  constexpr double same = 0.05;
  const double c = numbers.water_sound_speed;
  if (c == 0.0 || numbers.jet_speed <= fast_water || !numbers.water_is_weakly_compressible) return;
  if (std::abs(c / real_water_sound_speed - 1.0) < same) return;
  const bool standard = description.formulation == Formulation::standard;
  warnings.push_back(fmt::format(
      "the sound speed of the water, {:.4g} m/s, is artificial at {:.4g} m/s: above {:g} m/s "
      "give it that of real water, {}",
      c, numbers.jet_speed, fast_water,
      standard ? "equation_of_state = \"shock_hugoniot\""
               : fmt::format("sound_speed = \"{:g} m/s\"", real_water_sound_speed)));
}

// Warns of water that is faster than those shocks with which its equation of state is compared.
void warn_of_extrapolated_water(const DerivedNumbers& numbers, std::vector<std::string>& warnings) {
  if (numbers.water_sound_speed == 0.0 || numbers.jet_speed <= fastest_compared_water) return;
  warnings.push_back(fmt::format(
      "the fastest jet or body moves at {:.4g} m/s: shocks of water are compared with data "
      "(IAPWS-95) up to {:g} m/s (docs/theory/water_equation_of_state.md), the pressures of faster "
      "impacts are extrapolated. Lower the speed, or do not rely on them",
      numbers.jet_speed, fastest_compared_water));
}

// Warns of plane probes within the reach of a rigid body that is not wholly on the side of the
// normal: forces on rigid bodies are not among those that a plane measures.
void warn_of_planes_at_walls(const Case& description, std::vector<std::string>& warnings) {
  double widest = 0.0;
  for (const Jet& jet : description.jets) widest = std::max(widest, jet.spacing);
  for (const Body& body : description.bodies) widest = std::max(widest, body.spacing);
  const double reach = WendlandC2<2>::support * description.smoothing_ratio * widest;
  for (const Probe& probe : description.probes)
    for (const Body& body : description.bodies) {
      if (!probe.is_plane() || body.role != Role::rigid) continue;
      bool found = false;
      LatticeVisit request;
      request.window = bounding_box(body.shape, description.dimension);
      request.visit = [&](const Point& point) {
        double above = 0.0;
        for (std::size_t a = 0; a < 3; ++a)
          above += (point[a] - probe.position[a]) * probe.normal[a];
        found = above <= 0.0 && above > -reach;
        return !found;
      };
      visit_sample(body, description.dimension, request, most_tested);
      if (!found) continue;
      const auto index = &probe - description.probes.data();
      warnings.push_back(fmt::format(
          "probe[{}].normal (\"{}\"): the plane leaves out the forces on the rigid body \"{}\", "
          "which is within {:.3g} m of it on the side away from the normal. For the force on the "
          "body put the plane in its face, with the normal into the body; force_rigid in "
          "series.csv "
          "is that on all rigid bodies",
          index + 1, probe.name, body.name, reach));
    }
}

// Returns where the library tells the known values of a material, in brackets; a case may have
// materials of its own.
std::string place_of_known_values(const Material& material) {
  const bool is_known = find_library_material(material.name) != nullptr;
  return fmt::format(" ({} lists known values)",
                     is_known ? "kerf materials " + material.name : "kerf materials NAME");
}

// Warns if a case with a jet has no body that can be cut.
void warn_of_nothing_to_cut(const Case& description, std::vector<std::string>& warnings) {
  if (description.jets.empty()) return;
  bool has_workpiece = false;
  for (const Body& body : description.bodies) {
    if (body.role != Role::elastic) continue;
    has_workpiece = true;
    const Material& material = description.materials[static_cast<std::size_t>(body.material)];
    if (!body.fixed && !material.can_break())
      warnings.push_back(fmt::format(
          "\"{}\" never breaks: its material \"{}\" has no failure_strain, fracture_energy or "
          "tensile_strength. The jet can only dent it, beyond the strength of a real material; "
          "give the "
          "material a measured one of them{}",
          body.name, material.name, place_of_known_values(material)));
  }
  if (!has_workpiece)
    warnings.emplace_back(
        "there is a jet but nothing that it can cut: add a [[body]] with a solid material");
}

void warn_of_materials(const Case& description, std::vector<std::string>& warnings) {
  for (const Body& body : description.bodies) {
    if (body.role != Role::elastic) continue;
    const Material& material = description.materials[static_cast<std::size_t>(body.material)];
    if (material.criterion == BondCriterion::crack_band ||
        material.criterion == BondCriterion::brittle_band) {
      warn_of_band(material, body, warnings);
      continue;
    }
    if (material.failure_strain <= 0.0) continue;  // a fracture energy sets a length scale
    warnings.push_back(fmt::format(
        "\"{}\" fractures at a strain without a length scale: the energy of the cut depends on "
        "the spacing",
        material.name));
    return;
  }
}

}  // namespace

std::vector<std::string> check_warnings(const Case& description, const DerivedNumbers& numbers) {
  return check_warnings(description, numbers, quick_loose_particles(description));
}

std::vector<std::string> check_warnings(const Case& description, const DerivedNumbers& numbers,
                                        const std::vector<LooseParticles>& loose) {
  constexpr double weakly_compressible = 0.11;
  std::vector<std::string> warnings;
  if (numbers.solid_to_water_spacing > 1.0 && description.jets.empty())
    warnings.push_back(fmt::format(
        "the solid's spacing is {:.3g} x the water's: water can pass between solid particles",
        numbers.solid_to_water_spacing));
  const bool may_be_stiffer =
      numbers.jet_speed <= fast_water;  // otherwise it has the real sound speed
  if (may_be_stiffer && numbers.water_is_weakly_compressible && numbers.mach > weakly_compressible)
    warnings.push_back(
        fmt::format("the Mach number is {:.3g}: above 0.1 the water is compressed noticeably, "
                    "give it a higher sound speed",
                    numbers.mach));
  warn_of_fast_water(description, numbers, warnings);
  warn_of_extrapolated_water(numbers, warnings);
  if (description.back_flow_removal)
    warnings.emplace_back("the back-flow removal removes mass and momentum");
  warn_of_nothing_to_cut(description, warnings);
  for (auto& warning : aim_warnings(description)) warnings.push_back(std::move(warning));
  for (auto& warning : solid_warnings(description, loose)) warnings.push_back(std::move(warning));
  for (auto& warning : strength_warnings(description)) warnings.push_back(std::move(warning));
  warn_of_materials(description, warnings);
  if (std::string need = calibration_need(description); !need.empty())
    warnings.push_back(std::move(need));
  warn_of_planes_at_walls(description, warnings);
  warn_of_misfits(description, warnings);
  for (auto& warning : cut_warnings(description)) warnings.push_back(std::move(warning));
  return warnings;
}

}  // namespace kerf
