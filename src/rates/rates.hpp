// SPDX-License-Identifier: Apache-2.0
// The right-hand side F(phi) of the `shinohara2004` formulation: from the state of all particles to
// its rates of change. Reads in the order of the paper's section 3.
#pragma once

#include "case/case.hpp"
#include "rates/artificial_stress.hpp"
#include "rates/artificial_viscosity.hpp"
#include "rates/body_force.hpp"
#include "rates/continuity.hpp"
#include "rates/pair_loop.hpp"
#include "rates/pressure_force.hpp"
#include "rates/repulsion.hpp"
#include "rates/shear_force.hpp"
#include "rates/stress.hpp"
#include "rates/velocity_gradient.hpp"

namespace kerf {

template <int D, class P>
class Rates {
 public:
  using Real = typename P::Real;

  Rates() = default;
  Rates(const Vector<D, double>& gravity, const ArtificialStress& artificial_stress)
      : body_force_{Vector<D, Real>::from(gravity)},
        epsilon_(static_cast<Real>(artificial_stress.epsilon)),
        tensile_{static_cast<Real>(artificial_stress.exponent)} {}

  void evaluate(Particles<D, P>& particles, const NeighbourView& list) const {
    const auto view = particles.view();
    const Index n = particles.size();
    for_each_index(n, PairLoop<D, P, JointPairs, Continuity<D, P>, VelocityGradient<D, P>>(
                          view, list, {}, {}, {}));
    for_each_index(n, UpdateStress<D, P>{view});
    if (epsilon_ > Real(0)) for_each_index(n, ArtificialStressTensor<D, P>{view, epsilon_});
    accelerate(particles, view, list, EveryPair{}, body_force_);
  }

  // Accelerations by the pairs that `filter` chooses; into view.acceleration, from stresses at
  // hand.
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
