// SPDX-License-Identifier: Apache-2.0
// Refuses fracture limits that cannot be those of a body: it would never break, or fall apart by
// itself, without a word.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "fracture/crack_band.hpp"
#include "geometry/shapes.hpp"
#include "input/draft.hpp"
#include "model/case.hpp"
#include "model/material_laws.hpp"

namespace kerf {
namespace {

constexpr double small_strain = 0.01;

// Longest edge of the box around all bodies that are not rigid, m.
double longest_edge_of_bodies(const Case& description) {
  double longest = 0.0;
  for (std::size_t a = 0; a < static_cast<std::size_t>(description.dimension); ++a) {
    double low = 1e300, high = -1e300;
    for (const Body& body : description.bodies) {
      if (body.role == Role::rigid) continue;
      const Box box = bounding_box(body.shape, description.dimension);
      low = std::min(low, box.minimum[a]);
      high = std::max(high, box.maximum[a]);
    }
    longest = std::max(longest, high - low);
  }
  return longest;
}

// The stress of a crack that softens has fallen to zero at the opening 2 Gc / (E e_0), whatever the
// spacing. Soft tissue that is stretched by tens of per cent may open further than a small sample
// is long, and so may the band of a material without a strength where the spacing is coarse; for
// both `kerf check` has a warning. A solid that begins to fail at a small strain does not.
void check_opening(Draft& draft, const Material& material, const FractureLimits& limits,
                   double spacing) {
  const double opening = softening_band_width * spacing * limits.end;
  const double longest = longest_edge_of_bodies(draft.result);
  if (!limits.softens() || opening <= longest) return;
  if (material.failure_strain == 0.0 || material.failure_strain >= small_strain) return;
  const double least = material.failure_strain * opening / longest;
  draft.reading.problems.add(
      {fmt::format("materials.{}.failure_strain", material.name),
       fmt::format("a crack that begins at this strain and takes the fracture_energy of {:.3g} "
                   "J/m2 is complete when it has opened by {:.3g} m, more than the solids are long "
                   "({:.3g} m), so that nothing would break",
                   material.fracture_energy, opening, longest),
       fmt::format("{:.3g} or more at this fracture_energy", std::min(least, small_strain)),
       "Give the strain at which a tensile test fails, or a lower fracture_energy"});
}

void check_smallness(Draft& draft, const Material& material, const FractureLimits& limits) {
  if (limits.start > 0.0 && limits.start < least_failure_strain) {
    const bool by_energy =
        material.fracture_energy > 0.0 && (!limits.softens() || material.failure_strain == 0.0);
    const double part = limits.start / least_failure_strain;
    draft.reading.problems.add(
        {fmt::format("materials.{}.{}", material.name,
                     by_energy ? "fracture_energy" : "failure_strain"),
         fmt::format("the material would break at a strain of {:.3g}, which the strains of single "
                     "precision do not resolve",
                     limits.start),
         by_energy ? fmt::format("{:.3g} J/m2 or more at this spacing",
                                 material.fracture_energy / (part * part))
                   : fmt::format("0 (never), or {:g} or more", least_failure_strain),
         "Correct the value or its unit"});
    return;
  }
  const double strength = material.laws->principal_stress.tensile_strength;
  const double least = least_failure_strain * material.youngs_modulus;
  if (material.criterion != BondCriterion::principal_stress || strength >= least) return;
  draft.reading.problems.add(
      {fmt::format("materials.{}.tensile_strength", material.name),
       fmt::format("the material would break at a strain of {:.3g}, which the strains of single "
                   "precision do not resolve",
                   strength / material.youngs_modulus),
       fmt::format("{:.3g} Pa or more", least), "Correct the value or its unit"});
}

// Criteria but those of strain take strengths and energies by Young's modulus, which is that of
// small strains: a solid that stiffens with stretch would break several times too late.
void check_stiffening(Draft& draft, const Material& material) {
  const bool judges_strain = material.criterion == BondCriterion::principal_strain ||
                             material.criterion == BondCriterion::equivalent_strain;
  const double exponent = material.laws->ogden.exponent;
  if (material.elasticity != ElasticLaw::ogden || judges_strain || !(exponent > 2.0)) return;
  draft.reading.problems.add(
      {fmt::format("materials.{}.criterion", material.name),
       fmt::format("{} takes limits by Young's modulus at small strains, which this solid (ogden, "
                   "exponent {:g}) leaves behind as it stiffens: it would break at several times "
                   "its strength",
                   bond_criterion_words[static_cast<std::size_t>(material.criterion)], exponent),
       "principal_strain, equivalent_strain",
       "Give the strain at which a tensile test fails, ln(1 + elongation), as failure_strain"});
}

}  // namespace

void check_fracture(Draft& draft) {
  std::set<std::string> told;  // materials
  for (const Body& body : draft.result.bodies) {
    if (body.role == Role::rigid) continue;
    const Material& material = draft.result.materials[static_cast<std::size_t>(body.material)];
    if (!material.can_break() || !told.insert(material.name).second) continue;
    const FractureLimits limits = fracture_limits(material, body.spacing);
    check_stiffening(draft, material);
    check_smallness(draft, material, limits);
    check_opening(draft, material, limits, body.spacing);
  }
}

}  // namespace kerf
