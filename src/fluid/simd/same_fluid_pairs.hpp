// SPDX-License-Identifier: Apache-2.0
// SameFluidPairs computes the pairs of particles of one fluid, which are most of all pairs, by the
// SIMD pair kernel. The general pair loop starts from these sums and adds the other neighbours. On
// a GPU the general pair loop computes all pairs.
#pragma once

#include <algorithm>
#include <vector>

#include "fluid/fluid_pressure.hpp"
#include "fluid/simd/fluid_kernels.hpp"
#include "fluid/simd/graded_pairs.hpp"
#include "neighbours/neighbour_list.hpp"
#include "parallel/fused_kernel.hpp"
#include "simd/run_in_blocks.hpp"

namespace kerf {

template <int D, class P>
class SameFluidPairs {
 public:
  using Real = typename P::Real;

  SameFluidPairs() = default;
  // `kernel_gradient_normalisation`: k of fluid/fluid_pair.hpp.
  SameFluidPairs(const std::vector<Medium<double>>& media, double kernel_gradient_normalisation)
      : kernel_(fluid_kernels().template get<D, Real>()) {
    double finest = 1e300;
    for (const auto& medium : media) {
      laws_.push_back(law_of(medium, kernel_gradient_normalisation));
      finest = std::min(finest, medium.spacing);
    }
    unit_ = FixedPointScale<Real>::of_spacing(finest);
  }

  // Computes the pressures and packs the particles.
  FluidKernelTask<D, Real> pack(const ParticleView<D, P>& view, Index count,
                                const NeighbourView& list) {
    fluid_.resize(count);
    for_each_index(count, FusedKernel(FluidPressure<D, P>{view}, Pack{view, unit_, fluid_.data()}));
    FluidKernelTask<D, Real> task;
    task.fluid = fluid_.data();
    task.begin = list.begin;
    task.same_fluid = list.same_fluid;
    task.neighbour = list.neighbour;
    task.source = view.source;
    task.laws = laws_.data();
    task.unit = static_cast<Real>(unit_.unit);
    graded_.give(task);
    return task;
  }

  // The pairs of graded solids; they must take each new list.
  GradedPairs<D, P>& graded() { return graded_; }

  // Calls loop(i), the general pair loop, for all particles, a block of them at a time, after the
  // sums of the block over neighbours of the same fluid.
  template <class Loop>
  void run(const FluidKernelTask<D, Real>& task, Index count, const Loop& loop) const {
    run_in_blocks<FluidSums<D, Real>>(task, kernel_, count, loop);
  }

  std::size_t bytes() const { return fluid_.size() * sizeof(fluid_[0]) + graded_.bytes(); }

 private:
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

 private:
  FluidKernel<D, Real> kernel_ = nullptr;
  FixedPointScale<Real> unit_{};
  // Not Array: a packed particle has an alignment of its own.
  std::vector<PackedFluid<D, Real>> fluid_;
  std::vector<FluidLaw<Real>> laws_;
  GradedPairs<D, P> graded_;
};

}  // namespace kerf
