// SPDX-License-Identifier: Apache-2.0
// SurfaceContact is the contact of solids with other solid or rigid bodies; the force of water on
// solids is fluid/fluid_force.hpp. Each particle i sums the kernel over the other body,
//   phi_i = sum_j V_j W_ij / phi_c,     phi_c: in first contact (contact/nominal_contact.hpp),
// once over solids and once over rigid bodies. An overlap has the energy
//   E_i = 1/2 K_i (phi_i - f_i)^2,      K_i = V_i M_i s,
// where f_i = 1, or the initial phi_i where that is more: in the corner of a frame a particle is
// near two faces, and bodies exert no force at their initial positions. The force is minus the
// exact gradient of this energy: equal and opposite, and smooth along the surface, since the kernel
// does not resolve single particles of the other body. M is the P-wave modulus and s such that a
// face on a face is as stiff as a layer of the solid: a wave passes it. Two solids share the
// stiffness; that with a rigid body is the solid's.
//
// Friction: friction * N, N the normal force of a particle, acts against the velocity v along the
// surface; below the speed  friction N d / (m c)  it is proportional to v, as much as a shear wave
// carries away, so that a sticking contact creeps slowly.
#pragma once

#include <cmath>
#include <vector>

#include "contact/nominal_contact.hpp"
#include "neighbours/pair_range.hpp"
#include "pairs/pair.hpp"

namespace kerf {

// Of a pair of media: 1 / phi_c of the first beside the second, and s if both have that spacing.
template <class Real>
struct ContactOfMedia {
  Real inverse_kernel_sum;
  Real stiffness;
};

// A table over pairs of media, by `source`.
template <class Real>
struct ContactTable {
  const ContactOfMedia<Real>* entries = nullptr;
  Index media = 0;
  KERF_FUNCTION Real inverse_kernel_sum(Index own, Index other) const {
    return entries[own * media + other].inverse_kernel_sum;
  }
  KERF_FUNCTION Real stiffness(Index own) const { return entries[own * media + own].stiffness; }
};

template <int D, class Scheme>
std::vector<ContactOfMedia<double>> contact_table(const std::vector<Medium<double>>& media) {
  using Kernel = typename Scheme::template Kernel<D>;
  std::vector<ContactOfMedia<double>> table;
  for (const auto& own : media)
    for (const auto& other : media) {
      const double h = Scheme::template smoothing_length<double>(own, other);
      const auto nominal = nominal_contact<D, Kernel>(own.spacing, other.spacing, h);
      const double ratio = nominal.kernel_sum / (nominal.slope * own.spacing);
      table.push_back({1.0 / nominal.kernel_sum, ratio * ratio});
    }
  return table;
}

template <int D, class P>
KERF_FUNCTION bool is_surface_contact(const ParticleView<D, P>& particles, const Pair<D, P>& pair) {
  const auto &a = *pair.medium_i, &b = *pair.medium_j;
  return a.phase != Phase::water && b.phase != Phase::water && !pair.is_one_piece() &&
         !particles.is_fluid(pair.i) && !particles.is_fluid(pair.j);
}

// The first pass: the contact state of the particles of solids.
template <int D, class P>
struct SurfaceOverlap {
  using Real = typename P::Real;
  static constexpr bool includes_rigid = false;
  struct Side {
    Real kernel_sum{};
    Vector<D, Real> slope{};
  };
  struct Sum {
    Side solid, rigid;
  };
  ContactTable<Real> table;
  bool sets_initial_overlap = false;  // instead of the contact state

  KERF_FUNCTION void add(const ParticleView<D, P>& particles, const Pair<D, P>& pair,
                         Sum& sum) const {
    if (!is_surface_contact(particles, pair)) return;
    const Real share = pair.medium_j->volume *
                       table.inverse_kernel_sum(particles.source[pair.i], particles.source[pair.j]);
    Side& side = pair.medium_j->phase == Phase::rigid ? sum.rigid : sum.solid;
    side.kernel_sum += share * ContactPairs::Kernel<D>::value(pair.distance, pair.smoothing_length);
    side.slope += share * pair.gradient;
  }
  KERF_FUNCTION void finish(const ParticleView<D, P>& particles, Index i, const Sum& sum) const {
    if (sets_initial_overlap) {
      particles.solid_initial_overlap[i] =
          sum.solid.kernel_sum > Real(1) ? sum.solid.kernel_sum : Real(1);
      particles.rigid_initial_overlap[i] =
          sum.rigid.kernel_sum > Real(1) ? sum.rigid.kernel_sum : Real(1);
      return;
    }
    const auto& medium = particles.medium(i);
    const Real stiffness =
        medium.volume * medium.p_wave_modulus() * table.stiffness(particles.source[i]);
    particles.solid_contact[i] =
        contact_state_of(Real(0.5) * stiffness, sum.solid,
                         particles.solid_initial_overlap[i]);  // the other solid has the rest
    particles.rigid_contact[i] =
        contact_state_of(stiffness, sum.rigid, particles.rigid_initial_overlap[i]);
  }

