// SPDX-License-Identifier: Apache-2.0
// The media of a solid as its loops need them, and what some of them may do.
#pragma once

#include "core/error.hpp"
#include "solid/find_bonds.hpp"
#include "solid/solid_fields.hpp"

namespace kerf {

struct SolidTraits {
  bool is_viscous = false;  // there are forces between particles that move
  bool can_break = false;
};

template <int D, class P>
SolidTraits take_media(const SolidLayout<D>& layout, SolidFields<D, P>& fields) {
  using Real = typename P::Real;
  SolidTraits traits;
  std::vector<SolidMedium<Real>> media;
  for (const auto& medium : layout.media) {
    media.push_back(SolidMedium<Real>::from(medium));
    traits.is_viscous |= medium.artificial_linear > 0.0 || medium.artificial_quadratic > 0.0;
    traits.can_break |= medium.can_break();
    fields.any_softens |= medium.softens();
  }
  std::vector<PlasticParameters<Real>> plastic;
  for (const auto& parameters : layout.plastic) {
    plastic.push_back(PlasticParameters<Real>::from(parameters));
    fields.any_flows |= parameters.flows();
    traits.is_viscous |= parameters.flows();
    traits.can_break |= parameters.flows() && parameters.damage.is_on();
  }
  std::vector<GradyKipp<Real>> flaw_law;
  for (const auto& law : layout.flaws) {
    flaw_law.push_back(GradyKipp<Real>::from(law));
    fields.any_flaws |= law.is_on();
  }
  std::vector<BondScale<Real>> scale;
  for (const auto& a : layout.media)
    for (const auto& b : layout.media) scale.push_back(BondScale<Real>::template of<D>(a, b));
  require(flaw_law.empty() || flaw_law.size() == media.size(), "laws of flaws for every medium");
  require(plastic.empty() || plastic.size() == media.size(), "laws of flow for every medium");
  to_device(flaw_law, fields.flaw_law);
  to_device(media, fields.media);
  to_device(scale, fields.scale);
  to_device(plastic, fields.plastic);
  return traits;
}

}  // namespace kerf
