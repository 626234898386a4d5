// SPDX-License-Identifier: Apache-2.0
// take_media() sets the media of a solid for its loops, and finds what they may do.
#pragma once

#include "solid/bond_viscosity.hpp"
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
  std::vector<Medium<Real>> media;
  for (const auto& medium : layout.media) {
    media.push_back(Medium<Real>::from(medium));
    traits.is_viscous |= medium.artificial_linear > 0.0 || medium.artificial_quadratic > 0.0;
    traits.can_break |= medium.can_break();
    fields.any_softens |= medium.softens();
    fields.any_flows |= medium.plastic.flows();
    traits.is_viscous |= medium.plastic.flows();
    fields.any_flaws |= medium.grady_kipp.is_on();
    fields.any_rate |= medium.depends_on_rate();
  }
  std::vector<BondScale<Real>> scale;
  for (const auto& a : layout.media)
    for (const auto& b : layout.media) scale.push_back(BondScale<Real>::template of<D>(a, b));
  std::vector<BondViscosityLaw<Real>> viscosity;
  for (const auto& a : media)
    for (const auto& b : media) viscosity.push_back(bond_viscosity_between(a, b));
  to_device(media, fields.media);
  to_device(viscosity, fields.viscosity);
  to_device(scale, fields.scale);
  return traits;
}

}  // namespace kerf
