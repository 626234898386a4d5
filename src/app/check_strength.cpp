// SPDX-License-Identifier: Apache-2.0
// Warnings of solids whose strength or stiffness a run represents otherwise than a user may expect:
// brittle ones in compression, and soft layers between stiff bodies.
#include <fmt/format.h>

#include <algorithm>

#include "app/check_warnings.hpp"
#include "fracture/compressive_strength.hpp"
#include "geometry/shapes.hpp"
#include "materials/elastic_moduli.hpp"
#include "model/case.hpp"
#include "model/material_laws.hpp"
#include "output/readable.hpp"

namespace kerf {

namespace {

ElasticModuli<double> moduli_of(const Case& description, const Body& body) {
  const Material& material = description.materials[static_cast<std::size_t>(body.material)];
  return ElasticModuli<double>::of(material.youngs_modulus, material.poisson_ratio);
}

// Warns of a brittle solid that fails in compression as in tension (docs/theory/softening.md). Soft
// ones, which fail at large strains, do so in tests, too.
void warn_of_compression(const Case& description, const Body& body,
                         std::vector<std::string>& warnings) {
  constexpr double brittle = 0.02;  // failure strain
  const Material& material = description.materials[static_cast<std::size_t>(body.material)];
  const FractureLimits limits = fracture_limits(material, body.spacing);
  if (!limits.softens() || limits.start >= brittle || material.laws->compression.is_on()) return;
  const auto moduli = moduli_of(description, body);
  const double tension = moduli.young_modulus() * limits.start;
  warnings.push_back(fmt::format(
      "\"{}\" begins to fail in plain compression at {}, hardly more than its tensile strength of "
      "{}, because its material \"{}\" has no compressive_strength: concrete, glass and rock bear "
      "8 "
      "to 13 times their tensile strength. Give the compressive_strength of a test, or look at "
      "what "
      "the jet crushes before relying on it (docs/theory/softening.md)",
      body.name, readable(least_compressive_ratio(moduli) * tension, "Pa"), readable(tension, "Pa"),
      material.name));
}

// Returns how many rows of particles a body has across its thinnest side.
double rows_across(const Body& body, int dimension) {
  const Box box = bounding_box(body.shape, dimension);
  double least = box.maximum[0] - box.minimum[0];
  for (std::size_t a = 1; a < static_cast<std::size_t>(dimension); ++a)
    least = std::min(least, box.maximum[a] - box.minimum[a]);
  return least / body.spacing;
}

// Warns of a thin body that is joined to stiffer ones: it acts as if it was thinner
// (docs/bodies.md).
void warn_of_soft_layer(const Case& description, const Body& body,
                        std::vector<std::string>& warnings) {
  constexpr double contrast = 5.0, enough_rows = 16.0;
  const double rows = rows_across(body, description.dimension);
  if (rows >= enough_rows - 0.5) return;
  const auto stiffness = [&](const Body& of) {
    const auto moduli = moduli_of(description, of);
    return moduli.bulk_modulus + 4.0 / 3.0 * moduli.shear_modulus;
  };
  for (const Body& other : description.bodies) {
    const bool is_joined = other.joined_to == body.name || body.joined_to == other.name;
    if (!is_joined || other.role != Role::elastic) continue;
    const double ratio = stiffness(other) / stiffness(body);
    if (ratio < contrast) continue;
    warnings.push_back(fmt::format(
        "\"{}\" has {:.0f} rows of particles across and is joined to \"{}\", {:.3g} times as "
        "stiff: "
        "beside each such joint it acts as if it was up to 0.9 spacings thinner, and stresses "
        "there "
        "are wrong by tens of per cent (docs/bodies.md). Give it 16 rows or more, a spacing of {} "
        "or less",
        body.name, rows, other.name, ratio, readable(body.spacing * rows / enough_rows, "m")));
    return;
  }
}

}  // namespace

std::vector<std::string> strength_warnings(const Case& description) {
  std::vector<std::string> warnings;
  if (description.formulation != Formulation::standard) return warnings;
  for (const Body& body : description.bodies) {
    if (body.role != Role::elastic || body.fixed) continue;
    warn_of_compression(description, body, warnings);
    warn_of_soft_layer(description, body, warnings);
  }
  return warnings;
}

}  // namespace kerf
