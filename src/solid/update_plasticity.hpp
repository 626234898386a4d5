// SPDX-License-Identifier: Apache-2.0
// UpdatePlasticity ends a step of media with plastic flow: the next step starts from their current
// state.
#pragma once

#include "parallel/ordered_sum.hpp"
#include "solid/hourglass_modulus.hpp"

namespace kerf {

template <int D, class P>
struct StartPlasticity {
  using Real = typename P::Real;
  SolidView<D, P> solid;

  KERF_FUNCTION void operator()(Index i) const {
    solid.flow_start[i] = solid.current_flow[i] = PlasticState<D, Real>::virgin();
    solid.flow_work[i] = Real(0);
    solid.flow_loss[i] = 0.0;
  }
};

// Returns the plastic work of particle i in the current step, J.
template <int D, class P>
KERF_FUNCTION double flow_work_of(const SolidView<D, P>& solid, Index i) {
  if (!solid.any_flows || solid.detached[i]) return 0.0;
  return double(solid.medium(i).reference_volume()) * double(solid.elastic_share[i]) *
         double(solid.flow_work[i]);
}

template <int D, class P>
struct UpdatePlasticity {
  using Real = typename P::Real;
  SolidView<D, P> solid;

  KERF_FUNCTION void operator()(Index i) const {
    solid.flow_loss[i] = 0.0;
    if (!solid.flows(i) || solid.detached[i]) return;
    solid.flow_loss[i] = flow_work_of(solid, i);
    solid.flow_work[i] = Real(0);
    solid.flow_start[i] = solid.current_flow[i];
    solid.flow_loss[i] += lower_hourglass(solid, i);
  }
};

template <int D, class P>
struct FlowWorkTerm {
  SolidView<D, P> solid;
  KERF_FUNCTION void add(Index i, Terms<1>& sum) const { sum.value[0] += flow_work_of(solid, i); }
};
// Sums the energy that the last UpdatePlasticity dissipated, J.
template <int D, class P>
struct FlowLossTerm {
  SolidView<D, P> solid;
  KERF_FUNCTION void add(Index i, Terms<1>& sum) const { sum.value[0] += solid.flow_loss[i]; }
};

}  // namespace kerf
