// SPDX-License-Identifier: Apache-2.0
// CompressiveStrength is the strength in compression of a solid that softens (softening.hpp). The
// energy psi_t that softening takes from consists of that of shear and of tension by volume, and so
// a solid whose limit is that energy alone would fail in compression at hardly more than its
// tensile strength,  f_t sqrt(3 G / E) = f_t sqrt(3 / (2 (1 + nu))).  Pressure holds the faces of
// shear cracks together: where the volume is compressed, and stores psi_p, the strain that drives
// softening is less than that of the energy psi_s of shear,
//   k = sqrt(2 psi_s / E) sqrt(psi_s) / (sqrt(psi_s) + c sqrt(psi_p)).
// In a uniaxial compressive test, psi_s = s^2 / (6 G) and psi_p = s^2 / (18 K) at the stress s.
// Softening begins there at the compressive strength f_c if
//   c = sqrt(3 K / G) (f_c / f_t sqrt(E / (3 G)) - 1).
// Pressure does not hold a crack together that the largest principal stress s_1 opens across it, so
// that k is at least s_1 / E, as in a tensile test (Rankine's limit of tension). Where the volume
// is compressed psi_s is more than (3/4) (1 + nu) s_1^2 / E: the strain never jumps, and psi_t is
// above E k^2 / 2.
#pragma once

#include <cmath>
#include <vector>

#include "core/case_key.hpp"
#include "materials/elastic_moduli.hpp"

namespace kerf {

template <class T>
struct CompressiveStrength {
  T compressive_strength = 0;  // f_c, Pa; 0 = not given

  static std::vector<Key> rows() {
    return {{"compressive_strength",
             ValueKind::quantity,
             "Pa",
             "0 Pa",
             key_range::not_negative,
             {},
             "",
             "Stress at which a cylinder or cube fails in compression; 0 = that of shear and "
             "tension alone, 1.0 to 1.2 times the tensile strength",
             stored_in<&CompressiveStrength<double>::compressive_strength>}};
  }
  KERF_FUNCTION bool is_on() const { return compressive_strength > T(0); }
  bool operator==(const CompressiveStrength&) const = default;
};

// f_c over f_t without c.
inline double least_compressive_ratio(const ElasticModuli<double>& moduli) {
  return std::sqrt(3.0 * moduli.shear_modulus / moduli.young_modulus());
}

// c, 1; `ratio`: f_c / f_t.
inline double confinement_of(const ElasticModuli<double>& moduli, double ratio) {
  const double more = ratio / least_compressive_ratio(moduli) - 1.0;
  return more > 0.0 ? std::sqrt(3.0 * moduli.bulk_modulus / moduli.shear_modulus) * more : 0.0;
}

}  // namespace kerf
