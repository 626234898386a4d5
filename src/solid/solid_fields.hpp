// SPDX-License-Identifier: Apache-2.0
// What the total Lagrangian solid keeps per particle and per bond. State: the weights and `loose`;
// everything else follows from these and from where the particles are.
#pragma once

#include "core/matrix.hpp"
#include "core/precision.hpp"
#include "exec/exec.hpp"
#include "solid/solid_medium.hpp"

namespace kerf {

// Every pair i, j of one piece that is closer than 2 h in the reference configuration is a bond. It
// stands in the lists of both, with one weight,
//   w_ij = f_ij V_i V_j |W'(R_ij)| / R_ij,   R_ij = |X_i - X_j|,   in m (2D: 1),
// in which f_ij is the share of the bond that is whole: 1, or 0 where it broke. A weight is all
// that the sums need, since V_i V_j grad_0 W_ij = w_ij (X_j - X_i): gradients cost no memory.
template <int D, class P>
struct SolidView {
  using Real = typename P::Real;
  Index count;
  const SolidMedium<Real>* media;
  const std::uint16_t* medium_index;
  const Vector<D, double>* reference;  // X, m
  const Index* bond_begin;             // bonds of i: bond_begin[i] .. bond_begin[i + 1]
  const Index* neighbour;
  Real* weight;                     // w_ij
  std::uint8_t* loose;              // 1: holds on to nothing, carries no stress; debris
  std::uint8_t* changed;            // 1: its correction is outdated
  Vector<D, double>* displacement;  // u = x - X, m
  Matrix<D, Real>* correction;      // B_i / V_i, 1/m^D
  Matrix<D, Real>* gradient;        // H = F - 1
  Matrix<D, Real>* traction;        // A = (P B) - mu H, Pa; see deform.hpp
  Real* criterion;                  // of the fracture criterion, per particle
  Vector<D, Real>* acceleration;    // m/s^2
  Real* viscous_power;              // W, dissipated by the bond viscosity
  double* elastic_energy;           // J (2D: J/m)
  double* hourglass_energy;         // J (2D: J/m)

  KERF_FUNCTION const SolidMedium<Real>& medium(Index i) const { return media[medium_index[i]]; }
  // X_j - X_i, m.
  KERF_FUNCTION Vector<D, Real> reference_bond(Index i, Index j) const {
    return Vector<D, Real>::from(reference[j] - reference[i]);
  }
  // u_j - u_i, m: differences in double, so that a body far from home loses no digits.
  KERF_FUNCTION Vector<D, Real> displacement_bond(Index i, Index j) const {
    return Vector<D, Real>::from(displacement[j] - displacement[i]);
  }
};

template <int D, class P>
struct SolidFields {
  using Real = typename P::Real;
  Array<SolidMedium<Real>> media;
  Array<std::uint16_t> medium_index;
  Array<Vector<D, double>> reference;
  Array<Index> bond_begin, neighbour;
  Array<Real> weight;
  Array<std::uint8_t> loose, changed;
  Array<Vector<D, double>> displacement;
  Array<Matrix<D, Real>> correction, gradient, traction;
  Array<Real> criterion;
  Array<Vector<D, Real>> acceleration;
  Array<Real> viscous_power;
  Array<double> elastic_energy, hourglass_energy;

  Index size() const { return static_cast<Index>(reference.size()); }

  // Calls visit(array) for each array that has one entry per particle and is not given at set-up.
  template <class Visit>
  void for_each_result(Visit&& visit) {
    visit(loose), visit(changed), visit(displacement), visit(correction), visit(gradient);
    visit(traction), visit(criterion), visit(acceleration), visit(viscous_power);
    visit(elastic_energy), visit(hourglass_energy);
  }

  std::size_t bytes() const {
    return bytes_of(media) + bytes_of(medium_index) + bytes_of(reference) + bytes_of(bond_begin) +
           bytes_of(neighbour) + bytes_of(weight) + bytes_of(loose) + bytes_of(changed) +
           bytes_of(displacement) + bytes_of(correction) + bytes_of(gradient) + bytes_of(traction) +
           bytes_of(criterion) + bytes_of(acceleration) + bytes_of(viscous_power) +
           bytes_of(elastic_energy) + bytes_of(hourglass_energy);
  }

  SolidView<D, P> view() {
    return {size(),
            pointer(media),
            pointer(medium_index),
            pointer(reference),
            pointer(bond_begin),
            pointer(neighbour),
            pointer(weight),
            pointer(loose),
            pointer(changed),
            pointer(displacement),
            pointer(correction),
            pointer(gradient),
            pointer(traction),
            pointer(criterion),
            pointer(acceleration),
            pointer(viscous_power),
            pointer(elastic_energy),
            pointer(hourglass_energy)};
  }

 private:
  template <class T>
  static std::size_t bytes_of(const Array<T>& array) {
    return array.size() * sizeof(T);
  }
};

}  // namespace kerf
