// SPDX-License-Identifier: Apache-2.0
// UpdateDamage ends a step of media with flaws: the flaws grow at the current deformation. The
// tension of a particle, and with it the modulus of its hourglass control, mu = zeta E (1 - 0.9 D),
// fall at this deformation; the excess of stored energy is released.
#pragma once

#include "parallel/ordered_sum.hpp"
#include "solid/hourglass_modulus.hpp"

namespace kerf {

template <int D, class P>
struct StartFlaws {
  using Real = typename P::Real;
  SolidView<D, P> solid;

  KERF_FUNCTION void operator()(Index i) const {
    solid.flaws[i] = solid.has_flaws(i) ? solid.medium(i).grady_kipp.start(i) : FlawState<Real>{};
    solid.damage_loss[i] = 0.0;
  }
};

template <int D, class P>
struct UpdateDamage {
  using Real = typename P::Real;
  SolidView<D, P> solid;
  Real dt;  // s

  KERF_FUNCTION void operator()(Index i) const {
    solid.damage_loss[i] = 0.0;
    if (!solid.has_flaws(i) || solid.detached[i]) return;
    const auto& medium = solid.medium(i);
    const auto& law = medium.grady_kipp;
    const auto strain = principal_values(green_strain(solid.gradient[i]));
    const auto tension = TensionLaw<Real>::of(medium);
    const Real before = solid.flaws[i].damage;
    solid.flaws[i] = law.advance(solid.flaws[i], i, tension.scalar_strain(strain), dt);
    const Real more = solid.flaws[i].damage - before;
    if (!(more > Real(0))) return;
    const auto h = Matrix<D, double>::from(solid.gradient[i]);
    const auto stored = TensionLaw<double>::of(medium).energy(principal_values(green_strain(h)));
    solid.damage_loss[i] =
        double(medium.reference_volume()) * double(solid.elastic_share[i]) * double(more) * stored +
        lower_hourglass(solid, i);
  }
};

// Sums the energy that the last UpdateDamage released, J.
template <int D, class P>
struct DamageLossTerm {
  SolidView<D, P> solid;
  KERF_FUNCTION void add(Index i, Terms<1>& sum) const { sum.value[0] += solid.damage_loss[i]; }
};

}  // namespace kerf
