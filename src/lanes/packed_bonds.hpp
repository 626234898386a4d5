// SPDX-License-Identifier: Apache-2.0
// What the ends of bonds need to know of one another, a record for each particle, so that an end is
// one load; and the walks over the bonds of particles whose bonds are all within one medium: the
// sums of solid/deform.hpp and solid/bond_force.hpp, several bonds at a time.
#pragma once

#include "core/matrix.hpp"
#include "lanes/packed_place.hpp"
#include "solid/bond_weight.hpp"

namespace kerf {

template <int D, class Real>
struct alignas(16) PackedBondEnd {
  using Place = typename PackedNumber<Real>::Place;
  static constexpr int displacement_slot = 0, remainder_slot = D, hourglass_slot = 2 * D,
                       velocity_slot = 2 * D + 1, traction_slot = 3 * D + 1,
                       reference_slot = (3 * D + 1 + D * D + 3) / 4 * 4;
  static constexpr int slots = (reference_slot + D + 3) / 4 * 4;
  // u = x - X in two parts: their differences are as exact as those in double precision, so that a
  // small strain far from home is seen.
  Vector<D, Real> displacement, remainder;
  Real hourglass;            // mu, Pa; see solid/hourglass_modulus.hpp
  Vector<D, Real> velocity;  // m/s
  Matrix<D, Real> traction;  // A of solid/deform.hpp, Pa
  Real unused[reference_slot - traction_slot - D * D];
  Place reference[D];  // X
  Real unused_too[slots - reference_slot - D];
};

inline constexpr std::uint32_t bonds_per_word = 32;

// The bonds within one medium: their weight, and their viscosity q =
// density (linear theta + quadratic theta^2), with theta = length v_n / R (solid/bond_force.hpp).
template <class Real>
struct BondLaw {
  BondScale<Real> scale;
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

// What the bonds of shared lists (solid/share_lists.hpp) are in the reference configuration, for
// each of their entries.
template <int D, class Real>
struct SharedBonds {
  const Real* bond[D] = {};          // X_j - X_i, m
  const Real* weight = nullptr;      // w_ij of solid/bond_weight.hpp
  const Real* per_length = nullptr;  // 1 / |X_j - X_i|, 1/m
};

template <int D, class Real>
struct Bonds {
  const PackedBondEnd<D, Real>* ends = nullptr;
  // As in a table of bonds (solid/bond_table.hpp): where the list of each particle begins, how long
  // it is, and how far the numbers of the other ends are from its own.
  const std::uint32_t* begin = nullptr;
  const std::uint16_t* count = nullptr;
  const std::int32_t* entry = nullptr;
  std::uint32_t shared_entries = 0;  // the first ones
  SharedBonds<D, Real> shared;
  const std::uint32_t* whole = nullptr;  // bits
  std::uint32_t words = 0;               // of each particle
  const Real* fit = nullptr;             // of each weight of other lists a factor; null: 1
  // Particles left to others, those that hold on to nothing, and those with broken bonds.
  const std::uint8_t *mixed = nullptr, *loose = nullptr, *torn = nullptr;
  const std::uint16_t* medium = nullptr;
  const BondLaw<Real>* laws = nullptr;  // per medium
  bool breakable = false, viscous = false;
  Real unit = 1;  // m, of places
};
template <int D, class Real, template <int, class> class Result>
struct BondWalkTask : Bonds<D, Real> {
  Result<D, Real>* results = nullptr;  // out, of the first particle of the walk and those after it
};

// Of particles `first` .. `last` - 1; the results of those left out are not touched.
template <int D, class Real, template <int, class> class Result>
using BondWalk = void (*)(const BondWalkTask<D, Real, Result>&, std::uint32_t first,
                          std::uint32_t last);

}  // namespace kerf
