// SPDX-License-Identifier: Apache-2.0
// Heat of plastic work that has no time to flow away: a share of the work (Taylor & Quinney, Proc.
// R. Soc. A 143 (1934) 307) warms the place where it is done, and nothing else does.
#pragma once

#include "exec/host_device.hpp"

namespace kerf {

template <class T>
struct PlasticHeat {
  T capacity = 0;               // J/(m^3 K), of the reference volume; 0 = stays as cold as it was
  T share = T(0.9);             // of the plastic work
  T start_temperature = 0;      // K
  T reference_temperature = 0;  // K, at and below which the strength was measured
  T melting_temperature = 0;    // K; 0 = temperature changes no strength

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
    return {static_cast<T>(other.capacity), static_cast<T>(other.share),
            static_cast<T>(other.start_temperature), static_cast<T>(other.reference_temperature),
            static_cast<T>(other.melting_temperature)};
  }
};

}  // namespace kerf
