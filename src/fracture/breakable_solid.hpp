// SPDX-License-Identifier: Apache-2.0
// An elastic solid with limits of strain, and what a fracture criterion may ask of a particle of
// it.
#pragma once

#include <cmath>
#include <string_view>

#include "materials/damaged.hpp"

namespace kerf {

template <class T>
struct BreakableSolid : ElasticSolid<T> {
  T failure_strain = 0;    // 1, of the criterion; 0 = never breaks by a strain
  T softening_strain = 0;  // 1, where softening begins (softening.hpp); 0 = brittle

  // Whether this strain of a particle passes the limit, if there is one.
  KERF_FUNCTION bool fails_at(T strain) const {
    return failure_strain > T(0) && strain > failure_strain;
  }
  KERF_FUNCTION bool softens() const { return softening_strain > T(0); }

  template <class Other>
  KERF_FUNCTION static BreakableSolid from(const BreakableSolid<Other>& other) {
    BreakableSolid solid;
    static_cast<ElasticSolid<T>&>(solid) = ElasticSolid<T>::from(other);
    solid.failure_strain = static_cast<T>(other.failure_strain);
    solid.softening_strain = static_cast<T>(other.softening_strain);
    return solid;
  }
};

// The largest of three principal values.
template <class T>
KERF_FUNCTION T largest_of(const Vector<3, T>& values) {
  const T larger = values[0] > values[1] ? values[0] : values[1];
  return larger > values[2] ? larger : values[2];
}

// Which of the keys failure_strain and fracture_energy a criterion takes.
enum class StrainOrEnergy { one_of_them, both, energy, neither };

// The other keys of a material that a criterion needs and excludes.
struct CriterionKeys {
  StrainOrEnergy limit = StrainOrEnergy::one_of_them;
  bool excludes_plasticity = false;
  std::string_view compared_quantity = "the strain";  // compared with the limit
};

// sqrt(2 psi_t / E): the strain of a tensile test that stores as much as tension does at Green's
// strain `green`, in the undamaged solid; in double, because the energy is a small difference.
template <int D, class T>
KERF_FUNCTION T tensile_strain(const ElasticSolid<T>& solid,
                               const SymmetricTensor<D, double>& green) {
  auto medium = ElasticSolid<double>::from(solid);
  if (!is_expanded(medium, green)) medium.bulk_modulus = 0.0;
  const double energy = energy_density(medium, green);
  return energy > 0.0 ? static_cast<T>(std::sqrt(2.0 * energy / double(solid.young_modulus())))
                      : T(0);
}

// The same at the displacement gradient `h`.
template <int D, class T>
KERF_FUNCTION T tensile_strain(const ElasticSolid<T>& solid, const Matrix<D, T>& h) {
  return tensile_strain(solid, green_strain(Matrix<D, double>::from(h)));
}

// A particle of an elastic solid at Green's strain `green` and with the damage `damage`.
template <int D, class T>
struct ElasticParticle {
  const BreakableSolid<T>& solid;
  const SymmetricTensor<D, T>& green;
  T damage = T(0);

  // Largest principal Kirchhoff stress, Pa: tau has the principal values of C S.
  KERF_FUNCTION T largest_stress() const {
    SymmetricTensor<D, T> c = T(2) * green;
    for (int a = 0; a < 3; ++a) c(a, a) += T(1);
    return largest_of(principal_values(coaxial_product(c, second_piola(solid, green))));
  }
  KERF_FUNCTION T tensile_strain() const {
    return kerf::tensile_strain(solid, SymmetricTensor<D, double>::from(green));
  }
};

}  // namespace kerf
