// SPDX-License-Identifier: Apache-2.0
// What the ends of bonds need to know of one another, packed so that an end is one load, and the
// walks over the bonds of particles whose bonds are all within one medium: the sums of
// solid/deform.hpp and solid/bond_force.hpp, several bonds at a time.
#pragma once

#include "core/matrix.hpp"
#include "lanes/packed_place.hpp"

namespace kerf {

template <int D, class Real>
struct alignas(4 * sizeof(Real)) PackedBondEnd {
  using Place = typename PackedNumber<Real>::Place;
  static constexpr int reference_slot = 0, displacement_slot = D, remainder_slot = 2 * D,
                       geometry_slots = 3 * D, velocity_slot = 3 * D, traction_slot = 4 * D,
                       hourglass_slot = 4 * D + D * D;
  static constexpr int slots = (hourglass_slot + 4) / 4 * 4;
  Place reference[D];  // X
  // u = x - X in two parts: their differences are as exact as those in double precision, so that a
  // small strain far from home is seen.
  Real displacement[D], remainder[D];
  Real velocity[D];      // m/s
  Real traction[D * D];  // A of deform.hpp, Pa
  Real hourglass;        // mu, Pa
  Real unused[slots - hourglass_slot - 1];
};

// The viscosity of bonds within one medium: q = density (linear theta + quadratic theta^2), with
// theta = length v_n / R (solid/bond_force.hpp).
template <class Real>
struct BondLaw {
  Real density, length;  // kg/m^3; m
  Real linear;           // A c, m/s
  Real quadratic;        // B, 1
};

// sum w (u_j - u_i) (x) R, and the largest |x|^2 / R^2 - 1.
template <int D, class Real>
struct BondGradient {
  Matrix<D, Real> sum;
  Real stretch;
};
template <int D, class Real>
struct BondPush {
  Vector<D, Real> force;  // N
  Real power;             // W, dissipated
};

template <int D, class Real>
struct BondWalkTask {
  const PackedBondEnd<D, Real>* ends = nullptr;
  const std::uint32_t* begin = nullptr;
  const std::uint32_t* neighbour = nullptr;
  const Real* weight = nullptr;
  const std::uint8_t *mixed = nullptr, *loose = nullptr;  // left to others
  const std::uint16_t* medium = nullptr;
  const BondLaw<Real>* laws = nullptr;        // null: no viscosity
  BondGradient<D, Real>* gradient = nullptr;  // out
  BondPush<D, Real>* push = nullptr;          // out
  Real unit = 1;                              // m, of places
};

// Of particles `first` .. `last` - 1.
template <int D, class Real>
using BondWalk = void (*)(const BondWalkTask<D, Real>&, std::uint32_t first, std::uint32_t last);

}  // namespace kerf
