// SPDX-License-Identifier: Apache-2.0
// The end of a step of what flows: the state it came to is where the next step starts.
#pragma once

#include "exec/ordered_sum.hpp"
#include "solid/hourglass_modulus.hpp"

namespace kerf {

template <int D, class P>
struct StartUnflown {
  using Real = typename P::Real;
  SolidView<D, P> solid;

  KERF_FUNCTION void operator()(Index i) const {
    solid.flow_start[i] = solid.flow_now[i] = PlasticState<D, Real>::virgin();
    solid.flow_work[i] = Real(0);
    solid.flow_loss[i] = 0.0;
  }
};

template <int D, class P>
struct KeepFlow {
  using Real = typename P::Real;
  SolidView<D, P> solid;

  KERF_FUNCTION void operator()(Index i) const {
    solid.flow_loss[i] = 0.0;
    if (!solid.flows(i) || solid.loose[i]) return;
    const auto& medium = solid.medium(i);
    solid.flow_loss[i] = double(medium.volume()) * double(solid.flow_work[i]);
    solid.flow_work[i] = Real(0);
    solid.flow_start[i] = solid.flow_now[i];
    solid.flow_loss[i] += lower_hourglass(solid, i);
  }
};

// Plastic work of particle i in the step in hand, J.
template <int D, class P>
KERF_FUNCTION double flow_work_of(const SolidView<D, P>& solid, Index i) {
  if (!solid.any_flows || solid.loose[i]) return 0.0;
  return double(solid.medium(i).volume()) * double(solid.flow_work[i]);
}
template <int D, class P>
struct FlowWorkTerm {
  SolidView<D, P> solid;
  KERF_FUNCTION void add(Index i, Terms<1>& sum) const { sum.value[0] += flow_work_of(solid, i); }
};
// What the last KeepFlow dissipated, J.
template <int D, class P>
struct FlowLossTerm {
  SolidView<D, P> solid;
  KERF_FUNCTION void add(Index i, Terms<1>& sum) const { sum.value[0] += solid.flow_loss[i]; }
};

}  // namespace kerf
