// SPDX-License-Identifier: Apache-2.0
// What particles of one fluid need to know of one another, packed so that a neighbour is one load,
// 32 bytes in single precision, 64 in double; and the walk over neighbours of their own kind.
#pragma once

#include "core/vector.hpp"
#include "lanes/packed_place.hpp"

namespace kerf {

template <int D, class Real>
struct alignas(8 * sizeof(Real)) PackedFluid {
  using Place = typename PackedNumber<Real>::Place;
  static constexpr int slots = 8;  // numbers of the size of Real; in 2D the last two are unused
  static constexpr int place_slot = 0, velocity_slot = D, pressure_slot = 2 * D,
                       volume_slot = 2 * D + 1;
  Place place[D];
  Real velocity[D];  // m/s
  Real pressure;     // Pa
  Real volume;       // m^3 (2D: m^2), by its density; less than 0 in a free surface; 0: no fluid
};

// The sums over the neighbours of one kind.
template <int D, class Real>
struct FluidSums {
  static constexpr int count = 3 * D + 2;
  static constexpr int pressing_at = 0, damping_at = D, strain_rate_at = 2 * D,
                       crowd_at = 2 * D + 1, filling_at = 3 * D + 1;
  Real sum[count];
  Real fastest_squared;  // m^2/s^2
  Real sees_surface;     // 0 or 1

  KERF_FUNCTION Vector<D, Real> pressing() const { return vector(pressing_at); }  // N, on i
  KERF_FUNCTION Vector<D, Real> damping() const { return vector(damping_at); }    // N, on i
  KERF_FUNCTION Vector<D, Real> crowd() const { return vector(crowd_at); }  // 1/m, sum V_0 nabla W
  KERF_FUNCTION Real strain_rate() const { return sum[strain_rate_at]; }    // 1/s
  KERF_FUNCTION Real filling() const { return sum[filling_at]; }  // 1, without the particle itself

 private:
  KERF_FUNCTION Vector<D, Real> vector(int first) const {
    Vector<D, Real> result;
    for (int a = 0; a < D; ++a) result[a] = sum[first + a];
    return result;
  }
};

// A fluid as the walk needs it, one per medium.
template <class Real>
struct FluidLaw {
  Real mass, volume;  // per particle, kg, m^3 (2D: kg/m, m^2)
  Real sound_speed, hugoniot_slope, viscosity;
  Real smoothing_length, per_smoothing_length;  // m, 1/m
  Real kernel_scale, kernel_slope;              // alpha, 1/m^D; 5 alpha / h^2
  Real steepening;                              // of the kernel (rates/lattice_sums.hpp)
  std::int32_t has_shocks;                      // its speed of sound is by its density
};

template <int D, class Real>
struct FluidWalkTask {
  const PackedFluid<D, Real>* fluid = nullptr;
  const std::uint32_t* begin = nullptr;  // begin[i] .. begin[i] + alike[i] of `neighbour`
  const std::uint32_t* alike = nullptr;
  const std::uint32_t* neighbour = nullptr;
  const std::uint16_t* source = nullptr;  // number of the law of each particle
  const FluidLaw<Real>* laws = nullptr;
  FluidSums<D, Real>* results = nullptr;  // out, of the first of the walk and those after it
  Real unit = 1;                          // m, of places
};

// Works out the sums of particles `first` .. `last` - 1.
template <int D, class Real>
using FluidWalk = void (*)(const FluidWalkTask<D, Real>&, std::uint32_t first, std::uint32_t last);

}  // namespace kerf
