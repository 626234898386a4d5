// SPDX-License-Identifier: Apache-2.0
// These functions are the terms that a bond adds to the sums of its particle i. Each is written
// once, for one number (the general loops over bonds, which run on GPUs too) and for a register of
// numbers (the SIMD kernels, solid/simd/bond_kernel.hpp). With R = X_j - X_i, the weight w_ij of
// solid/bond_weight.hpp and the displacement u = x - X the sums are
//   H_i V_i B_i^-1 = sum_j w_ij (u_j - u_i) (x) R              (solid/deformation_gradient.hpp),
//   m_i a_i = sum_j w_ij [(A_i + A_j) R + (mu_i + mu_j) (u_j - u_i)]    (solid/bond_force.hpp),
// and the viscosity of the bonds.
#pragma once

#include "core/matrix.hpp"
#include "core/select.hpp"

namespace kerf {

// Returns u_j - u_i along one axis, m, from displacements in two parts
// (solid/simd/packed_bonds.hpp): differences of both, so that no digits are lost far from the
// initial position.
template <class T>
KERF_FORMULA T displacement_difference(T displacement_i, T remainder_i, T displacement_j,
                                       T remainder_j) {
  return (displacement_j - displacement_i) + (remainder_j - remainder_i);
}

// The geometry of a bond that its terms need.
template <int D, class T>
struct BondGeometry {
  Vector<D, T> reference;  // R, m
  Vector<D, T> change;     // u_j - u_i, m
  T weight;                // w_ij, 0 where it is broken
};

// Adds w (u_j - u_i) (x) R.
template <int D, class T>
KERF_FORMULA void add_bond_gradient(Matrix<D, T>& sum, const BondGeometry<D, T>& bond) {
  add_outer(sum, bond.change, bond.weight * bond.reference);
}

// Adds a bond to the moments (solid/simd/packed_bonds.hpp): `weighted`, w R, and `stiffness`, w
// times `hourglass`, in the precision of the other sums.
template <class Moments, int D, class Real>
KERF_FORMULA void add_bond_moments(Moments& moments, const Vector<D, Real>& reference,
                                   const Vector<D, Real>& weighted, Real stiffness,
                                   Real hourglass) {
  const auto bond = Vector<D, double>::from(reference);
  add_outer(moments.of_gradient, bond, Vector<D, double>::from(weighted));
  add_outer(moments.of_hourglass, (double(stiffness) / double(hourglass)) * bond, bond);
}
// Returns |R + u_j - u_i|^2 - |R|^2 = (2 R + u) . u, m^2, without the cancellation.
template <int D, class T>
KERF_FORMULA T square_growth(const Vector<D, T>& reference, const Vector<D, T>& change) {
  T sum(0);
  for (int a = 0; a < D; ++a) sum += (T(2) * reference[a] + change[a]) * change[a];
  return sum;
}

// Adds the elastic force and that of the hourglass control: w [A R + mu (u_j - u_i)] with
// A = A_i + A_j and mu = mu_i + mu_j.
template <int D, class T>
KERF_FORMULA void add_bond_force(Vector<D, T>& force, const BondGeometry<D, T>& bond,
                                 const Matrix<D, T>& traction, T hourglass) {
  const T stiffness = bond.weight * hourglass;
  const Vector<D, T> weighted = bond.weight * bond.reference;
  for (int a = 0; a < D; ++a) {
    force[a] += stiffness * bond.change[a];
    for (int b = 0; b < D; ++b) force[a] += traction(a, b) * weighted[b];
  }
}

// The viscosity of bonds that shorten, along their line of centres (Monaghan, J. Comput. Phys. 82
// (1989) 1), with the kernel and the distance of the reference configuration:
//   q_ij = rho (A c theta + B theta^2),   theta = -h (v_ij . x_ij) / (|x_ij| R) > 0,
// h: mean; rho c, rho: harmonic means; A, B: geometric means; c: the longitudinal wave.
template <class T>
struct BondViscosityLaw {
  T density, length;  // rho, kg/m^3; h, m
  T linear;           // A c, m/s
  T quadratic;        // B, 1
};

// Subtracts the force w R q along the line of centres from `force`, and adds half of the power that
// the bond dissipates. `velocity`: v_j - v_i, m/s; `per_length`: 1 / R. R cancels in w R q but for
// the quadratic part.
template <int D, class T, class Number>
KERF_FORMULA void add_bond_viscosity(Vector<D, T>& force, T& power, const BondGeometry<D, T>& bond,
                                     const Vector<D, T>& velocity, T per_length,
                                     const BondViscosityLaw<Number>& law) {
  Vector<D, T> line;
  T length_squared(0), along(0);
  for (int a = 0; a < D; ++a) {
    line[a] = bond.reference[a] + bond.change[a];
    length_squared += line[a] * line[a];
    along += velocity[a] * line[a];
  }
  const auto shortens = along < T(0) && length_squared > T(0);
  const T inverse = reciprocal_square_root(select(shortens, length_squared, T(1)));
  const T speed = select(shortens, -along * inverse, T(0));
  const T theta = T(law.length) * speed * per_length;
  const T damping = bond.weight * T(law.density * law.length) * speed *
                    (T(law.linear) + T(law.quadratic) * theta);  // N
  for (int a = 0; a < D; ++a) force[a] -= damping * inverse * line[a];
  power += T(0.5F) * damping * speed;
}

}  // namespace kerf
