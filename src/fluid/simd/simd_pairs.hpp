// SPDX-License-Identifier: Apache-2.0
// SimdPairs computes the pairs of fluids by the SIMD pair kernels: those of particles of one fluid,
// which are most of all pairs, and those of a fluid with another fluid, a solid or a mirror image.
// The general pair loop starts from these sums and adds the other neighbours. On a GPU
// fluid/packed_fluid_loop.hpp takes the place of the first kernel, and the general pair loop adds
// all other pairs.
#pragma once

#include <algorithm>
#include <vector>

#include "fluid/fluid_pressure.hpp"
#include "fluid/packed_fluid_loop.hpp"
#include "fluid/simd/fluid_kernels.hpp"
#include "fluid/simd/graded_pairs.hpp"
#include "fluid/simd/unlike_kernels.hpp"
#include "neighbours/neighbour_list.hpp"
#include "parallel/fused_kernel.hpp"
#include "simd/run_in_blocks.hpp"

namespace kerf {

// The tasks of both kernels over the same particles.
template <int D, class Real>
struct SimdPairsTask {
  FluidKernelTask<D, Real> same_fluid;
  UnlikeKernelTask<D, Real> unlike;
  FluidKernel<D, Real> same_fluid_kernel = nullptr;
  UnlikeKernel<D, Real> unlike_kernel = nullptr;
  FluidSums<D, Real>* results = nullptr;  // out, as in each of both

  static void run(const SimdPairsTask& task, Index first, Index last) {
    auto same_fluid = task.same_fluid;
    auto unlike = task.unlike;
    same_fluid.results = unlike.results = task.results;
    task.same_fluid_kernel(same_fluid, first, last);
    task.unlike_kernel(unlike, first, last);
  }
};

template <int D, class P>
class SimdPairs {
 public:
  using Real = typename P::Real;

  SimdPairs() = default;
  // `kernel_gradient_normalisation`: k of fluid/fluid_pair.hpp; `gravity` in m/s^2.
  SimdPairs(const std::vector<Medium<double>>& media, double kernel_gradient_normalisation,
            const Vector<D, Real>& gravity) {
    double finest = 1e300;
    std::vector<FluidLaw<Real>> laws;
    for (const auto& medium : media) {
      laws.push_back(law_of(medium, kernel_gradient_normalisation));
      finest = std::min(finest, medium.spacing);
      (is_weakly_compressible(laws.back().equations, medium.equation_of_state) ? any_weak_
                                                                               : any_shocks_) =
          true;
    }
    to_device(laws, laws_);
    unit_ = FixedPointScale<Real>::of_spacing(finest);
    if constexpr (simd_exists) {
      task_.same_fluid_kernel = fluid_kernels().template get<D, Real>();
      task_.unlike_kernel = unlike_kernels().template get<D, Real>();
    }
    task_.same_fluid.unit = task_.unlike.unit = static_cast<Real>(unit_.unit);
    task_.unlike.kernel_gradient_normalisation = static_cast<Real>(kernel_gradient_normalisation);
    task_.unlike.gravity = gravity;
  }

  // Computes the pressures and packs the particles, `count` and the ghosts.
  SimdPairsTask<D, Real> pack(const ParticleView<D, P>& view, Index count,
                              const NeighbourView& list) {
    const Index all = count + view.ghosts.count;
    fluid_.resize(all);
    if constexpr (simd_exists) make_room_for_unlike(list, count, all);
    for_each_index(all, FusedKernel(FluidPressure<D, P>{view}, Pack{view, unit_, pointer(fluid_)},
                                    PackUnlike{view, list.unlike, list.images, unit_,
                                               unlike_.empty() ? nullptr : pointer(unlike_)}));
    auto task = task_;
    task.same_fluid.fluid = pointer(fluid_);
    task.same_fluid.source = view.source;
    task.same_fluid.laws = pointer(laws_);
    task.same_fluid.asleep = task.unlike.asleep = view.asleep;
    task.unlike.particles = pointer(unlike_);
    task.unlike.end = list.end;
    task.unlike.unlike = list.unlike;
    task.unlike.images = list.images;
    task.unlike.mirrors = view.mirrors;
    graded_.give(task.unlike);
    for (int a = 0; a < D && view.mirrors.faces != 0; ++a) {
      task.unlike.twice_plane[0][a] = unit_.pack(2.0 * view.mirrors.low[a]);
      task.unlike.twice_plane[1][a] = unit_.pack(2.0 * view.mirrors.high[a]);
    }
    const auto take_list = [&list](auto& of) {
      of.begin = list.begin;
      of.same_fluid = list.same_fluid;
      of.neighbour = list.neighbour;
    };
    take_list(task.same_fluid);
    take_list(task.unlike);
    graded_.give(task.same_fluid);
    return task;
  }

  // The pairs of graded solids; they must take each new list.
  GradedPairs<D, P>& graded() { return graded_; }