 private:
  KERF_FUNCTION static ContactState<D, Real> contact_state_of(Real stiffness, const Side& side,
                                                              Real initial_overlap) {
    const Real overlap = side.kernel_sum - initial_overlap, slope = norm(side.slope);
    if (!(overlap > Real(0)) || !(slope > Real(0))) return ContactState<D, Real>::none();
    const Real force = stiffness * overlap;
    return {force, Real(0.5) * force * overlap, slope, (Real(1) / slope) * side.slope};
  }
};

// The second pass: forces.
template <int D, class P>
struct SurfaceContact {
  using Real = typename P::Real;
  static constexpr bool includes_rigid = false;
  struct Sum {
    Vector<D, Real> normal_force{}, friction{}, by_rigid{};
  };
  ContactTable<Real> table;

  KERF_FUNCTION void add(const ParticleView<D, P>& particles, const Pair<D, P>& pair,
                         Sum& sum) const {
    if (!is_surface_contact(particles, pair) || pair.medium_i->phase != Phase::solid) return;
    const Index a = particles.source[pair.i], b = particles.source[pair.j];
    const bool rigid = pair.medium_j->phase == Phase::rigid;
    const auto& own = rigid ? particles.rigid_contact[pair.i] : particles.solid_contact[pair.i];
    add_side(pair, own, *pair.medium_i,
             own.force * table.inverse_kernel_sum(a, b) * pair.medium_j->volume, sum);
    if (rigid) return;
    auto other = particles.solid_contact[pair.j];
    other.normal = pair.of_j(other.normal);
    add_side(pair, other, *pair.medium_j,
             other.force * table.inverse_kernel_sum(b, a) * pair.medium_i->volume, sum);
  }
  KERF_FUNCTION static Vector<D, Real> force(const Sum& sum) {
    return sum.normal_force + sum.friction - sum.by_rigid;
  }
  KERF_FUNCTION void finish(const ParticleView<D, P>& particles, Index i, const Sum& sum) const {
    const auto& medium = particles.medium(i);
    if (medium.phase != Phase::solid) return;
    const Real inverse = Real(1) / medium.mass;
    particles.acceleration[i] += inverse * (sum.normal_force + sum.friction);
    particles.damping_acceleration[i] += inverse * sum.friction;
    particles.repulsion[i] += inverse * sum.by_rigid;
    particles.repulsion_potential[i] +=
        inverse * (particles.solid_contact[i].energy + particles.rigid_contact[i].energy);
  }

 private:
  // Adds the force from the energy of the contact state `contact` of a particle of `medium`;
  // `slope`: the derivative of that energy by W.
  KERF_FUNCTION static void add_side(const Pair<D, P>& pair, const ContactState<D, Real>& contact,
                                     const Medium<Real>& medium, Real slope, Sum& sum) {
    if (!(slope > Real(0))) return;
    const auto normal_force = (-slope) * pair.gradient;
    auto force = normal_force;
    const Real coefficient = pair.medium_i->friction < pair.medium_j->friction
                                 ? pair.medium_i->friction
                                 : pair.medium_j->friction;
    if (coefficient > Real(0)) {
      const auto drag =
          friction(pair, contact, medium, coefficient * std::abs(dot(normal_force, contact.normal)),
                   coefficient);
      sum.friction += drag;
      force += drag;
    }
    sum.normal_force += normal_force;
    if (pair.medium_j->phase == Phase::rigid) sum.by_rigid += force;
  }
  KERF_FUNCTION static Vector<D, Real> friction(const Pair<D, P>& pair,
                                                const ContactState<D, Real>& contact,
                                                const Medium<Real>& medium, Real most,
                                                Real coefficient) {
    const auto along = pair.velocity - dot(pair.velocity, contact.normal) * contact.normal;
    const Real speed = norm(along);
    const Real creep = coefficient * contact.force * contact.slope * medium.spacing /
                       (medium.mass * medium.longitudinal_speed);
    const Real scale = speed > creep ? speed : creep;
    return scale > Real(0) ? (-most / scale) * along : Vector<D, Real>::zero();
  }
};

}  // namespace kerf
