// SPDX-License-Identifier: Apache-2.0
// StrengthRate makes the strength of a solid that may break grow with the rate of strain, as a
// power of it (for bone Carter & Hayes, Science 194 (1976) 1174):
//   R = (rate / rate_0)^n  between the rates rate_0 and rate_1,  1 below, R(rate_1) above.
// All limits of strain and stress of the fracture criterion are multiplied by R, so that the
// strength grows with R and the fracture energy with R^2 (docs/theory/strength_rate.md).
//
// The rate of a particle is that of a tensile test: the mean rate of its tensile strain k
// (fracture/breakable_solid.hpp) since the present loading has passed a tenth of the strain e_0 at
// which the material fails slowly,
//   rate = (k - e_0 / 10) / t.
// It has no delay, a wave that passes does not disturb it, and in a constant rate of strain it is
// that rate. A load that rests makes it fall, and R with it, down to the slow strength.
#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include "core/case_key.hpp"
#include "core/host_device.hpp"

namespace kerf {

// The loading of a particle so far.
template <class T>
struct Loading {
  T strain = T(0);  // k, 1
  T time = T(0);    // s, since k has passed the onset
  T factor = T(1);  // R
};

template <class T>
struct StrengthRate {
  static constexpr T onset = T(0.1);  // of e_0
  // The parameters of a case.
  T exponent = 0;                                        // n, 1; 0 = none
  T reference_rate = 0;                                  // rate_0, 1/s
  T greatest_rate = std::numeric_limits<T>::infinity();  // rate_1, 1/s

  static std::vector<Key> rows() {
    using Law = StrengthRate<double>;
    return {{"strength_rate_exponent",
             ValueKind::number,
             "",
             "0",
             key_range::from_zero_to(1.0),
             {},
             "",
             "n of the factor (rate / strength_reference_rate)^n by which strength grows with the "
             "rate of strain; the fracture energy grows by its square; 0 = not at all",
             stored_in<&Law::exponent>},
            {"strength_reference_rate",
             ValueKind::quantity,
             "s-1",
             "0 s-1",
             key_range::not_negative,
             {},
             "",
             "Rate of strain at which the limits of the material were measured; below it strength "
             "stays; needed with a strength_rate_exponent",
             stored_in<&Law::reference_rate>},
            {"strength_greatest_rate",
             ValueKind::quantity,
             "s-1",
             "none",
             key_range::positive,
             {},
             "",
             "Rate of strain above which strength grows no more, such as the greatest that was "
             "measured",
             stored_in<&Law::greatest_rate>}};
  }

  KERF_FUNCTION bool is_on() const { return exponent > T(0); }

  // R at a rate, 1/s.
  KERF_FUNCTION T factor(T rate) const {
    const T bounded = rate < greatest_rate ? rate : greatest_rate;
    return bounded > reference_rate ? std::pow(bounded / reference_rate, exponent) : T(1);
  }

  // The loading `dt` after `start`, s, at the tensile strain k; e_0: `slow_strain`. Without time
  // (dt = 0) R is that of the start.
  KERF_FUNCTION Loading<T> advance(const Loading<T>& start, T strain, T dt, T slow_strain) const {
    const T from = onset * slow_strain;
    if (!(strain > from)) return {strain, T(0), T(1)};
    const T part = start.strain > from ? T(1) : (strain - from) / (strain - start.strain);
    const T time = (start.strain > from ? start.time : T(0)) + part * dt;
    return {strain, time, dt > T(0) ? factor((strain - from) / time) : start.factor};
  }
  // The same of a solid that softens from e_0 on, whose largest strain so far was `largest` at the
  // start. Once it is damaged (k > R e_0) R remains, and until then R e_0 is not below that strain:
  // a change of R alone damages nothing.
  KERF_FUNCTION Loading<T> advance_softening(const Loading<T>& start, T strain, T dt, T slow_strain,
                                             T largest) const {
    Loading<T> now = advance(start, strain, dt, slow_strain);
    const T reached = largest / slow_strain;
    if (reached > start.factor)
      now.factor = start.factor;
    else if (now.factor < reached)
      now.factor = reached;
    return now;
  }

  template <class Other>
  KERF_FUNCTION static StrengthRate from(const StrengthRate<Other>& other) {
    return {static_cast<T>(other.exponent), static_cast<T>(other.reference_rate),
            static_cast<T>(other.greatest_rate)};
  }
  bool operator==(const StrengthRate&) const = default;
};

}  // namespace kerf
