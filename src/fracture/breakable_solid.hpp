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
  T confinement = 0;       // c of compressive_strength.hpp, 1

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
    solid.confinement = static_cast<T>(other.confinement);
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

// What of the two ends of a bond between solids of unlike stiffness a criterion compares with the
// limits of one of them (solid/joint_bond.hpp): the mean stress, as it is or as a strain of this
// end, or a state of this end alone.
enum class AcrossJoint { strain, stress, end };

// The other keys of a material that a criterion needs and excludes.
struct CriterionKeys {
  StrainOrEnergy limit = StrainOrEnergy::one_of_them;
  bool excludes_plasticity = false;
  std::string_view compared_quantity = "the strain";  // compared with the limit
};

// psi_t at Green's strain `green` in the undamaged solid, J/m^3: the energy of shear, and that of
// the volume where it has grown; in double, because the energy is a small difference.
template <int D, class T>
KERF_FUNCTION double tensile_energy(const ElasticSolid<T>& solid,
                                    const SymmetricTensor<D, double>& green) {
  auto medium = ElasticSolid<double>::from(solid);
  if (!is_expanded(medium, green)) medium.bulk_modulus = 0.0;
  const double energy = energy_density(medium, green);
  return energy > 0.0 ? energy : 0.0;
}
// The energy of the volume where it is compressed, J/m^3.
template <int D, class T>
KERF_FUNCTION double compressed_energy(const ElasticSolid<T>& solid,
                                       const SymmetricTensor<D, double>& green) {
  auto medium = ElasticSolid<double>::from(solid);
  if (is_expanded(medium, green)) return 0.0;
  medium.shear_modulus = 0.0;
  const double energy = energy_density(medium, green);
  return energy > 0.0 ? energy : 0.0;
}

// Largest principal Kirchhoff stress of the undamaged solid at Green's strain `green`, Pa: tau has
// the principal values of C S.
template <int D, class T>
KERF_FUNCTION T largest_stress(const ElasticSolid<T>& solid, const SymmetricTensor<D, T>& green) {
  SymmetricTensor<D, T> c = T(2) * green;
  for (int a = 0; a < 3; ++a) c(a, a) += T(1);
  return largest_of(principal_values(coaxial_product(c, second_piola(solid, green))));
}

// What a confined solid keeps of the strain `tensile` below (compressive_strength.hpp), at the
// energy of shear and tension psi_t, J/m^3.
template <int D, class T>
KERF_FUNCTION double confined_strain(const BreakableSolid<T>& solid,
                                     const SymmetricTensor<D, double>& green, double tensile,
                                     double energy) {
  const double volume = std::sqrt(compressed_energy(solid, green)), shear = std::sqrt(energy);
  if (!(volume > 0.0)) return tensile;
  const double confined = tensile * (shear / (shear + double(solid.confinement) * volume));
  const double pulled =
      largest_stress(ElasticSolid<double>::from(solid), green) / double(solid.young_modulus());
  return pulled > confined ? pulled : confined;
}

// sqrt(2 psi_t / E): the strain of a tensile test that stores as much as tension does at Green's
// strain `green`, in the undamaged solid; less where the solid is confined.
template <int D, class T>
KERF_FUNCTION T tensile_strain(const BreakableSolid<T>& solid,
                               const SymmetricTensor<D, double>& green) {
  const double energy = tensile_energy(solid, green);
  if (!(energy > 0.0)) return T(0);
  const double strain = std::sqrt(2.0 * energy / double(solid.young_modulus()));
  const bool is_confined = solid.confinement > T(0);
  return static_cast<T>(is_confined ? confined_strain(solid, green, strain, energy) : strain);
}

// The same at the displacement gradient `h`.
template <int D, class T>
KERF_FUNCTION T tensile_strain(const BreakableSolid<T>& solid, const Matrix<D, T>& h) {
  return tensile_strain(solid, green_strain(Matrix<D, double>::from(h)));
}

// A particle of an elastic solid at Green's strain `green` and with the damage `damage`.
template <int D, class T>
struct ElasticParticle {
  const BreakableSolid<T>& solid;
  const SymmetricTensor<D, T>& green;
  T damage = T(0);

  KERF_FUNCTION T largest_stress() const { return kerf::largest_stress(solid, green); }
  KERF_FUNCTION T tensile_strain() const {
    return kerf::tensile_strain(solid, SymmetricTensor<D, double>::from(green));
  }
};

}  // namespace kerf
