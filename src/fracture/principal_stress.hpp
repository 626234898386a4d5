// SPDX-License-Identifier: Apache-2.0
// Largest principal stress (Rankine's criterion), Kirchhoff's. Of the bonds at a place where it
// passes the tensile strength f_t those break that are opening (bond_strain.hpp) and stretched by
// at least a quarter of f_t / E, so that those along the crack hold. A bond whose own strain is
// above f_t / (2 G) breaks too: in a uniform tension or shear its place passes no later. The energy
// that a crack takes is in proportion to the spacing; only a fracture_energy makes it the
// material's.
#pragma once

#include "fracture/bond_strain.hpp"
#include "materials/elastic_law.hpp"

namespace kerf {

struct PrincipalStress {
  // Pa.
  template <int D, class T>
  KERF_FUNCTION static T largest(const SymmetricTensor<D, T>& stress) {
    const Vector<3, T> values = principal_values(stress);
    const T larger = values[0] > values[1] ? values[0] : values[1];
    return larger > values[2] ? larger : values[2];
  }
  // Of an elastic solid: tau has the principal values of C S.
  template <int D, class T>
  KERF_FUNCTION static T prepare(const SolidMedium<T>& solid, const SymmetricTensor<D, T>& green) {
    if (!(solid.tensile_strength > T(0))) return T(0);
    SymmetricTensor<D, T> c = T(2) * green;
    for (int a = 0; a < 3; ++a) c(a, a) += T(1);
    return largest(coaxial_product(c, second_piola(solid, green)));
  }

  template <class T>
  KERF_FUNCTION static bool passes(T prepared, const SolidMedium<T>& solid) {
    return solid.tensile_strength > T(0) && prepared > solid.tensile_strength;
  }

  template <class T>
  KERF_FUNCTION static bool breaks(const BondStrain<T>& bond, const SolidMedium<T>& solid) {
    if (!(solid.tensile_strength > T(0))) return false;
    if (is_above(bond.own, solid.tensile_strength / (T(2) * solid.shear_modulus))) return true;
    const T part = T(0.25) * solid.tensile_strength / solid.young_modulus();
    return passes(bond.prepared, solid) && bond.mean > T(2) * part && bond.is_opening();
  }
};

}  // namespace kerf
