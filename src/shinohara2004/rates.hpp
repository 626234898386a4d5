// SPDX-License-Identifier: Apache-2.0
// The right-hand side F(phi) of the `shinohara2004` formulation: the rates of change of the state
// of all particles, in the order of section 3 of the paper.
#pragma once

#include "pairs/body_force.hpp"
#include "pairs/pair_loop.hpp"
#include "shinohara2004/artificial_stress.hpp"
#include "shinohara2004/artificial_viscosity.hpp"
#include "shinohara2004/continuity.hpp"
#include "shinohara2004/pressure_force.hpp"
#include "shinohara2004/repulsion.hpp"
#include "shinohara2004/shear_force.hpp"
#include "shinohara2004/stress.hpp"
#include "shinohara2004/traits.hpp"
#include "shinohara2004/velocity_gradient.hpp"

namespace kerf {

template <int D, class P>
class Rates {
 public:
  using Real = typename P::Real;

  Rates() = default;
  // `epsilon` and `exponent` are those of the artificial stress; epsilon = 0 leaves it out.
  explicit Rates(const Vector<D, double>& gravity, double epsilon = 0.0, double exponent = 4.0)
      : body_force_{Vector<D, Real>::from(gravity)},
        epsilon_(static_cast<Real>(epsilon)),
        tensile_{static_cast<Real>(exponent)} {}

  void evaluate(Particles<D, P>& particles, const NeighbourView& list) const {
    const auto view = particles.view();
    const Index n = particles.size();
    for_each_index(n, PairLoop<D, P, JointPairs, Continuity<D, P>, VelocityGradient<D, P>>(
                          view, list, {}, {}, {}));
    for_each_index(n, UpdateStress<D, P>{view});
    if (epsilon_ > Real(0)) for_each_index(n, ArtificialStressTensor<D, P>{view, epsilon_});
    accelerate(particles, view, list, EveryPair{}, body_force_);
  }

  // Evaluates the accelerations by the pairs that `filter` selects, from the current stresses.
  template <class Filter>
  void accelerate(const Particles<D, P>& particles, const ParticleView<D, P>& view,
                  const NeighbourView& list, const Filter& filter,
                  const BodyForce<D, P>& body_force) const {
    const Index n = particles.size();
    if (epsilon_ > Real(0)) {
      for_each_index(
          n, FilteredPairLoop<D, P, JointPairs, Filter, BodyForce<D, P>, PressureForce<D, P>,
                              ShearForce<D, P>, ArtificialViscosity<D, P>, Repulsion<D, P>,
                              TensileRepulsion<D, P>>(view, list, filter, body_force, {}, {}, {},
                                                      {}, tensile_));
    } else {
      for_each_index(
          n, FilteredPairLoop<D, P, JointPairs, Filter, BodyForce<D, P>, PressureForce<D, P>,
                              ShearForce<D, P>, ArtificialViscosity<D, P>, Repulsion<D, P>>(
                 view, list, filter, body_force, {}, {}, {}, {}));
    }
  }

  static constexpr int pair_passes = 2;  // per evaluation

 private:
  BodyForce<D, P> body_force_{};
  Real epsilon_ = 0;
  TensileRepulsion<D, P> tensile_{};
};

}  // namespace kerf
