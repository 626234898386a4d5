// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/jet_axis.hpp"
#include "app/check_warnings.hpp"
#include "app/jet_way.hpp"
#include "core/error.hpp"
#include "geometry/jet_direction.hpp"
#include "geometry/particle_estimate.hpp"
#include "input/parse_toml.hpp"
#include "materials/elastic_moduli.hpp"
#include "model/case.hpp"
#include "output/crushing.hpp"
#include "output/readable.hpp"
#include "output/solid_flags.hpp"

namespace kerf {

namespace {

constexpr double most_bonded = 1e5;  // particles of solids whose bonds are found within a second

// Whether a body is a box of so many rows of particles that each has neighbours on both sides.
bool is_thick_box(const Body& body, int dimension) {
  constexpr double rows = 4.0;
  if (body.shape.kind != Shape::Kind::box || body.jitter > 0.0) return false;
  const double coarsest = std::ldexp(body.spacing, body.grading.levels);
  for (std::size_t a = 0; a < static_cast<std::size_t>(dimension); ++a)
    if (body.shape.box.maximum[a] - body.shape.box.minimum[a] < rows * coarsest) return false;
  return true;
}

// Returns a body onto which a jet pushes another: one that reaches deeper along the jet.
const Body* body_behind(const Case& description, const Body& pushed, const Jet& jet) {
  const JetAxis axis(jet, description.dimension);
  const double face = Depths(pushed, axis, description.dimension).least;
  for (const Body& body : description.bodies) {
    const bool is_other = &body != &pushed && body.role != Role::water;
    const bool is_joined = body.joined_to == pushed.name || pushed.joined_to == body.name;
    if (is_other && !is_joined && Depths(body, axis, description.dimension).greatest > face)
      return &body;
  }
  return nullptr;
}

// Warns of a jet that presses a solid through the body behind it: contact yields to a pressure
// beyond M (docs/theory/solid_contact.md).
void warn_of_pressing(const Case& description, const Jet& jet, std::vector<std::string>& warnings) {
  const double pressure = stagnation_pressure(description, jet);
  for (const Body& body : description.bodies) {
    if (body.role != Role::elastic || body.fixed) continue;
    const Material& material = description.materials[static_cast<std::size_t>(body.material)];
    const auto moduli = ElasticModuli<double>::of(material.youngs_modulus, material.poisson_ratio);
    const double stiffness = moduli.bulk_modulus + 4.0 / 3.0 * moduli.shear_modulus;
    if (!(pressure > stiffness)) continue;
    const bool is_met = traverse_speed(jet) > 0.0 || is_in_way(jet, body, description.dimension);
    const Body* behind = is_met ? body_behind(description, body, jet) : nullptr;
    if (behind == nullptr) continue;
    warnings.push_back(fmt::format(
        "the jet \"{}\" has a stagnation pressure of {}, more than the stiffness of \"{}\", "
        "K + 4 G / 3 = {}: it may press it through \"{}\", because the contact of solids yields "
        "beyond that (docs/theory/solid_contact.md). Use a slower jet, a stiffer material, or look "
        "at the frames and the flag pressed_into_rigid before relying on the result",
        jet.name, readable(pressure, "Pa"), body.name, readable(stiffness, "Pa"), behind->name));
  }
}

// Warns of a jet that fails a solid by its pressure alone, whatever its fracture criterion.
void warn_of_crushing(const Case& description, const Jet& jet, std::vector<std::string>& warnings) {
  for (const Body& body : description.bodies) {
    const auto crushing = crushing_of(description, body, jet);
    if (!crushing) continue;
    if (traverse_speed(jet) > 0.0 || is_in_way(jet, body, description.dimension))
      warnings.push_back(crushing_sentence(description, body, jet, *crushing));
  }
}

}  // namespace

std::vector<LooseParticles> quick_loose_particles(const Case& description) {
  const bool all_are_thick =
      std::all_of(description.bodies.begin(), description.bodies.end(), [&](const Body& body) {
        return body.role != Role::elastic || is_thick_box(body, description.dimension);
      });
  if (all_are_thick) return {};
  // A layout that is fitted to the surface has other loose particles than its lattice.
  double particles = 0.0;
  for (const Body& body : description.bodies) {
    if (body.role != Role::elastic) continue;
    particles += estimate_particles(body, description.dimension, {}).total();
    if (body.shape.kind == Shape::Kind::mesh) return {};  // whether a point is inside takes long
  }
  return particles > most_bonded ? std::vector<LooseParticles>() : loose_particles(description);
}

std::vector<LooseParticles> refuse_unbonded(const Case& description, const std::string& text,
                                            const std::string& file) {
  std::vector<LooseParticles> found = quick_loose_particles(description);
  const auto loose = loose_body(description, found);
  if (loose)
    throw UserError(fmt::format("{}:{}: {}.", file, line_of_key(text, loose->key), loose->sentence),
                    exit_bad_input);
  return found;
}

std::vector<std::string> solid_warnings(const Case& description,
                                        const std::vector<LooseParticles>& loose) {
  std::vector<std::string> warnings;
  if (description.formulation != Formulation::standard) return warnings;
  refuse_loose_bodies(description, loose);
  for (const LooseParticles& body : loose) warnings.push_back(loose_sentence(description, body));
  for (const Jet& jet : description.jets) {
    warn_of_pressing(description, jet, warnings);
    warn_of_crushing(description, jet, warnings);
  }
  return warnings;
}

}  // namespace kerf
