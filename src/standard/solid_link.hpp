// SPDX-License-Identifier: Apache-2.0
// The correspondence between the particles, which are sorted again as they move, and the solid,
// whose particles keep the numbers of the initial layout.
#pragma once

#include "fluid/density_pressure.hpp"
#include "neighbours/neighbour_list.hpp"
#include "pairs/pair.hpp"
#include "particles/fields.hpp"
#include "solid/bond_break_energy.hpp"
#include "solid/set_motion.hpp"

namespace kerf {

// Both directions of the correspondence. Ids of solid particles are those of the start.
struct SolidIndexView {
  const Index* solid_index_of_id;  // solid number, or no_index
  Index ids;                       // entries of it
  Index* particle_of;              // per solid number: index of the particle, or no_index

  KERF_FUNCTION Index number(std::uint32_t id) const {
    return id < ids ? solid_index_of_id[id] : no_index;
  }
};

template <int D, class P>
struct LinkSolids {
  ParticleView<D, P> particles;
  SolidIndexView link;

  KERF_FUNCTION void operator()(Index i) const {
    const Index number = link.number(particles.id[i]);
    if (number != no_index && !particles.ghosts.has(i)) link.particle_of[number] = i;
  }
};

// Sets the motion of the solid (solid/set_motion.hpp), extrapolated at constant velocity by the
// prediction time, s. A particle that has left the domain keeps its last position.
template <int D, class P>
struct MotionOfParticles {
  ParticleView<D, P> particles;
  SolidIndexView link;
  double prediction_time = 0.0;

  struct Motion {
    Vector<D, double> position;
    Vector<D, typename P::Real> velocity;
    std::uint8_t asleep;

    KERF_FUNCTION void set(const SolidView<D, P>& solid, Index s) const {
      solid.asleep[s] = asleep;
      if (asleep) return;
      set_displacement(solid, s, position);
      solid.ends[s].velocity = velocity;
    }
  };
  KERF_FUNCTION Motion of(Index i) const {
    auto position = particles.position[i];
    if (prediction_time > 0.0)
      position += prediction_time * Vector<D, double>::from(particles.velocity[i]);
    return {position, particles.velocity[i], particles.is_asleep(i)};
  }
  KERF_FUNCTION void take(const SolidView<D, P>& solid, Index s) const {
    const Index i = link.particle_of[s];
    if (i == no_index) return;
    solid.asleep[s] = particles.is_asleep(i);
    if (!solid.asleep[s]) of(i).set(solid, s);
  }
};

template <int D, class P>
struct AddSolidAcceleration {
  ParticleView<D, P> particles;
  SolidIndexView link;
  SolidView<D, P> solid;

  KERF_FUNCTION void operator()(Index s) const {
    const Index i = link.particle_of[s];
    if (i == no_index || particles.is_asleep(i)) return;
    particles.acceleration[i] += solid.acceleration[s];
    if (solid.has_mirrors()) particles.mirror_acceleration[i] += solid.mirror_acceleration[s];
  }
};

// The mean stress tr sigma / 3 of a particle of a solid by its bonds, Pa.
template <int D, class P>
struct MeanStress {
  using Real = typename P::Real;
  SolidView<D, P> solid;

  KERF_FUNCTION Real operator()(Index s) const {
    if (solid.detached[s] || solid.asleep[s]) return Real(0);
    return trace(cauchy_now(solid, s)) / Real(3);
  }
};

// Adds the pressure by bonds, to the pressure of particles that are not detached.
template <int D, class P>
struct ShowPressure {
  using Real = typename P::Real;
  ParticleView<D, P> particles;
  SolidIndexView link;
  SolidView<D, P> solid;

  const Real* mean_stress = nullptr;  // of each particle, where ranks divide the solid

  KERF_FUNCTION void operator()(Index s) const {
    const Index i = link.particle_of[s];
    if (i == no_index) return;
    particles.pressure[i] -= mean_stress != nullptr ? mean_stress[s] : MeanStress<D, P>{solid}(s);
  }
};

// Marks the particles of detached solid as fractured. A detached particle continues as a fluid
// whose density gives the pressure that it had, or less: it stores no more by its density than it
// did by density and bonds. Sums what it took over from its bonds less what its contacts held, J.
template <int D, class P>
struct MarkDetached {
  using Real = typename P::Real;
  ParticleView<D, P> particles;
  SolidIndexView link;
  SolidView<D, P> solid;
  BreakRecords<D, P> records;
  bool in_step;  // in the middle of a step: its end starts from the density at its start

