// SPDX-License-Identifier: Apache-2.0
// The pair sums of the `standard` formulation over the particles where they are now: fluid, fluid
// against solid and walls, contact of solids. What holds a solid together is not among them: that
// is summed over the bonds of its first shape (solid/).
#pragma once

#include "kernels/wendland_c2.hpp"
#include "materials/equation_of_state.hpp"
#include "rates/alike_pairs.hpp"
#include "rates/body_force.hpp"
#include "rates/crowding.hpp"
#include "rates/density_diffusion.hpp"
#include "rates/density_gradient.hpp"
#include "rates/filling.hpp"
#include "rates/fluid_continuity.hpp"
#include "rates/fluid_force.hpp"
#include "rates/fluid_pressure.hpp"
#include "rates/lattice_sums.hpp"
#include "rates/pair_loop.hpp"
#include "rates/solid_contact.hpp"
#include "rates/surface_contact.hpp"
#include "rates/water_viscosity.hpp"

namespace kerf {

// A loop over the particles of solids alone.
template <int D, class P, class Loop>
struct OfSolids {
  ParticleView<D, P> particles;
  Loop loop;

  KERF_FUNCTION void operator()(Index i) const {
    if (particles.medium(i).phase == Phase::solid) loop(i);
  }
};

template <int D, class P>
class StandardRates {
 public:
  using Real = typename P::Real;

  StandardRates(const Vector<D, double>& gravity, const std::vector<Medium<double>>& media,
                const LatticeSums& lattice = {}, WaterScheme scheme = WaterScheme::riemann)
      : gravity_{Vector<D, Real>::from(gravity)},
        fluid_pair_{gravity_.gravity, Real(1.0 / lattice.slope), {}, scheme},
        media_(static_cast<Index>(media.size())) {
    std::vector<TouchOfMedia<Real>> touch;
    for (const auto& entry : touch_table<D, ContactPairs>(media))
      touch.push_back(
          {static_cast<Real>(entry.inverse_filling), static_cast<Real>(entry.stiffness)});
    to_device(touch, touch_);
    for (const auto& medium : media) has_solids_ |= medium.phase == Phase::solid;
    if (takes_alike_apart()) alike_ = AlikePairs<D, P>(media, 1.0 / lattice.slope);
  }

  // Whether the list should have kin first.
  bool takes_alike_apart() const {
    return lanes_exist && fluid_pair_.scheme == WaterScheme::riemann;
  }

  // For bodies whose spacing jumps.
  void fit_pairs(const PairFit<D, P>& fit) { fluid_pair_.fit = fit; }

  // All that a step asks for, in one walk over the neighbours: pressures, the accelerations by
  // gravity and all pairs, the rates of compression, how full the room around particles is and
  // where they crowd.
  template <class Bonds>
  void evaluate(const ParticleView<D, P>& view, Index count, const NeighbourView& list,
                const Bonds& bonds, Crowd<D, Real>* crowd) const {
    if (has_solids_) look_at_surfaces(view, count, list, {touch()});
    const Walkers walkers{view, count, list};
    if (fluid_pair_.scheme == WaterScheme::riemann) {
      walk_alike_apart(walkers, bonds, FluidContinuity<D, P>{fluid_pair_}, Full{},
                       Crowding<D, P>{crowd});
      return;
    }
    press(walkers);
    density_gradient_.resize(count);
    for_each_index(count, PairLoop<D, P, ContactPairs, DensityGradient<D, P>>(
                              view, list, {}, {pointer(density_gradient_)}));
    walk(walkers, bonds, EveryPair{}, gravity_, FluidContinuity<D, P>{fluid_pair_}, Full{},
         Crowding<D, P>{crowd}, DensityDiffusion<D, P>{pointer(density_gradient_)});
  }

