// SPDX-License-Identifier: Apache-2.0
// The solid of Gent (Rubber Chem. Technol. 69 (1996) 59) stiffens without bound where
// J^(-2/3) tr C - 3 approaches the limit J_m:
//   psi = - G J_m / 2 ln(1 - X / J_m) + K/2 [(J^2 - 1)/2 - ln J],   X = J^(-2/3) tr C - 3.
// For J_m to infinity it is the neo-Hookean solid, whose stress its isochoric part scales by
// 1 / (1 - X / J_m).
#pragma once

#include <cmath>
#include <string_view>
#include <vector>

#include "core/case_key.hpp"
#include "materials/neo_hookean.hpp"

namespace kerf {

template <class T>
struct Gent {
  T limit = T(100);  // J_m, 1

  static constexpr std::string_view sentence =
      "Rubber that stiffens without bound at a limit of its chains, after Gent";
  static std::vector<Key> rows() {
    return {{"chain_limit",
             ValueKind::number,
             "",
             "100",
             key_range::positive,
             {},
             "",
             "J_m of Gent's law, the value of J^(-2/3) tr C - 3 that no strain reaches",
             stored_in<&Gent<double>::limit>}};
  }

  // psi, J/m^3.
  template <int D>
  KERF_FUNCTION T energy_density(const ElasticModuli<T>& moduli,
                                 const SymmetricTensor<D, T>& green) const {
    const T half_shear = T(0.5) * moduli.shear_modulus;
    const T chains = isochoric(green);
    return NeoHookean<T>{}.energy_density(moduli, green) - half_shear * chains -
           half_shear * limit * std::log1p(-chains / limit);
  }

  // Second Piola-Kirchhoff stress, Pa.
  template <int D>
  KERF_FUNCTION SymmetricTensor<D, T> second_piola(const ElasticModuli<T>& moduli,
                                                   const SymmetricTensor<D, T>& green) const {
    ElasticModuli<T> stiffened = moduli;
    stiffened.shear_modulus = moduli.shear_modulus / (T(1) - isochoric(green) / limit);
    return NeoHookean<T>{}.second_piola(stiffened, green);
  }

  template <int D>
  KERF_FUNCTION bool is_expanded(const SymmetricTensor<D, T>& green) const {
    return NeoHookean<T>{}.is_expanded(green);
  }

  template <class Other>
  KERF_FUNCTION static Gent from(const Gent<Other>& other) {
    return {static_cast<T>(other.limit)};
  }
  bool operator==(const Gent&) const = default;

 private:
  // X = J^(-2/3) tr C - 3.
  template <int D>
  KERF_FUNCTION static T isochoric(const SymmetricTensor<D, T>& green) {
    const T log_square = std::log1p(volume_square_less_one(green));  // 2 ln J
    return T(3) * std::expm1(-log_square / T(3)) +
           T(2) * std::exp(-log_square / T(3)) * trace(green);
  }
};

}  // namespace kerf
