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

#include "lanes/packed_bonds.hpp"
#include "solid/hourglass_viscosity.hpp"

namespace kerf {

// Viscosity along the line of centres of a bond that shortens (Monaghan, J. Comput. Phys. 82 (1989)
// 1), with the kernel and the distance of the reference configuration:
//   q_ij = rho (A c theta + B theta^2),   theta = -h (v_ij . x_ij) / (|x_ij| R) > 0,
// rho, c, h: means; A, B: geometric means; c: the longitudinal wave.
template <int D, class P>
struct BondViscosity {
  using Real = typename P::Real;
  static constexpr bool acts = true;
  const Vector<D, Real>* velocity;

  // Adds the force on i and half of the power that the pair dissipates.
  template <class End>
  KERF_FUNCTION void add(const SolidView<D, P>& solid, Index i, Index k, const End& j,
                         Vector<D, Real>& force, Real& power) const {
    const auto& a = solid.medium(i);
    const auto& b = solid.medium(j.particle);
    const Vector<D, Real> bond = solid.reference_bond(i, j);
    const Vector<D, Real> line = bond + solid.displacement_bond(i, j);
    const Real reference_length = norm(bond), length = norm(line);
    const Real approach = -dot(solid.of(j, velocity) - velocity[i], line);  // m^2/s
    if (!(approach > Real(0)) || !(length > Real(0))) return;
    const Real speed = approach / length;
    const Real theta =
        Real(0.5) * (a.smoothing_length + b.smoothing_length) * speed / reference_length;
    const Real wave = Real(0.5) * (a.longitudinal_speed() + b.longitudinal_speed());
    const Real linear = std::sqrt(a.artificial_linear * b.artificial_linear);
    const Real quadratic = std::sqrt(a.artificial_quadratic * b.artificial_quadratic);
    const Real pressure =
        Real(0.5) * (a.density + b.density) * theta * (linear * wave + quadratic * theta);
    const Real push = solid.weight[k] * reference_length * pressure;  // N
    force -= (push / length) * line;
    power += Real(0.5) * push * speed;
  }
};

template <int D, class P>
struct NoViscosity {
  using Real = typename P::Real;
  static constexpr bool acts = false;
};

// Of solids that flow.
template <int D, class P>
struct FlowViscosity {
  using Real = typename P::Real;
  static constexpr bool acts = true;
  BondViscosity<D, P> bonds;
  HourglassViscosity<D, P> hourglass;

  template <class End>
  KERF_FUNCTION void add(const SolidView<D, P>& solid, Index i, Index k, const End& j,
                         Vector<D, Real>& force, Real& power) const {
    bonds.add(solid, i, k, j, force, power);
    hourglass.add(solid, i, k, j, force, power);
  }
};

struct EveryBond {
  template <class End>
  KERF_FUNCTION bool operator()(Index, const End&) const {
    return true;
  }
};

// `Filter` chooses bonds, e.g. those across a plane.
template <int D, class P, class Viscosity, class Filter>
struct BondForce {
  using Real = typename P::Real;
  SolidView<D, P> solid;
  Viscosity viscosity;
  Filter filter;
  const BondPush<D, Real>* pushed = nullptr;  // by bonds that are not mixed; or null

  KERF_FUNCTION void operator()(Index i) const {
    if (pushed != nullptr && !solid.mixed[i]) {
      solid.acceleration[i] = (Real(1) / solid.medium(i).mass) * pushed[i].force;
      solid.viscous_power[i] = pushed[i].power;
      if (solid.mirrors.faces != 0) solid.mirror_acceleration[i] = Vector<D, Real>::zero();
      return;
    }
    const Index end = solid.bond_begin[i + 1], images = solid.first_image(i);
    Sum sum = add_up<DirectEnd>(i, solid.bond_begin[i], images);
    const Real inverse = Real(1) / solid.medium(i).mass;
    if (solid.mirrors.faces != 0) {
      const Sum mirrored = add_up<BondEnd>(i, images, end);
      solid.mirror_acceleration[i] = inverse * mirrored.force;
      sum.force += mirrored.force;
      sum.power += mirrored.power;
    }
    solid.acceleration[i] = inverse * sum.force;
    solid.viscous_power[i] = sum.power;
  }

 private:
  struct Sum {
    Vector<D, Real> force;  // N
    Real power;             // W
  };

  // Over bonds k of particle i.
  template <class End>
  KERF_FUNCTION Sum add_up(Index i, Index k, Index end) const {
    Sum sum{Vector<D, Real>::zero(), Real(0)};
    const Real modulus = solid.hourglass[i];
    const Matrix<D, Real> traction = solid.traction[i];
    for (; k < end; ++k) {
      const Real weight = solid.weight[k];
      if (!(weight > Real(0))) continue;
      const End j = solid.template bond_end<End>(k);
      if (!filter(i, j)) continue;
      const Real stiffness = modulus + solid.hourglass[j.particle];
      sum.force += weight * ((traction + solid.of(j, solid.traction)) * solid.reference_bond(i, j) +
                             stiffness * solid.displacement_bond(i, j));
      if constexpr (Viscosity::acts) viscosity.add(solid, i, k, j, sum.force, sum.power);
    }
    return sum;
  }
};

}  // namespace kerf
