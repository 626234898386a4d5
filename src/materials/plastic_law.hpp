// SPDX-License-Identifier: Apache-2.0
// The laws of solids that flow, chosen per medium while the program runs. Equations and limits:
// docs/theory/plasticity.md.
#pragma once

#include "materials/drucker_prager.hpp"
#include "materials/j2_hardening.hpp"
#include "materials/johnson_cook_damage.hpp"
#include "materials/johnson_cook_strength.hpp"

namespace kerf {

template <class T>
struct PlasticParameters {
  PlasticLaw law = PlasticLaw::none;  // none: Hencky's elasticity
  J2Hardening<T> hardening;           // of von_mises
  JohnsonCookStrength<T> strength;    // of johnson_cook
  DruckerPrager<T> cone;              // of drucker_prager
  JohnsonCookDamage<T> damage;        // of any
  PlasticHeat<T> heat;                // of any

  KERF_FUNCTION bool flows() const { return law != PlasticLaw::none; }
  // Strength q at first flow, cold, slow and free of pressure, Pa.
  KERF_FUNCTION T first_strength() const {
    switch (law) {
      case PlasticLaw::none:
        break;
      case PlasticLaw::von_mises:
        return hardening.yield_stress;
      case PlasticLaw::johnson_cook:
        return strength.yield_stress;
      case PlasticLaw::drucker_prager:
        return cone.strength;
    }
    return T(0);
  }
  // Flow keeps the volume.
  KERF_FUNCTION bool is_metal() const { return law != PlasticLaw::drucker_prager; }

  template <class Other>
  KERF_FUNCTION static PlasticParameters from(const PlasticParameters<Other>& other) {
    return {other.law,
            J2Hardening<T>::from(other.hardening),
            JohnsonCookStrength<T>::from(other.strength),
            DruckerPrager<T>::from(other.cone),
            JohnsonCookDamage<T>::from(other.damage),
            PlasticHeat<T>::from(other.heat)};
  }
};

// The elastic strain if nothing flows from the start of the step on. The volume of a metal is that
// of the whole deformation: rounding of the metric, step after step, builds up no pressure.
template <int D, class T>
KERF_FUNCTION ElasticStrain<D, T> trial_strain(const PlasticParameters<T>& parameters,
                                               const Matrix<D, T>& h,
                                               const SymmetricTensor<D, T>& metric) {
  auto strain = ElasticStrain<D, T>::of(h, metric);
  if (parameters.is_metal()) strain.volume = log_volume(h);
  return strain;
}

template <int D, class T>
KERF_FUNCTION PlasticFlow<T> flow_of(const SolidMedium<T>& solid,
                                     const PlasticParameters<T>& parameters,
                                     const MeridianStress<T>& trial, T dt,
                                     const PlasticState<D, T>& start) {
  const T modulus = T(3) * solid.shear_modulus;
  switch (parameters.law) {
    case PlasticLaw::none:
      break;
    case PlasticLaw::von_mises:
      return metal_flow(ExcessStress<T, J2Hardening<T>>{
          parameters.hardening, parameters.heat, trial.equivalent, modulus, dt,
          start.plastic_strain, start.temperature_rise});
    case PlasticLaw::johnson_cook:
      return metal_flow(ExcessStress<T, JohnsonCookStrength<T>>{
          parameters.strength, parameters.heat, trial.equivalent, modulus, dt, start.plastic_strain,
          start.temperature_rise});
    case PlasticLaw::drucker_prager:
      return parameters.cone.flow(solid, trial);
  }
  return PlasticFlow<T>::none();
}

// What the flow at the stress reached does to the scalars of the state; the plastic work, J/m^3.
template <int D, class T>
KERF_FUNCTION T wear(const PlasticParameters<T>& parameters, const PlasticFlow<T>& flow,
                     const MeridianStress<T>& stress, T dt, PlasticState<D, T>& state) {
  const T work = stress.equivalent * flow.shear + stress.mean * flow.volume;
  state.plastic_strain += flow.shear;
  state.temperature_rise += parameters.heat.rise(work);
  if (!parameters.damage.is_on()) return work;
  const T rate = dt > T(0) ? flow.shear / dt : T(0);
  const T homologous = parameters.heat.homologous_temperature(state.temperature_rise);
  const T damage =
      state.damage + flow.shear / parameters.damage.failure_strain(stress.mean, stress.equivalent,
                                                                   rate, homologous);
  state.damage = damage < T(1) ? damage : T(1);
  return work;
}

// Stored energy, J/m^3, and second Piola-Kirchhoff stress, Pa, at a state that flows no further.
template <int D, class T>
KERF_FUNCTION T energy_density(const SolidMedium<T>& solid, const PlasticParameters<T>& parameters,
                               const Matrix<D, T>& h, const SymmetricTensor<D, T>& metric) {
  return trial_strain(parameters, h, metric).energy_density(solid);
}
template <int D, class T>
KERF_FUNCTION SymmetricTensor<D, T> second_piola(const SolidMedium<T>& solid,
                                                 const PlasticParameters<T>& parameters,
                                                 const Matrix<D, T>& h,
                                                 const SymmetricTensor<D, T>& metric) {
  const auto strain = trial_strain(parameters, h, metric);
  return congruence(inverse(identity<D, T>() + h), strain.kirchhoff(solid));
}

// A step of `dt` (s; 0 = so slow that no rate counts) from the state `start` to the displacement
// gradient H = F - 1. A function of its arguments alone: to look at a step changes nothing.
template <int D, class T>
KERF_FUNCTION PlasticResult<D, T> advance(const SolidMedium<T>& solid,
                                          const PlasticParameters<T>& parameters,
                                          const Matrix<D, T>& h, T dt,
                                          const PlasticState<D, T>& start) {
  PlasticResult<D, T> result;
  result.state = start;
  result.plastic_work = T(0);
  auto strain = trial_strain(parameters, h, start.metric);
  const Matrix<D, T> inverse_gradient = inverse(identity<D, T>() + h);
  const MeridianStress<T> trial{strain.equivalent_stress(solid), strain.mean_stress(solid)};
  const PlasticFlow<T> flow = flow_of(solid, parameters, trial, dt, start);
  if (flow.shear > T(0) || flow.volume != T(0)) {
    let_flow(flow, inverse_gradient, strain, result.state.metric);
    const MeridianStress<T> stress{strain.equivalent_stress(solid), strain.mean_stress(solid)};
    result.plastic_work = wear(parameters, flow, stress, dt, result.state);
  }
  result.stored_energy = strain.energy_density(solid);
  result.stress = congruence(inverse_gradient, strain.kirchhoff(solid));  // S = F^-1 tau F^-T
  return result;
}

}  // namespace kerf
