// SPDX-License-Identifier: Apache-2.0
#include "output/crushing.hpp"

#include <fmt/format.h>

#include "fracture/unstretched_failure.hpp"
#include "materials/elastic_law.hpp"
#include "materials/elastic_moduli.hpp"
#include "model/case.hpp"
#include "model/material_laws.hpp"
#include "output/readable.hpp"

namespace kerf {
namespace {

const Material& material_of(const Case& description, const Body& body) {
  return description.materials.at(static_cast<std::size_t>(body.material));
}

// Returns the pressure that compresses a material without change of its width until it fails in
// compression, Pa.
double crushing_pressure(const Material& material) {
  ElasticSolid<double> solid;
  static_cast<ElasticLawSet<double>&>(solid) = *material.laws;
  static_cast<ElasticModuli<double>&>(solid) =
      ElasticModuli<double>::of(material.youngs_modulus, material.poisson_ratio);
  solid.elasticity = material.elasticity;
  auto gradient = Matrix<3, double>::zero();
  gradient(0, 0) = least_volume - 1.0;
  return -cauchy(solid, gradient)(0, 0);
}

}  // namespace

double stagnation_pressure(const Case& description, const Jet& jet) {
  const double density = description.materials.at(static_cast<std::size_t>(jet.material)).density;
  return 0.5 * density * jet.speed * jet.speed;
}

std::optional<Crushing> crushing_of(const Case& description, const Body& body, const Jet& jet) {
  if (body.role != Role::elastic || body.fixed) return {};
  const Material& material = material_of(description, body);
  if (!material.can_break()) return {};
  const Crushing found{stagnation_pressure(description, jet), crushing_pressure(material)};
  return found.pressure > found.limit ? std::optional(found) : std::nullopt;
}

std::string crushing_sentence(const Case& description, const Body& body, const Jet& jet,
                              const Crushing& crushing) {
  return fmt::format(
      "the jet \"{}\" has a stagnation pressure of {}, and {} compress \"{}\" below a fifth of its "
      "volume, at which it fails: its strength and fracture energy hardly count under this jet "
      "(docs/theory/total_lagrangian.md). A material that keeps its volume, as wet ones do, needs "
      "a poisson_ratio nearer to 0.5 than {:g}",
      jet.name, readable(crushing.pressure, "Pa"), readable(crushing.limit, "Pa"), body.name,
      material_of(description, body).poisson_ratio);
}

}  // namespace kerf
