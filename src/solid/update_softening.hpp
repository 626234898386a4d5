// SPDX-License-Identifier: Apache-2.0
// UpdateSoftening ends a step of media that soften: the next step starts from their largest strain.
#pragma once

#include "parallel/ordered_sum.hpp"
#include "solid/hourglass_modulus.hpp"

namespace kerf {

template <int D, class P>
struct StartSoftening {
  SolidView<D, P> solid;

  KERF_FUNCTION void operator()(Index i) const {
    solid.strain_start[i] = solid.current_strain[i] = 0;
    solid.softening_loss[i] = 0.0;
  }
};

// Returns what softening takes in this step besides the energy of a tensile test at the strain k
// (fracture/softening.hpp), J: a solid that is confined stores more, psi_t > E k^2 / 2
// (fracture/compressive_strength.hpp).
template <int D, class P>
KERF_FUNCTION double confined_softening(const SolidView<D, P>& solid, Index i) {
  const auto& medium = solid.medium(i);
  if (!(medium.confinement > 0) || !(solid.current_strain[i] > solid.strain_start[i])) return 0.0;
  const auto limits = BreakableSolid<double>::from(medium);
  const auto green = green_strain(Matrix<D, double>::from(solid.gradient[i]));
  const double strain = tensile_strain(limits, green);
  const double more =
      tensile_energy(limits, green) - 0.5 * limits.young_modulus() * strain * strain;
  const double less = undamaged_share(limits, double(solid.softening_strain_at_start(i))) -
                      undamaged_share(limits, double(solid.softening_strain(i)));
  return double(medium.mass) / double(medium.density) * double(solid.elastic_share[i]) * more *
         less;
}

// Takes the largest strain, and finds the particles that lose stiffness by it.
template <int D, class P>
struct UpdateSoftening {
  SolidView<D, P> solid;
  std::uint8_t* unchanged;  // out, of each particle: 0 where its hourglass control must be lowered

  KERF_FUNCTION void operator()(Index i) const {
    solid.softening_loss[i] = 0.0;
    unchanged[i] = 1;
    if (!solid.softens(i) || solid.detached[i]) return;
    solid.softening_loss[i] = confined_softening(solid, i);
    solid.strain_start[i] = solid.current_strain[i];
    if (is_hourglass_falling(solid, i)) unchanged[i] = 0;
  }
};

// Lowers the hourglass control to that of the remaining share; the excess of its energy is
// dissipated.
template <int D, class P>
struct SoftenHourglass {
  SolidView<D, P> solid;
  const std::uint8_t* unchanged;
  const typename P::Real* misfit_of;

  KERF_FUNCTION void operator()(Index i) const {
    if (!unchanged[i]) solid.softening_loss[i] += lower_hourglass(solid, i, double(misfit_of[i]));
  }
};

// Sums the energy that was lost in the last UpdateSoftening beside that of SofteningTerm, J.
template <int D, class P>
struct SofteningLossTerm {
  SolidView<D, P> solid;
  KERF_FUNCTION void add(Index i, Terms<1>& sum) const { sum.value[0] += solid.softening_loss[i]; }
};

// Returns the energy that softening took from particle i since the start of the run, J, at the
// strain k / R = `strain`: limits that are R times as large take R^2 times as much.
template <int D, class P>
KERF_FUNCTION double softening_work_up_to(const SolidView<D, P>& solid, Index i, double strain,
                                          double factor) {
  const auto medium = BreakableSolid<double>::from(solid.medium(i));
  return double(solid.medium(i).mass) / double(solid.medium(i).density) * factor * factor *
         softening_loss(medium, strain);
}
// The same up to the start of the step, and up to the current deformation.
template <int D, class P>
KERF_FUNCTION double softening_work_at_start(const SolidView<D, P>& solid, Index i) {
  if (!solid.softens(i)) return 0.0;
  return softening_work_up_to(solid, i, double(solid.softening_strain_at_start(i)),
                              double(solid.strength_factor_at_start(i)));
}
template <int D, class P>
KERF_FUNCTION double softening_work_of(const SolidView<D, P>& solid, Index i) {
  if (!solid.softens(i)) return 0.0;
  if (solid.detached[i]) return softening_work_at_start(solid, i);
  return softening_work_up_to(solid, i, double(solid.softening_strain(i)),
                              double(solid.strength_factor(i)));
}
template <int D, class P>
struct SofteningTerm {
  SolidView<D, P> solid;
  KERF_FUNCTION void add(Index i, Terms<1>& sum) const {
    sum.value[0] += softening_work_of(solid, i);
  }
};

}  // namespace kerf
