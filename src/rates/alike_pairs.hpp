// SPDX-License-Identifier: Apache-2.0
// The pairs of particles of one kind, which are most of all pairs, by way of lanes/: packs what
// neighbours ask of a particle, and walks over the lists several neighbours at a time. The same
// formulas as the general terms (fluid_force.hpp and others), which take the sums from here and
// add what other neighbours do. On a GPU the general terms do it all.
#pragma once

#include <algorithm>
#include <vector>

#include "exec/in_turn.hpp"
#include "lanes/walk_in_blocks.hpp"
#include "lanes/walks.hpp"
#include "neighbours/neighbour_list.hpp"
#include "rates/fluid_pressure.hpp"

namespace kerf {

template <int D, class P>
class AlikePairs {
 public:
  using Real = typename P::Real;

  AlikePairs() = default;
  // `steepening`: of the kernel (rates/fluid_pair.hpp).
  AlikePairs(const std::vector<Medium<double>>& media, double steepening)
      : walk_(walks().template get<D, Real>().fluid) {
    double finest = 1e300;
    for (const auto& medium : media) {
      laws_.push_back(law_of(medium, steepening));
      finest = std::min(finest, medium.spacing);
    }
    unit_ = PlaceUnit<Real>::of_spacing(finest);
  }

  // Works the pressures out and packs the particles.
  FluidWalkTask<D, Real> pack(const ParticleView<D, P>& view, Index count,
                              const NeighbourView& list) {
    fluid_.resize(count);
    for_each_index(count, InTurn(FluidPressure<D, P>{view}, Pack{view, unit_, fluid_.data()}));
    return {fluid_.data(), list.begin,   list.alike, list.neighbour,
            view.source,   laws_.data(), nullptr,    static_cast<Real>(unit_.unit)};
  }

  // `loop(i)` for all particles, a block of them at a time: first the sums over neighbours of their
  // own kind, then the general loop, which takes them up.
  template <class Loop>
  void walk(const FluidWalkTask<D, Real>& task, Index count, const Loop& loop) const {
    walk_in_blocks<FluidSums<D, Real>>(task, walk_, count, loop);
  }

  std::size_t bytes() const { return fluid_.size() * sizeof(fluid_[0]); }

 private:
  static FluidLaw<Real> law_of(const Medium<double>& medium, double steepening) {
    const double h = medium.smoothing_length, alpha = WendlandC2<D>::scale(h);
    FluidLaw<Real> law{};
    law.mass = static_cast<Real>(medium.mass);
    law.volume = static_cast<Real>(medium.volume);
    law.sound_speed = static_cast<Real>(medium.sound_speed);
    law.hugoniot_slope = static_cast<Real>(medium.hugoniot_slope);
    law.viscosity = static_cast<Real>(medium.phase == Phase::water ? medium.viscosity : 0.0);
    law.smoothing_length = static_cast<Real>(h);
    law.per_smoothing_length = static_cast<Real>(1.0 / h);
    law.kernel_scale = static_cast<Real>(alpha);
    law.kernel_slope = static_cast<Real>(5.0 * alpha / (h * h));
    law.steepening = static_cast<Real>(steepening);
    law.has_shocks = medium.equation_of_state == EquationOfState::shock_hugoniot ? 1 : 0;
    return law;
  }

 public:  // nvcc has no loop bodies that are private
  struct Pack {
    ParticleView<D, P> particles;
    PlaceUnit<Real> unit;
    PackedFluid<D, Real>* fluid;

    KERF_FUNCTION void operator()(Index i) const {
      PackedFluid<D, Real> packed{};
      if (!particles.has_density(i)) {
        fluid[i] = packed;  // no volume: no walk
        return;
      }
      for (int a = 0; a < D; ++a) {
        packed.place[a] = unit.pack(particles.position[i][a]);
        packed.velocity[a] = particles.velocity[i][a];
      }
      packed.pressure = particles.pressure[i];
      const Real volume = particles.medium(i).mass / particles.density(i);
      packed.volume = particles.has(i, flag::surface) ? -volume : volume;
      fluid[i] = packed;
    }
  };

 private:
  FluidWalk<D, Real> walk_ = nullptr;
  PlaceUnit<Real> unit_{};
  // Not Array: records lie on their own alignment.
  std::vector<PackedFluid<D, Real>> fluid_;
  std::vector<FluidLaw<Real>> laws_;
};

}  // namespace kerf
