// SPDX-License-Identifier: Apache-2.0
// Between the particles, which are sorted anew as they move, and the solid, whose particles keep
// the numbers they were laid out with.
#pragma once

#include "materials/equation_of_state.hpp"
#include "neighbours/neighbour_list.hpp"
#include "particles/fields.hpp"
#include "rates/pair.hpp"
#include "solid/respond.hpp"
#include "solid/take_motion.hpp"

namespace kerf {

inline constexpr Index no_index = 0xffffffffu;

// Both directions of the correspondence. Ids of solid particles are those of the start.
struct SolidIndexView {
  const Index* number_of_id;  // solid number, or no_index
  Index ids;                  // entries of it
  Index* particle_of;         // per solid number: place among the particles, or no_index

  KERF_FUNCTION Index number(std::uint32_t id) const {
    return id < ids ? number_of_id[id] : no_index;
  }
};

template <int D, class P>
struct FindSolids {
  ParticleView<D, P> particles;
  SolidIndexView link;

  KERF_FUNCTION void operator()(Index i) const {
    const Index number = link.number(particles.id[i]);
    if (number != no_index) link.particle_of[number] = i;
  }
};

// The motion of the solid (solid/take_motion.hpp), as it will be `ahead` seconds from now if it
// goes on as it does. A particle that has left stays where it was last seen.
template <int D, class P>
struct MotionOfParticles {
  ParticleView<D, P> particles;
  SolidIndexView link;
  double ahead = 0.0;

  KERF_FUNCTION void take(const SolidView<D, P>& solid, Index s) const {
    const Index i = link.particle_of[s];
    if (i == no_index) return;
    auto position = particles.position[i];
    if (ahead > 0.0) position += ahead * Vector<D, double>::from(particles.velocity[i]);
    set_displacement(solid, s, position);
    solid.ends[s].velocity = particles.velocity[i];
  }
};

template <int D, class P>
struct AddSolidAcceleration {
  ParticleView<D, P> particles;
  SolidIndexView link;
  SolidView<D, P> solid;

  KERF_FUNCTION void operator()(Index s) const {
    const Index i = link.particle_of[s];
    if (i == no_index) return;
    particles.acceleration[i] += solid.acceleration[s];
    if (solid.has_mirrors()) particles.mirror_acceleration[i] += solid.mirror_acceleration[s];
  }
};

// Adds what bonds give, - tr sigma / 3, to the pressure of particles that hold together.
template <int D, class P>
struct ShowPressure {
  using Real = typename P::Real;
  ParticleView<D, P> particles;
  SolidIndexView link;
  SolidView<D, P> solid;

  KERF_FUNCTION void operator()(Index s) const {
    const Index i = link.particle_of[s];
    if (i == no_index || solid.loose[s]) return;
    particles.pressure[i] -= trace(cauchy_now(solid, s)) / Real(3);
  }
};

// Shows on the particles what has become of the solid. One that comes loose goes on as a fluid,
// with the pressure that it has: pushed, not pulled, by its neighbours.
template <int D, class P>
struct MarkLoose {
  using Real = typename P::Real;
  ParticleView<D, P> particles;
  SolidIndexView link;
  SolidView<D, P> solid;

  KERF_FUNCTION void operator()(Index s) const {
    const Index i = link.particle_of[s];
    if (i == no_index || !solid.loose[s] || particles.fractured[i]) return;
    particles.fractured[i] = 1;
    const auto& medium = particles.medium(i);
    const Real by_density = medium.template share_by_density<Real>(false) *
                            pressure_at(medium, particles.compression[i]);
    const Real by_bonds = -trace(cauchy_now(solid, s)) / Real(3);
    particles.compression[i] = Tait::compression(medium, by_density + by_bonds);
  }
};

// Those that are about to be removed and still hold on to others.
template <int D, class P>
struct FindLeavers {
  ParticleView<D, P> particles;
  SolidIndexView link;
  SolidView<D, P> solid;
  std::uint8_t* gone;

  KERF_FUNCTION void operator()(Index s) const {
    const Index i = link.particle_of[s];
    const bool leaves = i != no_index && particles.has(i, flag::outside | flag::erased);
    gone[s] = leaves && solid.whole_bonds(s) > 0 ? 1 : 0;
  }
};

// Whether an unbroken bond holds two particles together.
template <int D, class P>
struct WholeBonds {
  SolidIndexView link;
  SolidView<D, P> solid;

  KERF_FUNCTION bool whole(const ParticleView<D, P>& particles, const Pair<D, P>& pair) const {
    if (!pair.is_one_piece()) return false;
    const Index a = link.number(particles.id[pair.i]), b = link.number(particles.id[pair.j]);
    if (a == no_index || b == no_index) return false;
    const Index bond = bond_between(solid.bonds, a, b | pair.mirror);
    return bond != no_bond && solid.is_whole(a, bond);
  }

  // m; that of particles which are not of the start is without bounds.
  KERF_FUNCTION typename P::Real laid_out_distance(const ParticleView<D, P>& particles,
                                                   const Pair<D, P>& pair) const {
    const Index a = link.number(particles.id[pair.i]), b = link.number(particles.id[pair.j]);
    if (a == no_index || b == no_index) return typename P::Real(1e30);
    return norm(solid.reference_bond(a, BondEnd{b, pair.mirror}));
  }
};

// Whether the bonds of a particle that has lost none hold all that it lists of its own solid: what
// it touches besides, another arm of a folded piece, must be looked at.
template <int D, class P>
struct FindHeld {
  ParticleView<D, P> particles;
  SolidIndexView link;
  SolidView<D, P> solid;
  NeighbourView list;
  std::uint8_t* held;  // of particles; out

  KERF_FUNCTION void operator()(Index s) const {
    const Index i = link.particle_of[s];
    if (i == no_index) return;
    const Index first = list.begin[i] + list.alike[i], last = first + list.own[i];
    bool holds = !solid.torn[s];
    for (Index k = first; k < last && holds; ++k) {
      const Index other = link.number(particles.id[list.neighbour[k]]);
      holds = other != no_index && bond_between(solid.bonds, s, other) != no_bond;
    }
    held[i] = holds ? 1 : 0;
  }
};
// Where bonds broke since.
template <int D, class P>
struct LetGoOfTorn {
  SolidIndexView link;
  SolidView<D, P> solid;
  std::uint8_t* held;

  KERF_FUNCTION void operator()(Index s) const {
    const Index i = link.particle_of[s];
    if (i != no_index && solid.torn[s]) held[i] = 0;
  }
};

// A choice among pairs of particles, such as those across a plane, as a choice among bonds.
template <int D, class P, class Filter>
struct BondFilter {
  ParticleView<D, P> particles;
  SolidIndexView link;
  Filter filter;

  template <class End>
  KERF_FUNCTION bool operator()(Index a, const End& b) const {
    const Index i = link.particle_of[a], j = link.particle_of[b.particle];
    return i != no_index && j != no_index && filter(particles, i, j, b.mirror);
  }
};

}  // namespace kerf
