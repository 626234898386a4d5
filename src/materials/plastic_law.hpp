// SPDX-License-Identifier: Apache-2.0
// The laws of solids that flow. A medium chooses one of them by the word of the case file;
// equations and limits are in docs/theory/plasticity.md. Each has (core/law_list.hpp)
//   first_strength()                            strength q at first flow, cold, slow and without
//                                               pressure, Pa
//   is_metal                                    whether flow keeps the volume, and heat and ductile
//                                               damage apply
//   depends_on_temperature                           whether the temperature changes the strength
//   strength(plastic strain, rate, T*)          of a metal, Pa (return_mapping.hpp)
//   flow(solid, trial stress)                   of other solids: the flow of a step
#pragma once

#include "materials/drucker_prager.hpp"
#include "materials/j2_hardening.hpp"
#include "materials/johnson_cook_damage.hpp"
#include "materials/johnson_cook_strength.hpp"
#include "materials/laws.hpp"

namespace kerf {

// The law of solids that do not flow.
template <class T>
struct NoPlasticity {
  static constexpr std::string_view sentence = "No flow: the elastic law alone";
  static constexpr bool is_metal = true;  // the volume is that of the full deformation
  static constexpr bool depends_on_temperature = false;

  KERF_FUNCTION T first_strength() const { return T(0); }
  KERF_FUNCTION PlasticFlow<T> flow(const ElasticModuli<T>&, const MeridianStress<T>&) const {
    return PlasticFlow<T>::none();
  }

  template <class Other>
  KERF_FUNCTION static NoPlasticity from(const NoPlasticity<Other>&) {
    return {};
  }
  bool operator==(const NoPlasticity&) const = default;
};

KERF_DEFINE_LAW_SET(PlasticLawSet, PlasticLaw, KERF_PLASTIC_LAWS)

struct IsMetal {
  template <class Law>
  KERF_FUNCTION bool operator()(const Law&) const {
    return Law::is_metal;
  }
};
struct FirstStrength {
  template <class Law>
  KERF_FUNCTION auto operator()(const Law& law) const {
    return law.first_strength();
  }
};

template <class T>
struct PlasticParameters : PlasticLawSet<T> {
  PlasticLaw law = PlasticLaw::none;  // none: Hencky's elasticity
  JohnsonCookDamage<T> damage;        // of metals
  PlasticHeat<T> heat;                // of metals

  KERF_FUNCTION bool flows() const { return law != PlasticLaw::none; }
  // Strength q at first flow, cold, slow and free of pressure, Pa.
  KERF_FUNCTION T first_strength() const {
    return PlasticLawSet<T>::visit(*this, law, FirstStrength{});
  }
  // Flow keeps the volume.
  KERF_FUNCTION bool is_metal() const { return PlasticLawSet<T>::visit(*this, law, IsMetal{}); }
  // Whether ductile damage ends the material.
  KERF_FUNCTION bool can_break() const { return flows() && is_metal() && damage.is_on(); }

  // Works out what follows from the body: parameters of the law, heat capacity per volume.
  void derive(const BodyNumbers& body) {
    PlasticLawSet<T>::visit(*this, law, DeriveParameters{body});
    if (!flows() || !is_metal()) {
      heat = {};
      damage = {};
      return;
    }
    heat.capacity = body.density * heat.specific_capacity;
    PlasticLawSet<T>::visit(*this, law, [this](const auto& chosen) {
      if constexpr (requires { chosen.reference_rate; })
        damage.reference_rate = chosen.reference_rate;
    });
  }

  template <class Other>
  KERF_FUNCTION static PlasticParameters from(const PlasticParameters<Other>& other) {
    PlasticParameters parameters;
    static_cast<PlasticLawSet<T>&>(parameters) = PlasticLawSet<T>::from(other);
    parameters.law = other.law;
    parameters.damage = JohnsonCookDamage<T>::from(other.damage);
    parameters.heat = PlasticHeat<T>::from(other.heat);
    return parameters;
  }
  bool operator==(const PlasticParameters&) const = default;
};

// The elastic strain if nothing flows from the start of the step on. The volume of a metal is that
// of the full deformation: rounding of the metric, step after step, builds up no pressure.
template <int D, class T>
KERF_FUNCTION ElasticStrain<D, T> trial_strain(const PlasticParameters<T>& parameters,
                                               const Matrix<D, T>& h,
                                               const SymmetricTensor<D, T>& metric) {
  auto strain = ElasticStrain<D, T>::of(h, metric);
  if (parameters.is_metal()) strain.volume = log_volume(h);
  return strain;
}

template <int D, class T>
struct FlowOfLaw {
  const ElasticModuli<T>& solid;
  const PlasticHeat<T>& heat;
  const MeridianStress<T>& trial;
  T dt;  // s
  const PlasticState<D, T>& start;

  template <class Law>
  KERF_FUNCTION PlasticFlow<T> operator()(const Law& law) const {
    if constexpr (requires { law.flow(solid, trial); })
      return law.flow(solid, trial);
    else
      return metal_flow(ExcessStress<T, Law>{law, heat, trial.equivalent,
                                             T(3) * solid.shear_modulus, dt, start.plastic_strain,
                                             start.temperature_rise});
  }
};
// The flow of a step of `dt` from a state.
template <int D, class T>
KERF_FUNCTION PlasticFlow<T> flow_of(const ElasticModuli<T>& solid,
                                     const PlasticParameters<T>& parameters,
                                     const MeridianStress<T>& trial, T dt,
                                     const PlasticState<D, T>& start) {
  return PlasticLawSet<T>::visit(parameters, parameters.law,
                                 FlowOfLaw<D, T>{solid, parameters.heat, trial, dt, start});
}

// Adds a flow at the stress reached to the scalars of the state; returns the plastic work, J/m^3.
template <int D, class T>
KERF_FUNCTION T add_flow(const PlasticParameters<T>& parameters, const PlasticFlow<T>& flow,
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
KERF_FUNCTION T energy_density(const ElasticModuli<T>& solid,
                               const PlasticParameters<T>& parameters, const Matrix<D, T>& h,
                               const SymmetricTensor<D, T>& metric) {
  return trial_strain(parameters, h, metric).energy_density(solid);
}
template <int D, class T>
KERF_FUNCTION SymmetricTensor<D, T> second_piola(const ElasticModuli<T>& solid,
                                                 const PlasticParameters<T>& parameters,
                                                 const Matrix<D, T>& h,
                                                 const SymmetricTensor<D, T>& metric) {
  const auto strain = trial_strain(parameters, h, metric);
  return congruence(inverse(identity<D, T>() + h), strain.kirchhoff(solid));
}

// A step of `dt` (s; 0 = so slow that no rate counts) from the state `start` to the displacement
// gradient H = F - 1. It depends on its arguments alone and changes nothing else.
template <int D, class T>
KERF_FUNCTION PlasticResult<D, T> advance(const ElasticModuli<T>& solid,
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
    apply_flow(flow, inverse_gradient, strain, result.state.metric);
    const MeridianStress<T> stress{strain.equivalent_stress(solid), strain.mean_stress(solid)};
    result.plastic_work = add_flow(parameters, flow, stress, dt, result.state);
  }
  result.stored_energy = strain.energy_density(solid);
  result.stress = congruence(inverse_gradient, strain.kirchhoff(solid));  // S = F^-1 tau F^-T
  return result;
}

}  // namespace kerf
