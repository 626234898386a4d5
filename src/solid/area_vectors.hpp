// SPDX-License-Identifier: Apache-2.0
// AreaVectors finds the part of the surface that each particle of a solid stands for in its sums.
// Its forces in a uniform stress sigma (solid/bond_force.hpp) are sigma times
//   sum_j w_ij (B_i + B_j) R = - a_i,   a_i the area vector, outward, m^2 (2D: m),
// zero inside a lattice. They are those of a closed surface: sum_i a_i = 0 and
// sum_i X_i (x) a_i = V 1, the divergence theorem, because gradients of linear fields are exact.
// The force - p a_i by a pressure p all around therefore leaves the stress - p 1 everywhere.
#pragma once

#include <vector>

#include "solid/solid_fields.hpp"

namespace kerf {

template <int D, class P>
struct AreaVectors {
  using Real = typename P::Real;
  SolidView<D, P> solid;
  const std::uint16_t* body_of_medium;
  Vector<D, double>* area;
  std::uint8_t* joined;  // 1: to another body

  KERF_FUNCTION void operator()(Index i) const {
    area[i] = Vector<D, double>::zero();
    joined[i] = 0;
    for (Index k = solid.bonds.first(i); k < solid.bonds.last(i); ++k) {
      if (!solid.is_intact(i, k)) continue;
      const BondEnd j = solid.bond_end(i, k);
      const auto bond = solid.template reference_bond<double>(i, j);
      const Real weight = solid.weight(i, k, j, Vector<D, Real>::from(bond));
      const auto correction = weighted(i) + solid.image(j, weighted(j.particle));
      area[i] -= double(weight) * (correction * bond);
      if (body(i) != body(j.particle)) joined[i] = 1;
    }
  }

 private:
  KERF_FUNCTION std::uint16_t body(Index i) const { return body_of_medium[solid.medium_index[i]]; }
  KERF_FUNCTION Matrix<D, double> weighted(Index i) const {
    return double(solid.medium(i).reference_volume()) * solid.correction[i].matrix();
  }
};

// The surface of a solid at the start, by the number of the particle.
template <int D>
struct SurfaceOfSolid {
  std::vector<std::uint8_t> detached;
  std::vector<Vector<D, double>> area;  // of those that are not
  std::vector<std::uint8_t> joined;
};

template <int D, class P>
SurfaceOfSolid<D> surface_of(const SolidFields<D, P>& fields, const SolidView<D, P>& solid,
                             const std::vector<std::uint16_t>& body_of_medium) {
  Array<std::uint16_t> body;
  to_device(body_of_medium, body);
  Array<Vector<D, double>> area(solid.count);
  Array<std::uint8_t> joined(solid.count);
  for_each_index(solid.count,
                 AreaVectors<D, P>{solid, pointer(body), pointer(area), pointer(joined)});
  return {to_host(fields.detached), to_host(area), to_host(joined)};
}

}  // namespace kerf
