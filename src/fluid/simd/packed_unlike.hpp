// SPDX-License-Identifier: Apache-2.0
// PackedUnlike holds what the two particles of an unlike pair (PairClass) need of one another: a
// fluid and another fluid or a solid; and those of a pair with a mirror image. A neighbour is one
// cache line in single precision.
#pragma once

#include "core/mirror_planes.hpp"
#include "fluid/simd/packed_fluid.hpp"

namespace kerf {

template <int D, class Real>
struct alignas(16 * sizeof(Real)) PackedUnlike {
  using Position = typename PackedNumber<Real>::Position;
  static constexpr int velocity_slot = D, wall_normal_slot = 2 * D, pressure_slot = 3 * D,
                       volume_slot = 3 * D + 1, density_slot = 3 * D + 2,
                       sound_speed_slot = 3 * D + 3, rest_volume_slot = 3 * D + 4,
                       smoothing_length_slot = 3 * D + 5, viscosity_slot = 3 * D + 6,
                       slots = 3 * D + 7;
  Position position[D];   // fixed-point coordinates
  Real velocity[D];       // m/s
  Real wall_normal[D];    // 1, of the wall beside a fluid, into the fluid; 0: none, or a solid
  Real pressure;          // Pa
  Real volume;            // m^3 (2D: m^2), by its density if it has one; negative in a free surface
  Real density;           // kg/m^3
  Real sound_speed;       // m/s; negative: weakly compressible, 0: it has no pressure by density
  Real rest_volume;       // m^3 (2D: m^2); negative: fluid
  Real smoothing_length;  // m; negative: water
  Real viscosity;         // Pa s, of water, else 0
};

template <int D, class Real>
struct UnlikeKernelTask {
  const PackedUnlike<D, Real>* particles = nullptr;  // set where a particle has such neighbours
  // Of each list: the unlike neighbours follow those of the same fluid, the images come last.
  const std::uint32_t *begin = nullptr, *end = nullptr, *same_fluid = nullptr, *unlike = nullptr,
                      *images = nullptr;
  const std::uint32_t* neighbour = nullptr;
  const std::uint8_t* asleep = nullptr;   // 1 for particles without sums; null: there are none
  FluidSums<D, Real>* results = nullptr;  // the kernel adds to those of the first and the next ones
  Real unit = 1;                          // m, of the fixed-point coordinates
  Real kernel_gradient_normalisation = 1;  // k, 1 (fluid/lattice_sums.hpp)
  Vector<D, Real> gravity;                 // m/s^2
  // s_ij of the images of particles with graded_begin[i] < graded_begin[i + 1], from there on;
  // where graded[i] is set, after those of its same_fluid[i] neighbours. Null, or of others: 1.
  const Real* correction = nullptr;
  const std::uint32_t* graded_begin = nullptr;
  const std::uint8_t* graded = nullptr;
  MirrorPlanes<D> mirrors;
  // Twice the coordinates of the planes at the lower and the upper faces.
  typename PackedNumber<Real>::Position twice_plane[2][D] = {};
};

// Adds the sums of particles `first` .. `last` - 1.
template <int D, class Real>
using UnlikeKernel = void (*)(const UnlikeKernelTask<D, Real>&, std::uint32_t first,
                              std::uint32_t last);

}  // namespace kerf
