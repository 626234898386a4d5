// SPDX-License-Identifier: Apache-2.0
// The end of a step of what softens: the largest strain there was is where the next step starts.
#pragma once

#include "exec/ordered_sum.hpp"
#include "solid/hourglass_modulus.hpp"

namespace kerf {

template <int D, class P>
struct StartWhole {
  SolidView<D, P> solid;

  KERF_FUNCTION void operator()(Index i) const {
    solid.strain_start[i] = solid.strain_now[i] = 0;
    solid.softening_loss[i] = 0.0;
  }
};

// The hourglass control of what is left; what it held too much of is lost with the rest.
template <int D, class P>
struct KeepSoftening {
  SolidView<D, P> solid;

  KERF_FUNCTION void operator()(Index i) const {
    solid.softening_loss[i] = 0.0;
    if (!solid.softens(i) || solid.loose[i]) return;
    solid.strain_start[i] = solid.strain_now[i];
    solid.softening_loss[i] = lower_hourglass(solid, i);
  }
};

// By the hourglass control, in the last KeepSoftening, J.
template <int D, class P>
struct SofteningLossTerm {
  SolidView<D, P> solid;
  KERF_FUNCTION void add(Index i, Terms<1>& sum) const { sum.value[0] += solid.softening_loss[i]; }
};

// Taken from particle i by softening since the start of the run, up to the deformation in force, J.
template <int D, class P>
KERF_FUNCTION double softening_work_of(const SolidView<D, P>& solid, Index i) {
  if (!solid.softens(i)) return 0.0;
  const auto medium = SolidMedium<double>::from(solid.medium(i));
  const auto strain = solid.loose[i] ? solid.strain_start[i] : solid.strain_now[i];
  return medium.volume() * softening_loss(medium, double(strain));
}
template <int D, class P>
struct SofteningTerm {
  SolidView<D, P> solid;
  KERF_FUNCTION void add(Index i, Terms<1>& sum) const {
    sum.value[0] += softening_work_of(solid, i);
  }
};

}  // namespace kerf
