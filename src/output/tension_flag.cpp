// SPDX-License-Identifier: Apache-2.0
#include "output/tension_flag.hpp"

#include <fmt/format.h>

#include "materials/elastic_moduli.hpp"
#include "model/case.hpp"

namespace kerf {

std::optional<ValidityFlag> tension_flag(const Case& description) {
  if (description.formulation != Formulation::standard) return {};
  const double bulk = most_bond_bulk, pulled = (3.0 * bulk - 2.0) / (2.0 * (3.0 * bulk + 1.0));
  const Material* softest = nullptr;
  for (const Body& body : description.bodies) {
    if (body.role != Role::elastic) continue;
    const Material& material = description.materials[static_cast<std::size_t>(body.material)];
    if (material.poisson_ratio > pulled &&
        (softest == nullptr || material.poisson_ratio > softest->poisson_ratio))
      softest = &material;
  }
  if (softest == nullptr) return {};
  const double nu = softest->poisson_ratio;
  const double along =
      description.dimension == 2 ? (1.0 - pulled) / (1.0 - nu) : (1.0 + nu) / (1.0 + pulled);
  const bool flows = softest->plasticity != PlasticLaw::none;
  return ValidityFlag{
      "tension", ValidityFlag::State::note, pulled, nu,
      fmt::format("Where it is {}, {} acts under tension with a Poisson's ratio of {:.2f} for "
                  "{:g}, so that a bar of it stretches {:.0f}% farther{}.",
                  flows ? "pulled" : "damaged", softest->name, pulled, nu, 100.0 * (along - 1.0),
                  flows ? "; pressed it acts as given" : "")};
}

}  // namespace kerf
