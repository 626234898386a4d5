// SPDX-License-Identifier: Apache-2.0
#include "study/layout.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "model/case.hpp"

namespace kerf {

namespace {

void reseed(Case& description, int layout) {
  constexpr std::uint64_t largest = 2147483647;
  for (Body& body : description.bodies)
    body.seed = (body.seed + static_cast<std::uint64_t>(layout)) % (largest + 1);
}

bool may_move_along_x(const Case& description) {
  return !description.jets.empty() && !description.symmetry.minimum[0] &&
         !description.symmetry.maximum[0];
}

}  // namespace

bool has_random_layout(const Case& description) {
  return std::any_of(description.bodies.begin(), description.bodies.end(), [&](const Body& body) {
    const bool has_flaws =
        body.material >= 0 &&
        description.materials[static_cast<std::size_t>(body.material)].criterion ==
            BondCriterion::grady_kipp;
    return body.jitter > 0.0 || has_flaws;
  });
}

bool has_other_layouts(const Case& description) {
  return has_random_layout(description) || may_move_along_x(description);
}

void change_layout(Case& description, int layout) {
  if (layout == 0) return;
  if (has_random_layout(description)) return reseed(description, layout);
  if (!may_move_along_x(description)) return;
  const double turns = layout * std::numbers::phi;
  const double share = turns - std::round(turns);
  for (Jet& jet : description.jets) jet.position[0] += share * jet.spacing;
  if (description.machine) description.machine->position[0] += share * description.machine->spacing;
}

}  // namespace kerf
