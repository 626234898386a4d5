// SPDX-License-Identifier: Apache-2.0
// These functions compute the stress of a particle from its deformation gradient. That of an
// elastic one depends on the gradient alone. One with plastic flow starts each step from the state
// of the last one, `flow_start`, and reaches `current_flow`; computing a deformation changes
// `current_flow` only, until KeepFlow makes it the start of the next step.
#pragma once

#include "fracture/softening.hpp"
#include "materials/damaged.hpp"
#include "solid/solid_fields.hpp"

namespace kerf {

// Returns the strain that determines softening, that of the current gradient included.
template <int D, class P>
KERF_FUNCTION typename P::Real largest_strain(const SolidView<D, P>& solid, Index i,
                                              const Matrix<D, typename P::Real>& h) {
  const auto strain = tensile_strain(solid.medium(i), h), before = solid.strain_start[i];
  return strain > before ? strain : before;
}
// Returns the elastic stress of a particle that softening or damage reduces.
template <int D, class P>
KERF_FUNCTION SymmetricTensor<D, typename P::Real> elastic_stress(
    const SolidView<D, P>& solid, Index i, const Matrix<D, typename P::Real>& h) {
  const auto& medium = solid.medium(i);
  const auto green = green_strain(h);
  if (!solid.softens(i)) return second_piola(medium, green, solid.damage(i));
  return second_piola(softened(medium, green, undamaged_share(medium, solid.current_strain[i])),
                      green);
}

// The stress responses for Deform: the second Piola-Kirchhoff stress at the gradient H, Pa.
template <int D, class P>
struct ElasticResponse {
  using Real = typename P::Real;
  KERF_FUNCTION SymmetricTensor<D, Real> stress(const SolidView<D, P>& solid, Index i,
                                                const Matrix<D, Real>& h) const {
    if (solid.softens(i)) solid.current_strain[i] = largest_strain(solid, i, h);
    return elastic_stress(solid, i, h);
  }
};
template <int D, class P>
struct FlowingResponse {
  using Real = typename P::Real;
  Real dt;  // s, since the state `flow_start`
  KERF_FUNCTION SymmetricTensor<D, Real> stress(const SolidView<D, P>& solid, Index i,
                                                const Matrix<D, Real>& h) const {
    const auto& medium = solid.medium(i);
    if (!solid.flows(i)) return ElasticResponse<D, P>{}.stress(solid, i, h);
    const auto result = advance(medium, solid.plasticity(i), h, dt, solid.flow_start[i]);
    solid.current_flow[i] = result.state;
    solid.flow_work[i] = result.plastic_work;
    return result.stress;
  }
};

// Returns the Cauchy stress of the current deformation.
template <int D, class P>
KERF_FUNCTION SymmetricTensor<D, typename P::Real> cauchy_now(const SolidView<D, P>& solid,
                                                              Index i) {
  const auto& medium = solid.medium(i);
  const auto& h = solid.gradient[i];
  if (!solid.flows(i)) return cauchy(elastic_stress(solid, i, h), h);
  return cauchy(second_piola(medium, solid.plasticity(i), h, solid.current_flow[i].metric), h);
}

// Returns the stored energy per reference volume in double, J/m^3.
template <int D, class P>
KERF_FUNCTION double energy_density_now(const SolidView<D, P>& solid, Index i) {
  const auto medium = BreakableSolid<double>::from(solid.medium(i));
  const auto h = Matrix<D, double>::from(solid.gradient[i]);
  if (solid.softens(i)) {
    const double undamaged = undamaged_share(medium, double(solid.current_strain[i]));
    return energy_density(softened(medium, green_strain(h), undamaged), green_strain(h));
  }
  if (!solid.flows(i)) return energy_density(medium, green_strain(h), double(solid.damage(i)));
  const auto parameters = PlasticParameters<double>::from(solid.plasticity(i));
  return energy_density(medium, parameters, h,
                        SymmetricTensor<D, double>::from(solid.current_flow[i].metric));
}

}  // namespace kerf
