// SPDX-License-Identifier: Apache-2.0
// These functions compute the stress of a particle from its deformation gradient. That of an
// elastic one depends on the gradient alone. One with plastic flow starts each step from the state
// of the last one, `flow_start`, and reaches `current_flow`; computing a deformation changes
// `current_flow` only, until UpdatePlasticity makes it the start of the next step.
#pragma once

#include "fracture/softening.hpp"
#include "materials/damaged.hpp"
#include "solid/solid_fields.hpp"

namespace kerf {

// Returns the elastic stress of a particle that softening or damage reduces, for the share s = 1.
template <int D, class P>
KERF_FUNCTION SymmetricTensor<D, typename P::Real> elastic_stress(
    const SolidView<D, P>& solid, Index i, const Matrix<D, typename P::Real>& h) {
  const auto& medium = solid.medium(i);
  const auto green = green_strain(h);
  if (!solid.softens(i)) return second_piola(medium, green, solid.damage(i));
  return second_piola(softened(medium, green, undamaged_share(medium, solid.softening_strain(i))),
                      green);
}
// Takes the loading of a particle to the tensile strain k, `dt` after the start of the step, s.
template <int D, class P>
KERF_FUNCTION void follow_loading(const SolidView<D, P>& solid, Index i, typename P::Real strain,
                                  typename P::Real dt) {
  const auto& medium = solid.medium(i);
  const auto& law = medium.strength_rate;
  const auto& start = solid.loading_start[i];
  const auto slow = medium.slow_failure_strain();
  solid.loading_now[i] = solid.softens(i)
                             ? law.advance_softening(start, strain, dt, slow, solid.strain_start[i])
                             : law.advance(start, strain, dt, slow);
}
// Takes the tensile strain at the gradient H, where softening or strength depends on it. Where
// breaks have left a share s of the elastic energy (solid/limit_break_energy.hpp), it is that of s
// psi_t, so that what softening dissipates remains a function of this strain.
template <int D, class P>
KERF_FUNCTION void follow_strain(const SolidView<D, P>& solid, Index i,
                                 const Matrix<D, typename P::Real>& h, typename P::Real dt) {
  const bool softens = solid.softens(i), depends_on_rate = solid.depends_on_rate(i);
  if (!softens && !depends_on_rate) return;
  const auto strain = std::sqrt(solid.elastic_share[i]) * tensile_strain(solid.medium(i), h);
  if (softens) {
    const auto before = solid.strain_start[i];
    solid.current_strain[i] = strain > before ? strain : before;
  }
  if (depends_on_rate) follow_loading(solid, i, strain, dt);
}

// The stress responses for Deform: the second Piola-Kirchhoff stress at the gradient H for the
// share s = 1, Pa.
template <int D, class P>
struct ElasticResponse {
  using Real = typename P::Real;
  Real dt;  // s, since the start of the step
  KERF_FUNCTION SymmetricTensor<D, Real> stress(const SolidView<D, P>& solid, Index i,
                                                const Matrix<D, Real>& h) const {
    follow_strain(solid, i, h, dt);
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
    if (!solid.flows(i)) return ElasticResponse<D, P>{dt}.stress(solid, i, h);
    const auto result = advance(medium, solid.plasticity(i), h, dt, solid.flow_start[i]);
    solid.current_flow[i] = result.state;
    solid.flow_work[i] = result.plastic_work;
    return result.stress;
  }
};

// Returns the Cauchy stress of the current deformation for the share s = 1, Pa: that of the
// material between the cracks, which fracture criteria judge.
template <int D, class P>
KERF_FUNCTION SymmetricTensor<D, typename P::Real> undivided_cauchy(const SolidView<D, P>& solid,
                                                                    Index i) {
  const auto& medium = solid.medium(i);
  const auto& h = solid.gradient[i];
  if (!solid.flows(i)) return cauchy(elastic_stress(solid, i, h), h);
  return cauchy(second_piola(medium, solid.plasticity(i), h, solid.current_flow[i].metric), h);
}
// Returns the Cauchy stress of the current deformation, Pa.
template <int D, class P>
KERF_FUNCTION SymmetricTensor<D, typename P::Real> cauchy_now(const SolidView<D, P>& solid,
                                                              Index i) {
  return solid.elastic_share[i] * undivided_cauchy(solid, i);
}

// The state on which the stored energy depends beside the gradient: where it softens k / R, where
// it flows the metric.
template <int D, class P>
struct EnergyState {
  double strain = 0.0;
  SymmetricTensor<D, double> metric{};

  KERF_FUNCTION static EnergyState now(const SolidView<D, P>& solid, Index i) {
    EnergyState state;
    if (solid.softens(i)) state.strain = double(solid.softening_strain(i));
    if (solid.flows(i))
      state.metric = SymmetricTensor<D, double>::from(solid.current_flow[i].metric);
    return state;
  }
  KERF_FUNCTION static EnergyState at_start(const SolidView<D, P>& solid, Index i) {
    EnergyState state;
    if (solid.softens(i)) state.strain = double(solid.softening_strain_at_start(i));
    if (solid.flows(i)) state.metric = SymmetricTensor<D, double>::from(solid.flow_start[i].metric);
    return state;
  }
};

// Returns the stored energy of particle i per reference volume at the gradient H, J/m^3.
template <int D, class P>
KERF_FUNCTION double energy_density_at(const SolidView<D, P>& solid, Index i,
                                       const Matrix<D, double>& h, const EnergyState<D, P>& state) {
  const auto medium = BreakableSolid<double>::from(solid.medium(i));
  const double share = solid.elastic_share[i];
  const auto green = green_strain(h);
  if (solid.softens(i))
    return share *
           energy_density(softened(medium, green, undamaged_share(medium, state.strain)), green);
  if (!solid.flows(i)) return share * energy_density(medium, green, double(solid.damage(i)));
  const auto parameters = PlasticParameters<double>::from(solid.plasticity(i));
  return share * energy_density(medium, parameters, h, state.metric);
}

}  // namespace kerf
