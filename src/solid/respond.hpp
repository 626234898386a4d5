// SPDX-License-Identifier: Apache-2.0
// How a particle of the solid answers to its deformation gradient. An elastic one has a stress that
// the gradient alone decides. One that flows starts each step from the state of the last one,
// `flow_start`, and comes to `flow_now`; to look at a deformation changes `flow_now` only, until
// KeepFlow makes it the start of the next step.
//
// The hourglass control resists what a particle's gradient does not see, with a modulus mu =
// zeta E. Where the material flows that is flow too, and as soft: mu falls like the secant of a
// test in shear, and further,  mu = zeta E / (1 + 5 eps_p / eps_y),  eps_y = sigma_0 / (3 G). The
// energy that the control then holds too much of is dissipated. Where it softens, mu falls with the
// square of what is left, so that the control does not hold a crack together.
#pragma once

#include "fracture/softening.hpp"
#include "materials/damaged.hpp"
#include "solid/solid_fields.hpp"

namespace kerf {

template <class T>
KERF_FUNCTION T hourglass_modulus(const SolidMedium<T>& medium,
                                  const PlasticParameters<T>& parameters, T plastic_strain) {
  const T elastic = medium.hourglass_modulus();
  if (!parameters.flows()) return elastic;
  const T first_strain = parameters.first_strength() / (T(3) * medium.shear_modulus);
  return first_strain > T(0) ? elastic * (first_strain / (first_strain + T(5) * plastic_strain))
                             : T(0);
}

// The strain that softening goes by, with that of the gradient in force.
template <int D, class P>
KERF_FUNCTION typename P::Real largest_strain(const SolidView<D, P>& solid, Index i,
                                              const Matrix<D, typename P::Real>& h) {
  const auto strain = tensile_strain(solid.medium(i), h), before = solid.strain_start[i];
  return strain > before ? strain : before;
}
// The elastic stress of what is left of a particle that softens.
template <int D, class P>
KERF_FUNCTION SymmetricTensor<D, typename P::Real> softened_stress(
    const SolidView<D, P>& solid, Index i, const Matrix<D, typename P::Real>& h) {
  const auto& medium = solid.medium(i);
  const auto green = green_strain(h);
  return second_piola(softened(medium, green, whole_share(medium, solid.strain_now[i])), green);
}
// Where cracks grow from flaws it falls with damage; a tenth is left for what is pressed together.
template <class T>
KERF_FUNCTION T damaged_hourglass(const SolidMedium<T>& medium, T damage) {
  return medium.hourglass_modulus() * (T(1) - T(0.9) * damage);
}

// The answers that Deform asks for: the second Piola-Kirchhoff stress at the gradient H, Pa.
template <int D, class P>
struct ElasticResponse {
  using Real = typename P::Real;
  KERF_FUNCTION SymmetricTensor<D, Real> stress(const SolidView<D, P>& solid, Index i,
                                                const Matrix<D, Real>& h) const {
    if (!solid.softens(i)) return second_piola(solid.medium(i), green_strain(h), solid.damage(i));
    solid.strain_now[i] = largest_strain(solid, i, h);
    return softened_stress(solid, i, h);
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
  if (solid.softens(i)) return cauchy(softened_stress(solid, i, h), h);
  if (!solid.flows(i)) return cauchy(second_piola(medium, green_strain(h), solid.damage(i)), h);
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