  // Calls loop(i), the general pair loop, for all particles, a block of them at a time, after the
  // sums of the block by the kernels.
  template <class Loop>
  void run(const SimdPairsTask<D, Real>& task, Index count, const Loop& loop) {
    if constexpr (simd_exists) {
      run_in_blocks<FluidSums<D, Real>>(task, &SimdPairsTask<D, Real>::run, count, loop);
    } else {
      using Pairs = WeaklyCompressiblePairs<Real>;
      static_assert(list_alignment % PackedFluidLoop<D, Real, Pairs>::batch == 0);
      results_.resize(count);
      auto of_all = task.same_fluid;
      of_all.results = pointer(results_);
      if (any_weak_) for_each_index(count, PackedFluidLoop<D, Real, Pairs>{of_all});
      if (any_shocks_) for_each_index(count, PackedFluidLoop<D, Real, ShockPairs<Real>>{of_all});
      Loop others = loop;
      others.take(BlockResults<FluidSums<D, Real>>{of_all.results, 0});
      for_each_index(count, others);
    }
  }

  std::size_t bytes() const {
    return fluid_.size() * sizeof(PackedFluid<D, Real>) +
           unlike_.size() * sizeof(PackedUnlike<D, Real>) +
           results_.size() * sizeof(FluidSums<D, Real>) + graded_.bytes();
  }

 private:
  // Nothing is held as long as no particle has such a neighbour, as in water alone.
  void make_room_for_unlike(const NeighbourView& list, Index count, Index all) {
    if (unlike_.size() >= all) return;
    const bool any = !unlike_.empty() ||
                     reduce_unordered(count, HasUnlike{list.unlike, list.images}, false, Either{});
    if (any) unlike_.resize(all);
  }
  static FluidLaw<Real> law_of(const Medium<double>& medium, double kernel_gradient_normalisation) {
    const double h = medium.smoothing_length, alpha = WendlandC2<D>::scale(h);
    FluidLaw<Real> law{};
    law.mass = static_cast<Real>(medium.mass);
    law.volume = static_cast<Real>(medium.volume);
    law.sound_speed = static_cast<Real>(medium.sound_speed);
    law.equations = EquationOfStateSet<Real>::from(medium);
    law.equation_of_state = medium.equation_of_state;
    law.viscosity = static_cast<Real>(medium.phase == Phase::water ? medium.viscosity : 0.0);
    law.per_smoothing_length = static_cast<Real>(1.0 / h);
    law.kernel_scale = static_cast<Real>(alpha);
    law.kernel_slope = static_cast<Real>(5.0 * alpha / (h * h));
    law.kernel_gradient_normalisation = static_cast<Real>(kernel_gradient_normalisation);
    return law;
  }

 public:  // nvcc has no loop bodies that are private
  struct HasUnlike {
    const Index *neighbours, *images;
    KERF_FUNCTION bool operator()(Index i) const { return neighbours[i] != 0 || images[i] != 0; }
  };
  struct Pack {
    ParticleView<D, P> particles;
    FixedPointScale<Real> unit;
    PackedFluid<D, Real>* fluid;

    KERF_FUNCTION void operator()(Index i) const {
      PackedFluid<D, Real> packed{};
      if (!particles.has_density(i)) {
        fluid[i] = packed;  // no volume: no sums
        return;
      }
      for (int a = 0; a < D; ++a) {
        packed.position[a] = unit.pack(particles.position[i][a]);
        packed.velocity[a] = particles.velocity[i][a];
      }
      packed.pressure = particles.pressure[i];
      const Real volume = particles.medium(i).mass / particles.density(i);
      packed.volume = particles.has(i, flag::surface) ? -volume : volume;
      fluid[i] = packed;
    }
  };
  struct PackUnlike {
    ParticleView<D, P> particles;
    const Index *neighbours, *images;  // how many unlike ones and images it has
    FixedPointScale<Real> unit;
    PackedUnlike<D, Real>* packed;

    KERF_FUNCTION void operator()(Index i) const {
      if (packed == nullptr) return;
      if (!particles.ghosts.has(i) && neighbours[i] == 0 && images[i] == 0) return;
      const auto& medium = particles.medium(i);
      const bool is_fluid = particles.is_fluid(i), is_water = medium.phase == Phase::water;
      PackedUnlike<D, Real>& to = packed[i];
      for (int a = 0; a < D; ++a) {
        to.position[a] = unit.pack(particles.position[i][a]);
        to.velocity[a] = particles.velocity[i][a];
        to.wall_normal[a] = is_fluid ? particles.wall_normal[i][a] : Real(0);
      }
      const Real volume = volume_of(particles, i, medium);
      to.pressure = particles.pressure[i];
      to.volume = particles.has(i, flag::surface) ? -volume : volume;
      to.density = particles.density(i);
      to.sound_speed = signed_sound_speed(i, medium);
      to.rest_volume = is_fluid ? -medium.volume : medium.volume;
      to.smoothing_length = is_water ? -medium.smoothing_length : medium.smoothing_length;
      to.viscosity = is_water ? medium.viscosity : Real(0);
    }

   private:
    KERF_FUNCTION Real signed_sound_speed(Index i, const Medium<Real>& medium) const {
      if (!particles.has_density(i)) return Real(0);
      const Real speed = impedance_speed_at(medium, particles.compression[i]);
      return is_weakly_compressible(medium) ? -speed : speed;
    }
  };

 private:
  SimdPairsTask<D, Real> task_;  // without the particles and the list
  FixedPointScale<Real> unit_{};
  Array<PackedFluid<D, Real>> fluid_;
  Array<PackedUnlike<D, Real>> unlike_;
  Array<FluidLaw<Real>> laws_;
  bool any_weak_ = false, any_shocks_ = false;  // fluids without shocks and with them
  Array<FluidSums<D, Real>> results_;           // of the GPU's loops
  GradedPairs<D, P> graded_;
};

}  // namespace kerf
