// SPDX-License-Identifier: Apache-2.0
// The pair sums of the `standard` formulation over the particles where they are now: fluid, fluid
// against solid and walls, contact of solids. What holds a solid together is not among them: that
// is summed over the bonds of its first shape (solid/).
#pragma once

#include "kernels/wendland_c2.hpp"
#include "materials/tait.hpp"
#include "rates/body_force.hpp"
#include "rates/filling.hpp"
#include "rates/fluid_continuity.hpp"
#include "rates/fluid_force.hpp"
#include "rates/lattice_sums.hpp"
#include "rates/pair_loop.hpp"
#include "rates/solid_contact.hpp"
#include "rates/water_viscosity.hpp"

namespace kerf {

// Pressure by the density: all of it in fluids, that of the excess of K in nearly incompressible
// solids, none in others.
template <int D, class P>
struct FluidPressure {
  using Real = typename P::Real;
  ParticleView<D, P> particles;

  KERF_FUNCTION void operator()(Index i) const {
    const auto& medium = particles.medium(i);
    Real share = Real(0);
    if (particles.is_fluid(i))
      share = Real(1);
    else if (particles.has_density(i))
      share = medium.excess_bulk_modulus / medium.bulk_modulus;
    particles.pressure[i] =
        share > Real(0) ? share * Tait::pressure(medium, particles.compression[i]) : Real(0);
  }
};

template <int D, class P>
class StandardRates {
 public:
  using Real = typename P::Real;

  StandardRates() = default;
  explicit StandardRates(const Vector<D, double>& gravity, const LatticeSums& lattice = {})
      : gravity_{Vector<D, Real>::from(gravity)},
        fluid_pair_{gravity_.gravity, Real(1.0 / lattice.slope)} {}

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
    for_each_index(count, FluidPressure<D, P>{view});
    for_each_index(count,
                   FilteredPairLoop<D, P, ContactPairs, Filter, BodyForce<D, P>, FluidForce<D, P>,
                                    WaterViscosity<D, P>, SolidContact<D, P, Bonds>>(
                       view, list, filter, body_force, FluidForce<D, P>{fluid_pair_}, {},
                       SolidContact<D, P, Bonds>{bonds}));
  }

  void continuity(const ParticleView<D, P>& view, Index count, const NeighbourView& list) const {
    using Full = Filling<D, P, ContactPairs::Kernel<D>>;
    for_each_index(count, PairLoop<D, P, ContactPairs, FluidContinuity<D, P>, Full>(
                              view, list, {}, FluidContinuity<D, P>{fluid_pair_}, Full{}));
  }

  static constexpr int pair_passes = 2;  // per step

 private:
  BodyForce<D, P> gravity_{};
  FluidPair<D, P> fluid_pair_{};
};

}  // namespace kerf
