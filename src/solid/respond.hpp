// SPDX-License-Identifier: Apache-2.0
// How a particle of the solid answers to its deformation gradient. An elastic one has a stress that
// the gradient alone decides. One that flows starts each step from the state of the last one,
// `flow_start`, and comes to `flow_now`; to look at a deformation changes `flow_now` only, until
// KeepFlow makes it the start of the next step.
#pragma once

#include "fracture/softening.hpp"
#include "materials/damaged.hpp"
#include "solid/solid_fields.hpp"

namespace kerf {

// The strain that softening goes by, with that of the gradient in force.
template <int D, class P>
KERF_FUNCTION typename P::Real largest_strain(const SolidView<D, P>& solid, Index i,
                                              const Matrix<D, typename P::Real>& h) {
  const auto strain = tensile_strain(solid.medium(i), h), before = solid.strain_start[i];
  return strain > before ? strain : before;
}
// The elastic stress of what softening or damage has left of a particle.
template <int D, class P>
KERF_FUNCTION SymmetricTensor<D, typename P::Real> elastic_stress(
    const SolidView<D, P>& solid, Index i, const Matrix<D, typename P::Real>& h) {
  const auto& medium = solid.medium(i);
  const auto green = green_strain(h);
  if (!solid.softens(i)) return second_piola(medium, green, solid.damage(i));
  return second_piola(softened(medium, green, whole_share(medium, solid.strain_now[i])), green);
}

// The answers that Deform asks for: the second Piola-Kirchhoff stress at the gradient H, Pa.
template <int D, class P>
struct ElasticResponse {
  using Real = typename P::Real;
  KERF_FUNCTION SymmetricTensor<D, Real> stress(const SolidView<D, P>& solid, Index i,
                                                const Matrix<D, Real>& h) const {
    if (solid.softens(i)) solid.strain_now[i] = largest_strain(solid, i, h);
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
    solid.flow_now[i] = result.state;
    solid.flow_work[i] = result.plastic_work;
    return result.stress;
  }
};

// Of the deformation in force.
template <int D, class P>
KERF_FUNCTION SymmetricTensor<D, typename P::Real> cauchy_now(const SolidView<D, P>& solid,
                                                              Index i) {
  const auto& medium = solid.medium(i);
  const auto& h = solid.gradient[i];
  if (!solid.flows(i)) return cauchy(elastic_stress(solid, i, h), h);
  return cauchy(second_piola(medium, solid.plasticity(i), h, solid.flow_now[i].metric), h);
}

// Stored energy per reference volume in double, J/m^3.
template <int D, class P>
KERF_FUNCTION double energy_density_now(const SolidView<D, P>& solid, Index i) {
  const auto medium = SolidMedium<double>::from(solid.medium(i));
  const auto h = Matrix<D, double>::from(solid.gradient[i]);
  if (solid.softens(i)) {
    const double whole = whole_share(medium, double(solid.strain_now[i]));
    return energy_density(softened(medium, green_strain(h), whole), green_strain(h));
  }
  if (!solid.flows(i)) return energy_density(medium, green_strain(h), double(solid.damage(i)));
  const auto parameters = PlasticParameters<double>::from(solid.plasticity(i));
  return energy_density(medium, parameters, h,
                        SymmetricTensor<D, double>::from(solid.flow_now[i].metric));
}

}  // namespace kerf
