// SPDX-License-Identifier: Apache-2.0
// PackedBondEnd holds what the bonds of a particle need of their other ends, so that an end is one
// load. The SIMD kernels over bonds read an array of them. They compute the sums of
// solid/deformation_gradient.hpp and solid/bond_force.hpp for the particles whose bonds are all
// within one body.
#pragma once

#include "core/matrix.hpp"
#include "parallel/load_record.hpp"
#include "simd/packed_position.hpp"
#include "solid/bond_terms.hpp"
#include "solid/bond_weight.hpp"

namespace kerf {

template <int D, class Real>
struct alignas(16) PackedBondEnd {
  using Position = typename PackedNumber<Real>::Position;
  static constexpr int displacement_slot = 0, remainder_slot = D, hourglass_slot = 2 * D,
                       velocity_slot = 2 * D + 1, traction_slot = 3 * D + 1,
                       reference_slot = (3 * D + 1 + D * D + 3) / 4 * 4;
  static constexpr int length_slot = reference_slot + D;
  static constexpr int slots = (length_slot + 1 + 3) / 4 * 4;
  // u = x - X in two parts: their differences are as exact as those in double precision, so that a
  // small strain far from the reference position is resolved.
  Vector<D, Real> displacement, remainder;
  Real hourglass;            // mu, Pa; see solid/hourglass_modulus.hpp
  Vector<D, Real> velocity;  // m/s
  Matrix<D, Real> traction;  // A of solid/deformation_gradient.hpp, Pa
  Real unused[reference_slot - traction_slot - D * D];
  Position reference[D];  // X
  Real length;            // h, m
};

inline constexpr std::uint32_t bonds_per_word = 32;

// The weight and the viscosity of the bonds within one medium. Those to another level of its body
// follow from these and from the ratio of the smoothing lengths.
template <class Real>
struct BondLaw {
  BondScale<Real> scale;
  BondViscosityLaw<Real> viscosity;
  Real hourglass;  // 2 mu of intact particles, Pa; 1 without hourglass control
};

// sum_j w_ij (u_j - u_i) (x) R, and the largest stretch |x|^2 / R^2 - 1 of a bond.
template <int D, class Real>
struct BondGradientSum {
  Matrix<D, Real> sum;
  Real stretch;
};
template <int D, class Real>
struct BondForceSum {
  Vector<D, Real> force;  // N
  Real power;             // W, dissipated
};

// sum_j w_ij |gamma_ij|^2, gamma_ij = H_i R - (u_j - u_i), of solid/stored_energy.hpp.
template <int D, class Real>
struct BondMisfitSum {
  Real misfit;
};

// The moments of the bonds in the reference configuration, of which solid/gradient_correction.hpp
// makes B: in double, of the numbers that the other sums have, as these round them.
template <int D, class Real>
struct BondMoments {
  Matrix<D, double> of_gradient;  // sum_j R (x) [w_ij R], as the sum of H has it
  // sum_j [2 mu w_ij] / (2 mu) R (x) R, as the force has it, with mu of the intact medium
  Matrix<D, double> of_hourglass;
};

// The bonds of shared lists (solid/share_lists.hpp) in the reference configuration, for each of
// their entries.
template <int D, class Real>
struct SharedBonds {
  const Real* bond[D] = {};          // X_j - X_i, m
  const Real* weight = nullptr;      // w_ij of solid/bond_weight.hpp
  const Real* per_length = nullptr;  // 1 / |X_j - X_i|, 1/m
};

// The same of one entry, with the entry itself, for the loops of a GPU.
template <int D, class Real>
struct alignas(16) SharedBond {
  Real bond[D], weight, per_length;
  std::int32_t entry;
};

template <int D, class Real>
struct Bonds {
  const PackedBondEnd<D, Real>* ends = nullptr;
  const RecordPart* end_parts = nullptr;  // of `ends_count`, for a GPU
  std::uint32_t ends_count = 0;
  // As in a table of bonds (solid/bond_table.hpp): where the list of each particle begins, how long
  // it is, and the indices of the other ends minus that of the particle.
  const std::uint32_t* begin = nullptr;
  const std::uint16_t* count = nullptr;
  const std::int32_t* entry = nullptr;
  std::uint32_t shared_entries = 0;  // the first ones
  SharedBonds<D, Real> shared;
  const SharedBond<D, Real>* shared_records = nullptr;  // for a GPU
  const std::uint32_t* bond_intact = nullptr;           // bits
  std::uint32_t words = 0;                              // of each particle
  const Real* correction = nullptr;           // factor of each weight of other lists; null: 1
  const Matrix<D, Real>* gradient = nullptr;  // H of each particle
  // Particles that the general loops compute, those without bonds, those that are not computed, and
  // those with broken bonds.
  const std::uint8_t *several_bodies = nullptr, *detached = nullptr, *asleep = nullptr,
                     *has_broken_bonds = nullptr;
  const std::uint16_t* medium = nullptr;
  const BondLaw<Real>* laws = nullptr;  // per medium
  bool breakable = false, viscous = false;
  bool has_levels = false;  // of resolution
  Real unit = 1;            // m, of the fixed-point coordinates
};
template <int D, class Real, template <int, class> class Result>
struct BondKernelTask : Bonds<D, Real> {
  KERF_FUNCTION const Bonds<D, Real>& bonds() const { return *this; }
  Result<D, Real>* results = nullptr;  // out, of the first particle and those after it
};

// Computes the sums of particles `first` .. `last` - 1 that it does not leave out.
template <int D, class Real, template <int, class> class Result>
using BondKernel = void (*)(const BondKernelTask<D, Real, Result>&, std::uint32_t first,
                            std::uint32_t last);

}  // namespace kerf
