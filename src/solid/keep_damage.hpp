// SPDX-License-Identifier: Apache-2.0
// The end of a step of what has flaws: they grow by what the deformation in force makes of them.
// The tension that a particle bears, and with it the modulus of its hourglass control, mu = zeta E
// (1 - 0.9 D), fall at this deformation; what they stored too much of is set free.
#pragma once

#include "exec/ordered_sum.hpp"
#include "solid/hourglass_modulus.hpp"

namespace kerf {

template <int D, class P>
struct StartFlaws {
  using Real = typename P::Real;
  SolidView<D, P> solid;

  KERF_FUNCTION void operator()(Index i) const {
    solid.flaws[i] =
        solid.has_flaws(i) ? solid.flaw_law[solid.medium_index[i]].start(i) : FlawState<Real>{};
    solid.damage_loss[i] = 0.0;
  }
};

template <int D, class P>
struct KeepDamage {
  using Real = typename P::Real;
  SolidView<D, P> solid;
  Real dt;  // s

  KERF_FUNCTION void operator()(Index i) const {
    solid.damage_loss[i] = 0.0;
    if (!solid.has_flaws(i) || solid.loose[i]) return;
    const auto& medium = solid.medium(i);
    const auto& law = solid.flaw_law[solid.medium_index[i]];
    const auto strain = principal_values(green_strain(solid.gradient[i]));
    const auto tension = TensionLaw<Real>::of(medium);
    const Real before = solid.flaws[i].damage;
    solid.flaws[i] = law.advance(solid.flaws[i], i, tension.scalar_strain(strain), dt);
    const Real more = solid.flaws[i].damage - before;
    if (!(more > Real(0))) return;
    const auto h = Matrix<D, double>::from(solid.gradient[i]);
    const auto stored = TensionLaw<double>::of(medium).energy(principal_values(green_strain(h)));
    solid.damage_loss[i] =
        double(medium.volume()) * double(more) * stored + lower_hourglass(solid, i);
  }
};

// What the last KeepDamage set free, J.
template <int D, class P>
struct DamageLossTerm {
  SolidView<D, P> solid;
  KERF_FUNCTION void add(Index i, Terms<1>& sum) const { sum.value[0] += solid.damage_loss[i]; }
};

}  // namespace kerf
