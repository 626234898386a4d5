// SPDX-License-Identifier: Apache-2.0
// The values of particles that the fracture criteria compare (fracture/bond_criterion.hpp).
#pragma once

#include "fracture/bond_criterion.hpp"
#include "solid/solid_fields.hpp"
#include "solid/stress_response.hpp"

namespace kerf {

// Stands for the prepared value of a criterion that is too low to be met and is not computed.
template <class T>
inline constexpr T too_low = T(-1e30);

// Calls action(solid) with the limits that particle i has at its rate of strain, R times those of a
// slow test (fracture/strength_rate.hpp).
template <int D, class P, class Action>
KERF_FUNCTION auto with_limits_at_rate(const SolidView<D, P>& solid, Index i,
                                       const Action& action) {
  const BondedSolid<typename P::Real>& slow = solid.medium(i);
  if (!solid.any_rate) return action(slow);
  return action(slow.strengthened(solid.strength_factor(i)));
}

// The values of a particle that a fracture criterion needs (fracture/bond_criterion.hpp). `solid`:
// its medium with the limits at its rate of strain.
template <int D, class P>
struct CriterionParticle {
  using Real = typename P::Real;
  const SolidView<D, P>& view;
  Index i;
  const BondedSolid<Real>& solid;
  SymmetricTensor<D, Real> green;  // Green's strain
  Real damage;

  KERF_FUNCTION CriterionParticle(const SolidView<D, P>& all, Index particle,
                                  const BondedSolid<Real>& of_particle)
      : view(all),
        i(particle),
        solid(of_particle),
        green(green_strain(all.gradient[particle])),
        damage(all.damage(particle)) {}
  KERF_FUNCTION Real tensile_strain() const {
    return view.softens(i) ? view.current_strain[i] : kerf::tensile_strain(solid, view.gradient[i]);
  }
  // Pa, Kirchhoff's, with the tension that the density of an undamaged particle bears.
  KERF_FUNCTION Real largest_stress() const {
    if (!view.flows(i)) {
      BreakableSolid<Real> bearing = solid;
      if (!view.has_broken_bonds[i] && is_expanded(solid, green))
        bearing.bulk_modulus += view.medium(i).tensile_excess;
      return ElasticParticle<D, Real>{bearing, green}.largest_stress();
    }
    return std::sqrt(Real(1) + volume_square_less_one(green)) *
           largest_of(principal_values(undivided_cauchy(view, i)));
  }
};

template <int D, class P>
struct PreparedAt {
  using Real = typename P::Real;
  const SolidView<D, P>& solid;
  Index i;
  KERF_FUNCTION Real operator()(const BondedSolid<Real>& limits) const {
    return prepare_criterion(limits, CriterionParticle<D, P>(solid, i, limits));
  }
};
// Returns the number of the criterion of a particle, by its medium at its rate of strain.
template <int D, class P>
KERF_FUNCTION typename P::Real criterion_of(const SolidView<D, P>& solid, Index i) {
  using Real = typename P::Real;
  const Real known = solid.criterion[i];
  return known > too_low<Real> ? known : with_limits_at_rate(solid, i, PreparedAt<D, P>{solid, i});
}

}  // namespace kerf
