// SPDX-License-Identifier: Apache-2.0
// DebrisContact is the contact within one solid across broken bonds; the contact between bodies is
// contact/surface_contact.hpp. Particles closer than the mean of their spacings repel one another,
//   f = k (d_0 - r) e,   k = M d_0^(D-2),
// with d_0 at most the distance of their initial positions, so that a bond that breaks between two
// that are close from the start leaves no force behind, and M the mean of their P-wave moduli
// (K + 4 G / 3): the contact of two faces is as stiff as a layer of particles of the solid, so that
// a wave passes it. The force has the potential k (d_0 - r)^2 / 2, of which the energy balance
// counts half for each particle.
#pragma once

#include "pairs/pair.hpp"

namespace kerf {

// `Bonds`: bool is_intact(particles, pair), whether the two have an intact bond;
// Real initial_distance(particles, pair), the initial distance of two of one piece, m.
template <int D, class P, class Bonds>
struct DebrisContact {
  using Real = typename P::Real;
  static constexpr bool includes_rigid = false, only_adds = true;
  struct Sum {
    Vector<D, Real> contact{};
    Real contact_energy{};
  };
  Bonds bonds;

  KERF_FUNCTION void add(const ParticleView<D, P>& particles, const Pair<D, P>& pair,
                         Sum& sum) const {
    const auto &a = *pair.medium_i, &b = *pair.medium_j;
    if (a.phase != Phase::solid || !pair.is_one_piece()) return;
    if (particles.is_fluid(pair.i) || particles.is_fluid(pair.j)) return;
    if (is_one_volume(particles, pair)) return;
    const Real rest = Real(0.5) * (a.spacing + b.spacing);
    if (pair.distance >= rest || !(pair.distance > Real(0))) return;
    if (bonds.is_intact(particles, pair)) return;
    const Real initial = bonds.initial_distance(particles, pair);
    const Real overlap = (initial < rest ? initial : rest) - pair.distance;
    if (!(overlap > Real(0))) return;
    const Real stiffness = stiffness_of(a, b) * (D == 3 ? rest : Real(1));
    sum.contact += (stiffness * overlap / pair.distance) * pair.separation;
    sum.contact_energy += Real(0.25) * stiffness * overlap * overlap;
  }
  KERF_FUNCTION static Vector<D, Real> force(const Sum& sum) { return sum.contact; }
  KERF_FUNCTION void finish(const ParticleView<D, P>& particles, Index i, const Sum& sum) const {
    const auto& medium = particles.medium(i);
    if (medium.phase == Phase::rigid) return;
    const Real inverse = Real(1) / medium.mass;
    particles.acceleration[i] += inverse * sum.contact;
    particles.repulsion_potential[i] += inverse * sum.contact_energy;
  }

 private:
  KERF_FUNCTION static Real stiffness_of(const Medium<Real>& a, const Medium<Real>& b) {
    return Real(0.5) * (a.p_wave_modulus() + b.p_wave_modulus());
  }
};

}  // namespace kerf
