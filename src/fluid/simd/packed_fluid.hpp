// SPDX-License-Identifier: Apache-2.0
// PackedFluid holds what the particles of one fluid need of one another, so that a neighbour is one
// load of 32 bytes in single precision, 64 in double. The SIMD pair kernel reads an array of them
// and writes FluidSums.
#pragma once

#include "core/vector.hpp"
#include "materials/equation_of_state.hpp"
#include "simd/packed_position.hpp"

namespace kerf {

template <int D, class Real>
struct alignas(8 * sizeof(Real)) PackedFluid {
  using Position = typename PackedNumber<Real>::Position;
  static constexpr int slots = 8;  // numbers of the size of Real; in 2D the last two are unused
  static constexpr int position_slot = 0, velocity_slot = D, pressure_slot = 2 * D,
                       volume_slot = 2 * D + 1;
  Position position[D];  // fixed-point coordinates
  Real velocity[D];      // m/s
  Real pressure;         // Pa
  Real volume;           // m^3 (2D: m^2), by its density; negative in a free surface; 0: no fluid
};

// The sums of a particle over the neighbours that the SIMD kernels visit (fluid/pair_terms.hpp):
// those of its own fluid, and those unlike it (fluid/simd/unlike_pair_kernel.hpp).
template <int D, class Real>
struct alignas(16) FluidSums {
  static constexpr int count = 3 * D + 2;
  static constexpr int pressure_force_at = 0, dissipative_force_at = D, compression_rate_at = 2 * D,
                       concentration_gradient_at = 2 * D + 1, kernel_sum_at = 3 * D + 1;
  Real sum[count];
  Real fastest_squared;         // m^2/s^2, the largest |v_ij|^2
  Real near_free_surface;       // 0 or 1
  Vector<D, Real> wall;         // 1/m, - sum V nabla W over solids beside a fluid particle
  Vector<D, Real> image_force;  // N, the part of both forces that mirror images exert

  // N, on i.
  KERF_FUNCTION Vector<D, Real> pressure_force() const { return vector(pressure_force_at); }
  KERF_FUNCTION Vector<D, Real> dissipative_force() const { return vector(dissipative_force_at); }
  // 1/m, sum_j V_0 nabla_i W_ij.
  KERF_FUNCTION Vector<D, Real> concentration_gradient() const {
    return vector(concentration_gradient_at);
  }
  // 1/s, minus the volumetric strain rate.
  KERF_FUNCTION Real compression_rate() const { return sum[compression_rate_at]; }
  // 1, sum_j V_0 W_ij without the particle itself.
  KERF_FUNCTION Real kernel_sum() const { return sum[kernel_sum_at]; }

 private:
  KERF_FUNCTION Vector<D, Real> vector(int first) const {
    Vector<D, Real> result;
    for (int a = 0; a < D; ++a) result[a] = sum[first + a];
    return result;
  }
};

// What the pair kernel needs of a fluid, one per medium.
template <class Real>
struct FluidLaw {
  Real mass, volume;  // per particle, kg, m^3 (2D: kg/m, m^2)
  Real sound_speed, viscosity;
  Real per_smoothing_length;           // 1/m
  Real kernel_scale, kernel_slope;     // alpha, 1/m^D; 5 alpha / h^2
  Real kernel_gradient_normalisation;  // k, 1 (fluid/lattice_sums.hpp)
  // The equation of state decides the sound speed where it depends on the density.
  EquationOfStateSet<Real> equations;
  EquationOfState equation_of_state;
};

template <int D, class Real>
struct FluidKernelTask {
  const PackedFluid<D, Real>* fluid = nullptr;
  const std::uint32_t* begin = nullptr;  // begin[i] .. begin[i] + same_fluid[i] of `neighbour`
  const std::uint32_t* same_fluid = nullptr;
  const std::uint32_t* neighbour = nullptr;
  const std::uint16_t* source = nullptr;  // the number of the law of each particle
  const FluidLaw<Real>* laws = nullptr;
  const std::uint8_t* asleep = nullptr;   // 1 for particles without sums; null: there are none
  FluidSums<D, Real>* results = nullptr;  // out, of the first particle and those after it
  Real unit = 1;                          // m, of the fixed-point coordinates
  // Where the spacing of a nearly incompressible solid jumps (fluid/simd/graded_pairs.hpp): 1 for
  // particles whose neighbours may have another spacing, and per neighbour, from graded_begin[i]
  // on, s_ij and h_j / h_i.
  const std::uint8_t* graded = nullptr;  // null: there are no such particles
  const std::uint32_t* graded_begin = nullptr;
  const Real *correction = nullptr, *length_ratio = nullptr;
};

// Computes the sums of particles `first` .. `last` - 1.
template <int D, class Real>
using FluidKernel = void (*)(const FluidKernelTask<D, Real>&, std::uint32_t first,
                             std::uint32_t last);

}  // namespace kerf
