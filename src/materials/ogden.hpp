// SPDX-License-Identifier: Apache-2.0
// The solid of Ogden (Proc. R. Soc. A 326 (1972) 565) with one term stiffens with stretch, as skin,
// other soft tissues and rubber do (Shergold, Fleck & Radford, Int. J. Impact Eng. 32 (2006) 1384),
//   psi = 2 G / alpha^2 (b_1^alpha + b_2^alpha + b_3^alpha - 3) + K/2 [(J^2 - 1)/2 - ln J],
// with b_k = J^(-1/3) lambda_k of the principal stretches lambda_k, and the part by the volume of
// materials/neo_hookean.hpp, whose law it is for alpha = 2. Principal values of Kirchhoff's stress:
//   tau_k = 2 G / alpha (b_k^alpha - mean of b^alpha) + K/2 (J^2 - 1),   S_k = tau_k / lambda_k^2.
#pragma once

#include <cmath>
#include <string_view>
#include <vector>

#include "core/case_key.hpp"
#include "core/principal_frame.hpp"
#include "materials/elastic_moduli.hpp"
#include "materials/finite_strain.hpp"

namespace kerf {

template <class T>
struct Ogden {
  T exponent = 2;  // alpha, 1

  static constexpr std::string_view sentence =
      "Solid of Ogden with one term, for tissue and rubber that stiffen with stretch";
  static std::vector<Key> rows() {
    return {{"ogden_exponent",
             ValueKind::number,
             "",
             "",
             {1.0, 30.0},
             {},
             "",
             "alpha of the energy 2 G / alpha^2 (sum of the stretches^alpha - 3): 2 is the "
             "neo-Hookean solid, and the greater it is the more stretch stiffens",
             stored_in<&Ogden<double>::exponent>}};
  }

  // psi, J/m^3.
  template <int D>
  KERF_FUNCTION T energy_density(const ElasticModuli<T>& moduli,
                                 const SymmetricTensor<D, T>& green) const {
    const Stretches stretches =
        stretches_at(volume_square_less_one(green), principal_values(green));
    return T(2) * moduli.shear_modulus / (exponent * exponent) * T(3) * stretches.mean +
           T(0.25) * moduli.bulk_modulus * (stretches.growth - stretches.log_square);
  }

  // Second Piola-Kirchhoff stress, Pa.
  template <int D>
  KERF_FUNCTION SymmetricTensor<D, T> second_piola(const ElasticModuli<T>& moduli,
                                                   const SymmetricTensor<D, T>& green) const {
    const auto frame = PrincipalFrame<D, T>::of(green);
    const Stretches stretches = stretches_at(volume_square_less_one(green), frame.value);
    Vector<3, T> stress;
    for (int k = 0; k < 3; ++k)
      stress[k] = kirchhoff(moduli, stretches, k) / (T(1) + T(2) * frame.value[k]);
    return frame.tensor(stress);
  }

  // Whether the part of the energy that K scales is one of expansion.
  template <int D>
  KERF_FUNCTION bool is_expanded(const SymmetricTensor<D, T>& green) const {
    return volume_square_less_one(green) > T(0);
  }

  // The largest d^2 psi / d lambda_k^2 at the principal values of Green's strain, Pa: the modulus
  // of the fastest waves along a principal axis, in the reference configuration. With the
  // derivative lambda_k d/dlambda_k, twice, of psi,
  //   M_k lambda_k^2 = 2 G (4/9 b_k^alpha + 1/9 sum of the others) + K J^2 - tau_k.
  KERF_FUNCTION T largest_modulus(const ElasticModuli<T>& moduli, const Vector<3, T>& green) const {
    T volume_square = T(1);
    for (int k = 0; k < 3; ++k) volume_square *= T(1) + T(2) * green[k];
    const Stretches stretches = stretches_at(volume_square - T(1), green);
    T largest = T(0);
    for (int k = 0; k < 3; ++k) {
      const T sum = T(3) * (T(1) + stretches.mean), own = T(1) + stretches.power[k];
      const T second = T(2) * moduli.shear_modulus * (own / T(3) + sum / T(9)) +
                       moduli.bulk_modulus * volume_square;
      const T modulus = (second - kirchhoff(moduli, stretches, k)) / (T(1) + T(2) * green[k]);
      largest = modulus > largest ? modulus : largest;
    }
    return largest;
  }

  template <class Other>
  KERF_FUNCTION static Ogden from(const Ogden<Other>& other) {
    return {static_cast<T>(other.exponent)};
  }
  bool operator==(const Ogden&) const = default;

 private:
  struct Stretches {
    T growth, log_square;  // J^2 - 1, 2 ln J
    Vector<3, T> power;    // b_k^alpha - 1
    T mean;                // of these
  };
  KERF_FUNCTION Stretches stretches_at(T growth, const Vector<3, T>& green) const {
    Stretches stretches;
    stretches.growth = growth;
    stretches.log_square = std::log1p(growth);
    for (int k = 0; k < 3; ++k) {
      const T log_stretch = T(0.5) * std::log1p(T(2) * green[k]) - stretches.log_square / T(6);
      stretches.power[k] = std::expm1(exponent * log_stretch);
    }
    stretches.mean = (stretches.power[0] + stretches.power[1] + stretches.power[2]) / T(3);
    return stretches;
  }
  KERF_FUNCTION T kirchhoff(const ElasticModuli<T>& moduli, const Stretches& stretches,
                            int k) const {
    return T(2) * moduli.shear_modulus / exponent * (stretches.power[k] - stretches.mean) +
           T(0.5) * moduli.bulk_modulus * stretches.growth;
  }
};

}  // namespace kerf
