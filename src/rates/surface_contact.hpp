// SPDX-License-Identifier: Apache-2.0
// Contact of solids that hold together with other bodies. Each particle i measures how much of the
// room around it another body fills,
//   phi_i = sum_j V_j W_ij / phi_c,     phi_c: where the two just touch (nominal_contact.hpp),
// in two sums, over solids and over rigid bodies. Beyond a touch that costs the energy
//   E_i = 1/2 K_i (phi_i - f_i)^2,      K_i = V_i M_i s,
// where f_i = 1, or phi_i as laid out where that is more: in the corner of a frame a particle sees
// two faces, and bodies as laid out do not push.
// Of this energy the force is the exact slope: equal and opposite, and smooth along the surface,
// since the kernel does not see single particles of the other body. M is the P-wave modulus and s
// such that a face on a face is as stiff as a layer of the solid: a wave passes it. Two solids
// share the stiffness; a rigid body leaves it to the solid.
//
// Friction: of the normal force N of a particle, friction * N against the speed v along the
// surface, up to the speed  friction N d / (m c)  in proportion to it: as much as a shear wave
// carries away, so that what sticks creeps by a trace.
#pragma once

#include <cmath>
#include <vector>

#include "neighbours/pair_range.hpp"
#include "rates/nominal_contact.hpp"
#include "rates/pair.hpp"

namespace kerf {

// Of a pair of media: 1 / phi_c as the first sees the second, and s if both are of that spacing.
template <class Real>
struct TouchOfMedia {
  Real inverse_filling;
  Real stiffness;
};

// A table over pairs of media, by `source`.
template <class Real>
struct TouchTable {
  const TouchOfMedia<Real>* entries = nullptr;
  Index media = 0;
  KERF_FUNCTION Real inverse_filling(Index own, Index other) const {
    return entries[own * media + other].inverse_filling;
  }
  KERF_FUNCTION Real stiffness(Index own) const { return entries[own * media + own].stiffness; }
};

template <int D, class Scheme>
std::vector<TouchOfMedia<double>> touch_table(const std::vector<Medium<double>>& media) {
  using Kernel = typename Scheme::template Kernel<D>;
  std::vector<TouchOfMedia<double>> table;
  for (const auto& own : media)
    for (const auto& other : media) {
      const double h = Scheme::template smoothing_length<double>(own, other);
      const auto touch = nominal_contact<D, Kernel>(own.spacing, other.spacing, h);
      const double ratio = touch.filling / (touch.slope * own.spacing);
      table.push_back({1.0 / touch.filling, ratio * ratio});
    }
  return table;
}

template <int D, class P>
KERF_FUNCTION bool touches_surface(const ParticleView<D, P>& particles, const Pair<D, P>& pair) {
  const auto &a = *pair.medium_i, &b = *pair.medium_j;
  return a.phase != Phase::water && b.phase != Phase::water && !pair.is_one_piece() &&
         !particles.is_fluid(pair.i) && !particles.is_fluid(pair.j);
}

// The first pass, for the particles of solids.
template <int D, class P>
struct SurfaceOverlap {
  using Real = typename P::Real;
  static constexpr bool feels_rigid = false;
  struct Side {
    Real filling{};
    Vector<D, Real> slope{};
  };
  struct Sum {
    Side solid, rigid;
  };
  TouchTable<Real> table;
  bool as_laid_out = false;  // find the fit, not the touch

  KERF_FUNCTION void add(const ParticleView<D, P>& particles, const Pair<D, P>& pair,
                         Sum& sum) const {
    if (!touches_surface(particles, pair)) return;
    const Real share = pair.medium_j->volume *
                       table.inverse_filling(particles.source[pair.i], particles.source[pair.j]);
    Side& side = pair.medium_j->phase == Phase::rigid ? sum.rigid : sum.solid;
    side.filling += share * ContactPairs::Kernel<D>::value(pair.distance, pair.smoothing_length);
    side.slope += share * pair.gradient;
  }
  KERF_FUNCTION void finish(const ParticleView<D, P>& particles, Index i, const Sum& sum) const {
    if (as_laid_out) {
      particles.solid_fit[i] = sum.solid.filling > Real(1) ? sum.solid.filling : Real(1);
      particles.rigid_fit[i] = sum.rigid.filling > Real(1) ? sum.rigid.filling : Real(1);
      return;
    }
    const auto& medium = particles.medium(i);
    const Real whole =
        medium.volume * medium.p_wave_modulus() * table.stiffness(particles.source[i]);
    particles.solid_touch[i] =
        touch_of(Real(0.5) * whole, sum.solid, particles.solid_fit[i]);  // the other has the rest
    particles.rigid_touch[i] = touch_of(whole, sum.rigid, particles.rigid_fit[i]);
  }

