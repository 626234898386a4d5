// SPDX-License-Identifier: Apache-2.0
// The heat of plastic work has no time to flow away: a share of the work (Taylor & Quinney, Proc.
// R. Soc. A 143 (1934) 307) warms the particle that does it, and nothing else warms it.
#pragma once

#include <vector>

#include "core/case_key.hpp"
#include "core/host_device.hpp"

namespace kerf {

template <class T>
struct PlasticHeat {
  T capacity = 0;               // J/(m^3 K), of the reference volume; 0 = its temperature stays
  T share = T(0.9);             // of the plastic work
  T start_temperature = 0;      // K
  T reference_temperature = 0;  // K, at and below which the strength was measured
  T melting_temperature = 0;    // K; 0 = temperature changes no strength
  T specific_capacity = 0;      // J/(kg K), from which the capacity follows

  // The keys of every metal.
  static std::vector<Key> rows() {
    using Law = PlasticHeat<double>;
    return {{"heat_capacity",
             ValueKind::quantity,
             "J/kg/K",
             "0 J/kg/K",
             key_range::not_negative,
             {},
             "",
             "Specific heat; 0 = plastic work warms nothing",
             stored_in<&Law::specific_capacity>},
            {"heat_share",
             ValueKind::number,
             "",
             "0.9",
             key_range::from_zero_to(1.0),
             {},
             "",
             "Part of the plastic work that becomes heat (Taylor & Quinney)",
             stored_in<&Law::share>}};
  }
  // The keys of the metals whose strength depends on the temperature.
  static std::vector<Key> temperature_rows() {
    using Law = PlasticHeat<double>;
    return {{"temperature",
             ValueKind::quantity,
             "K",
             "0 K",
             key_range::not_negative,
             {},
             "",
             "Temperature at the start",
             stored_in<&Law::start_temperature>},
            {"reference_temperature",
             ValueKind::quantity,
             "K",
             "0 K",
             key_range::not_negative,
             {},
             "",
             "Temperature at and below which heat takes nothing off the strength",
             stored_in<&Law::reference_temperature>},
            {"melting_temperature",
             ValueKind::quantity,
             "K",
             "0 K",
             key_range::not_negative,
             {},
             "",
             "Temperature at which no strength is left; 0 = temperature changes no strength",
             stored_in<&Law::melting_temperature>}};
  }

  KERF_FUNCTION T rise(T work) const {  // K
    return capacity > T(0) ? share * work / capacity : T(0);
  }
  // T* = (T - T_reference) / (T_melting - T_reference), within 0 and 1.
  KERF_FUNCTION T homologous_temperature(T temperature_rise) const {
    const T range = melting_temperature - reference_temperature;
    if (!(range > T(0))) return T(0);
    const T ratio = (start_temperature - reference_temperature + temperature_rise) / range;
    return ratio < T(0) ? T(0) : ratio > T(1) ? T(1) : ratio;
  }

  template <class Other>
  KERF_FUNCTION static PlasticHeat from(const PlasticHeat<Other>& other) {
    return {static_cast<T>(other.capacity),
            static_cast<T>(other.share),
            static_cast<T>(other.start_temperature),
            static_cast<T>(other.reference_temperature),
            static_cast<T>(other.melting_temperature),
            static_cast<T>(other.specific_capacity)};
  }
  bool operator==(const PlasticHeat&) const = default;
};

}  // namespace kerf
