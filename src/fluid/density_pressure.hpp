// SPDX-License-Identifier: Apache-2.0
// What a particle bears and stores by its density: a fluid and detached solid by all of K, a nearly
// incompressible solid by the excess of K over what its bonds carry. Matter opens where it expands,
// except an undamaged nearly incompressible solid, which bears tension
// (docs/theory/nearly_incompressible.md).
#pragma once

#include "materials/equation_of_state.hpp"
#include "particles/fields.hpp"

namespace kerf {

// Returns the share of K that acts by the density of particle i, which has one, at a compression.
template <class Number, int D, class P>
KERF_FUNCTION Number share_by_density(const ParticleView<D, P>& particles, Index i,
                                      Number compression) {
  const auto& medium = particles.medium(i);
  if (particles.is_fluid(i)) return is_opened(medium, compression) ? Number(0) : Number(1);
  if (!(compression < Number(0)))
    return Number(medium.excess_bulk_modulus) / Number(medium.total_bulk_modulus);
  return particles.bears_tension(i)
             ? Number(medium.tensile_excess) / Number(medium.total_bulk_modulus)
             : Number(0);
}

// Returns the pressure, Pa.
template <int D, class P>
KERF_FUNCTION typename P::Real pressure_by_density(const ParticleView<D, P>& particles, Index i,
                                                   typename P::Real compression) {
  using Real = typename P::Real;
  const Real share = share_by_density<Real>(particles, i, compression);
  return share != Real(0) ? share * unopened_pressure_at(particles.medium(i), compression)
                          : Real(0);
}

// Returns the stored energy, J/kg.
template <int D, class P>
KERF_FUNCTION double energy_by_density(const ParticleView<D, P>& particles, Index i,
                                       double compression) {
  const double share = share_by_density<double>(particles, i, compression);
  return share != 0.0 ? share * unopened_energy_at(particles.medium(i), compression) : 0.0;
}

}  // namespace kerf