  KERF_FUNCTION void add(Index s, Terms<1>& sum) const {
    const Index i = link.particle_of[s];
    if (i == no_index || !solid.detached[s] || particles.fractured[i]) return;
    const auto& medium = particles.medium(i);
    const double mass = solid.medium(s).mass;
    const double by_bonds = records.of == nullptr ? 0.0 : records.of[s].energy.less() / mass;
    const Real before = in_step ? particles.start_compression[i] : particles.compression[i];
    const double stored = energy_by_density(particles, i, double(before));
    const Real by_density = pressure_by_density(particles, i, before);
    particles.fractured[i] = 1;
    if (particles.face_normal != nullptr)
      particles.face_normal[i] = particles.face_corner[i] = Vector<D, Real>::zero();
    const Real compression = compression_with(s, medium, by_density, stored + by_bonds);
    const double taken = energy_at(medium, double(compression)) - stored;
    particles.compression[i] = particles.start_compression[i] = compression;
    particles.pressure_work[i] += static_cast<Real>(taken);
    sum.value[0] += mass * (taken - particles.contact_energy[i]);
  }

 private:
  // The compression that continues the pressure, `by_density` and by bonds, with no more energy
  // than `available`, J/kg.
  KERF_FUNCTION Real compression_with(Index s, const Medium<Real>& medium, Real by_density,
                                      double available) const {
    const Real by_bonds = -trace(cauchy_now(solid, s)) / Real(3);
    const Real equal = medium.tait.compression(by_density + by_bonds);
    const auto costs = [&](Real compression) {
      return energy_at(medium, double(compression)) > available;
    };
    if (!costs(equal)) return equal;
    Real low = 0, high = equal;  // halved until neither changes
    for (int k = 0; k < 60; ++k) {
      const Real middle = Real(0.5) * (low + high);
      (costs(middle) ? high : low) = middle;
    }
    return low;
  }
};

// Marks outflow particles (marked for removal) that still have intact bonds.
template <int D, class P>
struct MarkBondedOutflow {
  ParticleView<D, P> particles;
  SolidIndexView link;
  SolidView<D, P> solid;
  std::uint8_t* leaving;

  KERF_FUNCTION void operator()(Index s) const {
    const Index i = link.particle_of[s];
    const bool leaves = i != no_index && particles.has(i, flag::outside | flag::erased);
    leaving[s] = leaves && solid.intact_bonds(s) > 0 ? 1 : 0;
  }
};

// The intact bonds between particles, for contact (contact/debris_contact.hpp).
template <int D, class P>
struct IntactBonds {
  SolidIndexView link;
  SolidView<D, P> solid;

  KERF_FUNCTION bool is_intact(const ParticleView<D, P>& particles, const Pair<D, P>& pair) const {
    if (!pair.is_one_piece()) return false;
    const Index a = link.number(particles.id[pair.i]), b = link.number(particles.id[pair.j]);
    if (a == no_index || b == no_index) return false;
    const Index bond = bond_between(solid.bonds, a, b | pair.mirror);
    return bond != no_bond && solid.is_intact(a, bond);
  }

  // Reference distance, m; unbounded for particles that entered later.
  KERF_FUNCTION typename P::Real initial_distance(const ParticleView<D, P>& particles,
                                                  const Pair<D, P>& pair) const {
    const Index a = link.number(particles.id[pair.i]), b = link.number(particles.id[pair.j]);
    if (a == no_index || b == no_index) return typename P::Real(1e30);
    return norm(solid.reference_bond(a, BondEnd{b, pair.mirror}));
  }
};

// Marks fully bonded particles: those without broken bonds that are bonded to all their listed
// neighbours of the same body. Others, such as a folded piece that touches itself, need the test
// for contact.
template <int D, class P>
struct MarkFullyBonded {
  ParticleView<D, P> particles;
  SolidIndexView link;
  SolidView<D, P> solid;
  NeighbourView list;
  const std::uint8_t* listed_anew;  // of particles; the others are as they were. Null: all are
  std::uint8_t* fully_bonded;       // of particles; out

  KERF_FUNCTION void operator()(Index s) const {
    const Index i = link.particle_of[s];
    if (i == no_index || (listed_anew != nullptr && listed_anew[i] == 0)) return;
    const Index first = list.first_of_body(i), last = first + list.same_body[i];
    bool bonded = !solid.has_broken_bonds[s];
    for (Index k = first; k < last && bonded; ++k) {
      const Index other = link.number(particles.id[list.neighbour[k]]);
      bonded = other != no_index && bond_between(solid.bonds, s, other) != no_bond;
    }
    fully_bonded[i] = bonded ? 1 : 0;
  }
};
// Unmarks particles that have lost bonds since.
template <int D, class P>
struct UnmarkBroken {
  SolidIndexView link;
  SolidView<D, P> solid;
  std::uint8_t* fully_bonded;

  KERF_FUNCTION void operator()(Index s) const {
    const Index i = link.particle_of[s];
    if (i != no_index && solid.has_broken_bonds[s]) fully_bonded[i] = 0;
  }
};

// Applies a filter of pairs of particles, such as the pairs across a plane, to bonds.
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

// The same to bonds, given a view of particles whose positions are in the order of the solid. The
// bonds of particles that have left are broken.
template <int D, class P, class Filter>
struct FilterByNumber {
  ParticleView<D, P> by_number;
  Filter filter;

  template <class End>
  KERF_FUNCTION bool operator()(Index a, const End& b) const {
    return filter(by_number, a, b.particle, b.mirror);
  }
};

}  // namespace kerf