  // Pressures and accelerations only, for those who look at the run.
  template <class Bonds>
  void accelerate(const ParticleView<D, P>& view, Index count, const NeighbourView& list,
                  const Bonds& bonds) const {
    if (has_solids_) look_at_surfaces(view, count, list, {touch()});
    walk_alike_apart({view, count, list}, bonds);
  }
  // Those by the pairs that `filter` chooses and a body force of one's own.
  template <class Bonds, class Filter>
  void accelerate(const ParticleView<D, P>& view, Index count, const NeighbourView& list,
                  const Bonds& bonds, const Filter& filter,
                  const BodyForce<D, P>& body_force) const {
    if (has_solids_) look_at_surfaces(view, count, list, {touch()});
    press({view, count, list});
    walk({view, count, list}, bonds, filter, body_force);
  }

  // Bodies as they are laid out do not push. Once, at the start of a run.
  void fit_surfaces(const ParticleView<D, P>& view, Index count, const NeighbourView& list) const {
    if (has_solids_) look_at_surfaces(view, count, list, {touch(), true});
  }

  std::size_t bytes() const {
    return alike_.bytes() + density_gradient_.size() * sizeof(Vector<D, Real>);
  }

 private:
  using Full = Filling<D, P, ContactPairs::Kernel<D>>;

  struct Walkers {
    ParticleView<D, P> view;
    Index count;
    NeighbourView list;
  };

  static void press(const Walkers& walkers) {
    for_each_index(walkers.count, FluidPressure<D, P>{walkers.view});
  }

  // The forces, and what more is wanted of the same walk.
  template <class Bonds, class Filter, class... More>
  auto loop_of(const Walkers& walkers, const Bonds& bonds, const Filter& filter,
               const BodyForce<D, P>& body_force, const More&... more) const {
    return FilteredPairLoop<D, P, ContactPairs, Filter, BodyForce<D, P>, FluidForce<D, P>,
                            WaterViscosity<D, P>, SolidContact<D, P, Bonds>, SurfaceContact<D, P>,
                            More...>(
        walkers.view, walkers.list, filter, body_force, FluidForce<D, P>{fluid_pair_},
        WaterViscosity<D, P>{fluid_pair_.steepening}, SolidContact<D, P, Bonds>{bonds},
        SurfaceContact<D, P>{touch()}, more...);
  }
  template <class Bonds, class Filter, class... More>
  void walk(const Walkers& walkers, const Bonds& bonds, const Filter& filter,
            const BodyForce<D, P>& body_force, const More&... more) const {
    for_each_index(walkers.count, loop_of(walkers, bonds, filter, body_force, more...));
  }
  // The same over every pair, those of neighbours of one kind several at a time where that is
  // possible.
  template <class Bonds, class... More>
  void walk_alike_apart(Walkers walkers, const Bonds& bonds, const More&... more) const {
    if constexpr (lanes_exist) {
      if (takes_alike_apart()) {
        walkers.list.skips = Skips::alike;
        alike_.walk(alike_.pack(walkers.view, walkers.count, walkers.list), walkers.count,
                    loop_of(walkers, bonds, EveryPair{}, gravity_, more...));
        return;
      }
    }
    press(walkers);
    walk(walkers, bonds, EveryPair{}, gravity_, more...);
  }

  void look_at_surfaces(const ParticleView<D, P>& view, Index count, const NeighbourView& list,
                        const SurfaceOverlap<D, P>& term) const {
    using Loop = PairLoop<D, P, ContactPairs, SurfaceOverlap<D, P>>;
    NeighbourView others = list;  // kin does not touch
    others.skips = Skips::alike_and_own;
    for_each_index(count, OfSolids<D, P, Loop>{view, Loop(view, others, {}, term)});
  }
  TouchTable<Real> touch() const { return {pointer(touch_), media_}; }

  BodyForce<D, P> gravity_{};
  FluidPair<D, P> fluid_pair_{};
  Index media_ = 0;
  Array<TouchOfMedia<Real>> touch_;
  mutable Array<Vector<D, Real>> density_gradient_;  // 1/m, scratch of delta-SPH alone
  bool has_solids_ = false;
  mutable AlikePairs<D, P> alike_;
};

}  // namespace kerf
