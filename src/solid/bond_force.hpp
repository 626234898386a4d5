// SPDX-License-Identifier: Apache-2.0
// The force on a particle from its bonds, the slope of the stored energy
//   sum_i V_i psi(F_i) + 1/2 sum_i mu_i sum_j w_ij |gamma_ij|^2,   gamma_ij = F_i R - (x_j - x_i).
// Elastic part (Bonet & Lok 1999): sum_j w_ij (P_i B_i + P_j B_j) R. Hourglass part: the moment
// sum_j w_ij gamma_ij (x) R vanishes because F_i is the fit of least squares with these weights, so
// the derivative through F_i drops out (Silling, Comput. Methods Appl. Mech. Engrg. 322 (2017) 42)
// and what stays is - sum_j w_ij [mu_i (F_i R - x_ij) + mu_j (F_j R - x_ij)]. Together
//   m_i a_i = sum_j w_ij [(A_i + A_j) R + (mu_i + mu_j) (u_j - u_i)],   A of deform.hpp,
// equal and opposite on j: to the last bit, but for a bond from a particle that bond_lanes.hpp sums
// to one that the general walk sums, where it is to rounding.
#pragma once

#include "lanes/walk_in_blocks.hpp"
#include "solid/hourglass_viscosity.hpp"

namespace kerf {

// Viscosity along the line of centres of a bond that shortens (Monaghan, J. Comput. Phys. 82 (1989)
// 1), with the kernel and the distance of the reference configuration:
//   q_ij = rho (A c theta + B theta^2),   theta = -h (v_ij . x_ij) / (|x_ij| R) > 0,
// rho, c, h: means; A, B: geometric means; c: the longitudinal wave.
template <int D, class P>
struct BondViscosity {
  using Real = typename P::Real;
  static constexpr bool acts = true, in_lanes = true;

  // Adds the force on i and half of the power that the pair dissipates.
  template <class End>
  KERF_FUNCTION void add(const SolidView<D, P>& solid, const ChosenBond<D, Real, End>& chosen,
                         Vector<D, Real>& force, Real& power) const {
    const auto& [i, j, bond, weight] = chosen;
    const auto& a = solid.medium(i);
    const auto& b = solid.medium(j.particle);
    const Vector<D, Real> line = bond + solid.displacement_bond(i, j);
    const Real reference_length = norm(bond), length = norm(line);
    const Real approach = -dot(solid.velocity_bond(i, j), line);  // m^2/s
    if (!(approach > Real(0)) || !(length > Real(0))) return;
    const Real speed = approach / length;
    const Real theta =
        Real(0.5) * (a.smoothing_length + b.smoothing_length) * speed / reference_length;
    const Real wave = Real(0.5) * (a.longitudinal_speed() + b.longitudinal_speed());
    const Real linear = std::sqrt(a.artificial_linear * b.artificial_linear);
    const Real quadratic = std::sqrt(a.artificial_quadratic * b.artificial_quadratic);
    const Real pressure =
        Real(0.5) * (a.density + b.density) * theta * (linear * wave + quadratic * theta);
    const Real push = weight * reference_length * pressure;  // N
    force -= (push / length) * line;
    power += Real(0.5) * push * speed;
  }
};

template <int D, class P>
struct NoViscosity {
  using Real = typename P::Real;
  static constexpr bool acts = false, in_lanes = true;
};

// Of solids that flow.
template <int D, class P>
struct FlowViscosity {
  using Real = typename P::Real;
  static constexpr bool acts = true, in_lanes = false;
  BondViscosity<D, P> bonds;
  HourglassViscosity<D, P> hourglass;

  template <class End>
  KERF_FUNCTION void add(const SolidView<D, P>& solid, const ChosenBond<D, Real, End>& chosen,
                         Vector<D, Real>& force, Real& power) const {
    bonds.add(solid, chosen, force, power);
    hourglass.add(solid, chosen, force, power);
  }
};

struct EveryBond {
  template <class End>
  KERF_FUNCTION bool operator()(Index, const End&) const {
    return true;
  }
};

// `Filter` chooses bonds, e.g. those across a plane; then(i) comes after each particle.
template <int D, class P, class Viscosity, class Filter, class Then>
struct BondForce {
  using Real = typename P::Real;
  using Push = BondPush<D, Real>;
  SolidView<D, P> solid;
  Viscosity viscosity;
  Filter filter;
  Then then;
  BlockResults<Push> pushed{};  // by bonds that are not mixed

  KERF_FUNCTION void take(const BlockResults<Push>& known) { pushed = known; }

  KERF_FUNCTION void operator()(Index i) const {
    set(i);
    then(i);
  }

 private:
  KERF_FUNCTION void set(Index i) const {
    if (solid.has_mirrors()) solid.mirror_acceleration[i] = Vector<D, Real>::zero();
    Push sum{Vector<D, Real>::zero(), Real(0)};
    if (pushed.are_known() && !solid.mixed[i]) {
      if (!solid.loose[i]) sum = pushed[i];
    } else {
      sum = add_all(i);
    }
    solid.acceleration[i] = (Real(1) / solid.medium(i).mass) * sum.force;
    solid.viscous_power[i] = sum.power;
  }

  KERF_APART KERF_FUNCTION Push add_all(Index i) const {
    const Index end = solid.bonds.last(i), images = solid.first_image(i);
    Push sum = add_up<DirectEnd>(i, solid.bonds.first(i), images);
    if (solid.has_mirrors()) {
      const Push mirrored = add_up<BondEnd>(i, images, end);
      solid.mirror_acceleration[i] = (Real(1) / solid.medium(i).mass) * mirrored.force;
      sum.force += mirrored.force;
      sum.power += mirrored.power;
    }
    return sum;
  }

  // Over bonds k of particle i.
  template <class End>
  KERF_FUNCTION Push add_up(Index i, Index k, Index end) const {
    Push sum{Vector<D, Real>::zero(), Real(0)};
    const auto& own = solid.ends[i];
    const Matrix<D, Real> traction = own.traction;
    for (; k < end; ++k) {
      if (!solid.is_whole(i, k)) continue;
      const End j = solid.template bond_end<End>(i, k);
      if (!filter(i, j)) continue;
      const auto& other = solid.ends[j.particle];
      const Vector<D, Real> bond = solid.reference_bond(i, j);
      const ChosenBond<D, Real, End> chosen{i, j, bond, solid.weight(i, k, j, bond)};
      const Real stiffness = own.hourglass + other.hourglass;
      sum.force += chosen.weight * ((traction + solid.seen(j, other.traction)) * bond +
                                    stiffness * solid.displacement_bond(i, j));
      if constexpr (Viscosity::acts) viscosity.add(solid, chosen, sum.force, sum.power);
    }
    return sum;
  }
};

}  // namespace kerf
