// SPDX-License-Identifier: Apache-2.0
// The pair sums of the `standard` formulation over the particles where they are now: water, water
// against solid and walls, contact of solids. What holds a solid together is not among them: that
// is summed over the bonds of its first shape (solid/).
#pragma once

#include "kernels/wendland_c2.hpp"
#include "materials/tait_water.hpp"
#include "rates/body_force.hpp"
#include "rates/pair_loop.hpp"
#include "rates/solid_contact.hpp"
#include "rates/water_continuity.hpp"
#include "rates/water_force.hpp"
#include "rates/water_viscosity.hpp"

namespace kerf {

// Pressure of water by its equation of state; no other particle has one here.
template <int D, class P>
struct WaterPressure {
  using Real = typename P::Real;
  ParticleView<D, P> particles;

  KERF_FUNCTION void operator()(Index i) const {
    const auto& medium = particles.medium(i);
    const bool water = medium.phase == Phase::water;
    particles.pressure[i] = water ? TaitWater::pressure(medium, particles.compression[i]) : Real(0);
  }
};

template <int D, class P>
class StandardRates {
 public:
  using Real = typename P::Real;

  StandardRates() = default;
  explicit StandardRates(const Vector<D, double>& gravity)
      : gravity_{Vector<D, Real>::from(gravity)}, water_{gravity_.gravity} {}

  // Pressures and the accelerations by gravity and all pairs.
  template <class Bonds>
  void accelerate(const ParticleView<D, P>& view, Index count, const NeighbourView& list,
                  const Bonds& bonds) const {
    accelerate(view, count, list, bonds, EveryPair{}, gravity_);
  }
  // Those by the pairs that `filter` chooses and a body force of one's own.
  template <class Bonds, class Filter>
  void accelerate(const ParticleView<D, P>& view, Index count, const NeighbourView& list,
                  const Bonds& bonds, const Filter& filter,
                  const BodyForce<D, P>& body_force) const {
    for_each_index(count, WaterPressure<D, P>{view});
    for_each_index(count,
                   FilteredPairLoop<D, P, ContactPairs, Filter, BodyForce<D, P>, WaterForce<D, P>,
                                    WaterViscosity<D, P>, SolidContact<D, P, Bonds>>(
                       view, list, filter, body_force, WaterForce<D, P>{water_}, {},
                       SolidContact<D, P, Bonds>{bonds}));
  }

  void continuity(const ParticleView<D, P>& view, Index count, const NeighbourView& list) const {
    for_each_index(count, PairLoop<D, P, ContactPairs, WaterContinuity<D, P>>(
                              view, list, {}, WaterContinuity<D, P>{water_}));
  }

  static constexpr int pair_passes = 2;  // per step

 private:
  BodyForce<D, P> gravity_{};
  WaterPair<D, P> water_{};
};

}  // namespace kerf
