// SPDX-License-Identifier: Apache-2.0
// The density of a nearly incompressible solid bears tension until the solid is damaged: until a
// particle has lost a bond, softens, or has grown flaws. From then on it opens where it expands
// (docs/theory/nearly_incompressible.md), so that what breaks and softens is what bonds bear.
#pragma once

#include "standard/solid_link.hpp"

namespace kerf {

// 1 for the damaged particles of a solid, else 0: by the state that the last step has kept, which
// computing a deformation for output does not change.
template <int D, class P>
struct IsDamaged {
  using Real = typename P::Real;
  SolidView<D, P> solid;

  KERF_FUNCTION Real operator()(Index s) const {
    const bool damaged = solid.detached[s] || solid.has_broken_bonds[s] ||
                         (solid.softens(s) &&
                          solid.softening_strain_at_start(s) > solid.medium(s).softening_strain) ||
                         solid.damage(s) > Real(0);
    return damaged ? Real(1) : Real(0);
  }
};

// Lets the damaged particles open, at the end of a step. Sums the energy that their densities
// stored in tension, J, which is released.
template <int D, class P>
struct OpenDamaged {
  using Real = typename P::Real;
  ParticleView<D, P> particles;
  SolidIndexView link;
  SolidView<D, P> solid;
  const Real* damaged = nullptr;  // IsDamaged of each, where ranks divide the solid

  KERF_FUNCTION void add(Index s, Terms<1>& sum) const {
    const Index i = link.particle_of[s];
    if (i == no_index || particles.undamaged[i] == 0) return;
    const Real is_damaged = damaged != nullptr ? damaged[s] : IsDamaged<D, P>{solid}(s);
    if (!(is_damaged > Real(0))) return;
    const Real compression = particles.compression[i];
    const double stored =
        compression < Real(0) ? energy_by_density(particles, i, double(compression)) : 0.0;
    particles.undamaged[i] = 0;
    particles.pressure_work[i] -= static_cast<Real>(stored);
    sum.value[0] += solid.medium(s).mass * stored;
  }
};

}  // namespace kerf
