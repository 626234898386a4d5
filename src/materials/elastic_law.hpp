// SPDX-License-Identifier: Apache-2.0
// The elastic laws of the total Lagrangian solid. A medium chooses one of them by the word of the
// case file. A law is a function of Green's strain, so that a rotation changes nothing. Each has
// (core/law_list.hpp)
//   energy_density(moduli, green)   stored energy per reference volume, J/m^3
//   second_piola(moduli, green)     its derivative by Green's strain, Pa
//   is_expanded(green)              whether the part that the bulk modulus scales is in tension
// and where stretch makes its waves faster
//   largest_modulus(moduli, values) the largest second derivative of the energy by a principal
//                                   stretch, Pa, at the principal values of Green's strain
#pragma once

#include "materials/laws.hpp"
#include "materials/neo_hookean.hpp"
#include "materials/ogden.hpp"
#include "materials/st_venant_kirchhoff.hpp"

namespace kerf {

KERF_DEFINE_LAW_SET(ElasticLawSet, ElasticLaw, KERF_ELASTIC_LAWS)

// Moduli and elastic law of a solid.
template <class T>
struct ElasticSolid : ElasticModuli<T>, ElasticLawSet<T> {
  ElasticLaw elasticity = ElasticLaw::neo_hookean;

  template <class Other>
  KERF_FUNCTION static ElasticSolid from(const ElasticSolid<Other>& other) {
    ElasticSolid solid;
    static_cast<ElasticLawSet<T>&>(solid) = ElasticLawSet<T>::from(other);
    solid.elasticity = other.elasticity;
    solid.bulk_modulus = static_cast<T>(other.bulk_modulus);
    solid.shear_modulus = static_cast<T>(other.shear_modulus);
    return solid;
  }
};

// Stored energy per reference volume, J/m^3.
template <int D, class T>
KERF_FUNCTION T energy_density(const ElasticSolid<T>& solid, const SymmetricTensor<D, T>& green) {
  return ElasticLawSet<T>::visit(solid, solid.elasticity,
                                 [&](const auto& law) { return law.energy_density(solid, green); });
}

// Whether the part of the law that K scales is in tension.
template <int D, class T>
KERF_FUNCTION bool is_expanded(const ElasticSolid<T>& solid, const SymmetricTensor<D, T>& green) {
  return ElasticLawSet<T>::visit(solid, solid.elasticity,
                                 [&](const auto& law) { return law.is_expanded(green); });
}

// Second Piola-Kirchhoff stress S = dpsi/dE, Pa.
template <int D, class T>
KERF_FUNCTION SymmetricTensor<D, T> second_piola(const ElasticSolid<T>& solid,
                                                 const SymmetricTensor<D, T>& green) {
  return ElasticLawSet<T>::visit(solid, solid.elasticity,
                                 [&](const auto& law) { return law.second_piola(solid, green); });
}

template <class T>
struct WaveModulus {
  const ElasticSolid<T>& solid;
  const Vector<3, T>& green;
  template <class Law>
  KERF_FUNCTION T operator()(const Law& law) const {
    if constexpr (requires { law.largest_modulus(solid, green); })
      return law.largest_modulus(solid, green);
    else
      return T(0);
  }
};
// The modulus of the fastest waves along a principal axis at the principal values of Green's
// strain, in the reference configuration, over that without strain; 0 for a law that does not
// stiffen with stretch.
template <class T>
KERF_FUNCTION T wave_stiffening(const ElasticSolid<T>& solid, const Vector<3, T>& green) {
  const T modulus = ElasticLawSet<T>::visit(solid, solid.elasticity, WaveModulus<T>{solid, green});
  return modulus / (solid.bulk_modulus + T(4) / T(3) * solid.shear_modulus);
}
template <class T>
struct HasWaveModulus {
  template <class Law>
  KERF_FUNCTION bool operator()(const Law& law) const {
    return requires(const ElasticSolid<T>& solid, const Vector<3, T>& green) {
      law.largest_modulus(solid, green);
    };
  }
};
// Whether waves become faster with stretch.
template <class T>
KERF_FUNCTION bool stiffens_with_stretch(const ElasticSolid<T>& solid) {
  return ElasticLawSet<T>::visit(solid, solid.elasticity, HasWaveModulus<T>{});
}

// First Piola-Kirchhoff stress P = F S at the displacement gradient H = F - 1, Pa.
template <int D, class T>
KERF_FUNCTION Matrix<D, T> first_piola(const SymmetricTensor<D, T>& second, const Matrix<D, T>& h) {
  const Matrix<D, T> stress = in_plane(second);
  return stress + h * stress;
}

// Cauchy stress F S F^T / J, Pa, with its component out of the plane.
template <int D, class T>
KERF_FUNCTION SymmetricTensor<D, T> cauchy(const SymmetricTensor<D, T>& second,
                                           const Matrix<D, T>& h) {
  const T volume = std::sqrt(T(1) + volume_square_less_one(green_strain(h)));  // J
  const Matrix<D, T> first = first_piola(second, h);
  auto stress = SymmetricTensor<D, T>::zero();
  stress(2, 2) = second(2, 2) / volume;
  for (int a = 0; a < D; ++a)
    for (int b = a; b < D; ++b) {
      T sum = first(a, b);  // P F^T = P + P H^T
      for (int c = 0; c < D; ++c) sum += first(a, c) * h(b, c);
      stress(a, b) = sum / volume;
    }
  return stress;
}
// Cauchy stress of an elastic solid, Pa.
template <int D, class T>
KERF_FUNCTION SymmetricTensor<D, T> cauchy(const ElasticSolid<T>& solid, const Matrix<D, T>& h) {
  return cauchy(second_piola(solid, green_strain(h)), h);
}

}  // namespace kerf