 private:
  KERF_FUNCTION static Touch<D, Real> touch_of(Real stiffness, const Side& side, Real fit) {
    const Real overlap = side.filling - fit, slope = norm(side.slope);
    if (!(overlap > Real(0)) || !(slope > Real(0))) return Touch<D, Real>::none();
    const Real push = stiffness * overlap;
    return {push, Real(0.5) * push * overlap, slope, (Real(1) / slope) * side.slope};
  }
};

// The second pass: forces.
template <int D, class P>
struct SurfaceContact {
  using Real = typename P::Real;
  static constexpr bool feels_rigid = false;
  struct Sum {
    Vector<D, Real> pressing{}, friction{}, by_rigid{};
  };
  TouchTable<Real> table;

  KERF_FUNCTION void add(const ParticleView<D, P>& particles, const Pair<D, P>& pair,
                         Sum& sum) const {
    if (!touches_surface(particles, pair) || pair.medium_i->phase != Phase::solid) return;
    const Index a = particles.source[pair.i], b = particles.source[pair.j];
    const bool rigid = pair.medium_j->phase == Phase::rigid;
    const auto& own = rigid ? particles.rigid_touch[pair.i] : particles.solid_touch[pair.i];
    const Real seen = own.push * table.inverse_filling(a, b) * pair.medium_j->volume;
    add_side(pair, own, *pair.medium_i, seen, sum);
    if (rigid) return;
    auto other = particles.solid_touch[pair.j];
    other.normal = pair.of_j(other.normal);
    add_side(pair, other, *pair.medium_j,
             other.push * table.inverse_filling(b, a) * pair.medium_i->volume, sum);
  }
  KERF_FUNCTION static Vector<D, Real> force(const Sum& sum) {
    return sum.pressing + sum.friction - sum.by_rigid;
  }
  KERF_FUNCTION void finish(const ParticleView<D, P>& particles, Index i, const Sum& sum) const {
    const auto& medium = particles.medium(i);
    if (medium.phase != Phase::solid) return;
    const Real inverse = Real(1) / medium.mass;
    particles.acceleration[i] += inverse * (sum.pressing + sum.friction);
    particles.damping_acceleration[i] += inverse * sum.friction;
    particles.repulsion[i] += inverse * sum.by_rigid;
    particles.repulsion_potential[i] +=
        inverse * (particles.solid_touch[i].energy + particles.rigid_touch[i].energy);
  }

 private:
  // The part that comes of the energy of `touch`, of a particle of `medium`; `slope`: of that
  // energy over W.
  KERF_FUNCTION static void add_side(const Pair<D, P>& pair, const Touch<D, Real>& touch,
                                     const Medium<Real>& medium, Real slope, Sum& sum) {
    if (!(slope > Real(0))) return;
    const auto push = (-slope) * pair.gradient;
    auto force = push;
    const Real coefficient = pair.medium_i->friction < pair.medium_j->friction
                                 ? pair.medium_i->friction
                                 : pair.medium_j->friction;
    if (coefficient > Real(0)) {
      const auto drag = friction(pair, touch, medium,
                                 coefficient * std::abs(dot(push, touch.normal)), coefficient);
      sum.friction += drag;
      force += drag;
    }
    sum.pressing += push;
    if (pair.medium_j->phase == Phase::rigid) sum.by_rigid += force;
  }
  KERF_FUNCTION static Vector<D, Real> friction(const Pair<D, P>& pair, const Touch<D, Real>& touch,
                                                const Medium<Real>& medium, Real most,
                                                Real coefficient) {
    const auto along = pair.velocity - dot(pair.velocity, touch.normal) * touch.normal;
    const Real speed = norm(along);
    const Real creep = coefficient * touch.push * touch.slope * medium.spacing /
                       (medium.mass * medium.longitudinal_speed);
    const Real scale = speed > creep ? speed : creep;
    return scale > Real(0) ? (-most / scale) * along : Vector<D, Real>::zero();
  }
};

}  // namespace kerf
