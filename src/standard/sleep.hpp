// SPDX-License-Identifier: Apache-2.0
// Solid that nothing has reached sleeps: it keeps its state, and the loops of a step leave it out
// (docs/theory/sleep.md). A particle is `moving` from the end of the first step after which it is
// faster than the waking speed, 2^-24 of that of the fastest jet, the rounding of a number in
// single precision; those of bodies whose motion is prescribed and those of water are from the
// start. It is `reached` once it or a particle with which it interacts is moving. A
// particle of a solid falls asleep if it is undeformed, unloaded and exactly at rest and neither it
// nor a particle with which it interacts is reached, and wakes as soon as one is: its force follows
// from their stresses, and these from the positions of their own neighbours. Without a jet the
// waking speed is 0, and the solid moves bit for bit as if it had not slept.
#pragma once

#include "neighbours/neighbour_list.hpp"
#include "particles/fields.hpp"
#include "standard/solid_link.hpp"

namespace kerf {

// The loop of `body` over the particles that do not sleep.
template <int D, class P, class Body>
struct OfAwake {
  ParticleView<D, P> particles;
  Body body;

  OfAwake(const ParticleView<D, P>& view, const Body& loop) : particles(view), body(loop) {}
  KERF_FUNCTION void operator()(Index i) const {
    if (!particles.is_asleep(i)) body(i);
  }
};

// Sets the accelerations of sleeping particles, which no loop computes, to what they are.
template <int D, class P>
struct ClearForcesAsleep {
  using Real = typename P::Real;
  ParticleView<D, P> particles;

  KERF_FUNCTION void operator()(Index i) const {
    if (!particles.is_asleep(i)) return;
    const auto zero = Vector<D, Real>::zero();
    particles.acceleration[i] = particles.repulsion[i] = zero;
    particles.pressure_acceleration[i] = particles.damping_acceleration[i] = zero;
    particles.repulsion_potential[i] = Real(0);
    if (particles.mirrors.faces != 0) particles.mirror_acceleration[i] = zero;
  }
};

// The values of the fields `moving` and `reached`.
namespace activity {
inline constexpr std::uint8_t none = 0, since_before = 1, newly = 2;
}

// Marks the particles of bodies whose motion is prescribed: it may begin at any time, without a
// force that neighbours would see before.
template <int D, class P>
struct MarkDriven {
  ParticleView<D, P> particles;
  const std::uint8_t* is_driven;  // by medium

  KERF_FUNCTION void operator()(Index i) const {
    if (is_driven[particles.source[i]] != 0) particles.moving[i] = activity::since_before;
  }
};

// Marks the particles that are newly moving, and returns whether there are any.
template <int D, class P>
struct MarkNewlyMoving {
  ParticleView<D, P> particles;
  double waking_speed;  // m/s

  KERF_FUNCTION bool operator()(Index i) const {
    if (particles.moving[i] != activity::none) return false;
    const auto v = Vector<D, double>::from(particles.velocity[i]);
    if (!(dot(v, v) > waking_speed * waking_speed)) return false;
    particles.moving[i] = activity::newly;
    return true;
  }
};

// Actions on a particle that interacts with another: it is reached, or wakes.
template <int D, class P>
struct MarkReached {
  ParticleView<D, P> particles;
  KERF_FUNCTION bool spreads_from(Index i) const { return particles.moving[i] == activity::newly; }
  KERF_FUNCTION void operator()(Index j) const {
    if (load_flag(particles.reached[j]) == activity::none)
      store_flag(particles.reached[j], activity::newly);
  }
  // Of a particle and its ghost.
  static std::uint8_t merged(std::uint8_t own, std::uint8_t ghost) {
    return own == activity::none && ghost == activity::newly ? ghost : own;
  }
};
template <int D, class P>
struct WakeParticle {
  ParticleView<D, P> particles;
  KERF_FUNCTION bool spreads_from(Index i) const { return particles.reached[i] == activity::newly; }
  KERF_FUNCTION void operator()(Index j) const { store_flag(particles.asleep[j], 0); }
  static std::uint8_t merged(std::uint8_t own, std::uint8_t ghost) { return std::min(own, ghost); }
};

// Apply an action to the particles from which it spreads and to their neighbours.
template <int D, class P, template <int, class> class Action>
struct SpreadToNeighbours {
  Action<D, P> action;
  NeighbourView list;

  KERF_FUNCTION void operator()(Index i) const {
    if (!action.spreads_from(i)) return;
    action(i);
    for (Index k = list.first(i); k < list.last(i); ++k)
      action(action.particles.mirrors.particle(list.neighbour[k]));
  }
};
// The same to the other ends of their bonds.
template <int D, class P, template <int, class> class Action>
struct SpreadToBondEnds {
  Action<D, P> action;
  SolidIndexView link;
  SolidView<D, P> solid;

  KERF_FUNCTION void operator()(Index s) const {
    if (spreads_from(s)) from(s);
  }
  KERF_FUNCTION bool spreads_from(Index s) const {
    const Index i = link.particle_of[s];
    return i != no_index && action.spreads_from(i);
  }
  KERF_FUNCTION void from(Index s) const {
    for (Index k = solid.bonds.first(s); k < solid.bonds.last(s); ++k) {
      const Index j = link.particle_of[solid.bond_end(s, k).particle];
      if (j != no_index) action(j);
    }
  }
};

// From which particles of a solid an action spreads.
template <int D, class P, template <int, class> class Action>
struct SpreadsFrom {
  const SpreadToBondEnds<D, P, Action>& spread;
  bool operator()(Index s) const { return spread.spreads_from(s); }
};

// What is newly moving or reached is so since before from now on.
template <int D, class P>
struct KeepActivity {
  ParticleView<D, P> particles;
  KERF_FUNCTION void operator()(Index i) const {
    if (particles.moving[i] != activity::none) particles.moving[i] = activity::since_before;
    if (particles.reached[i] != activity::none) particles.reached[i] = activity::since_before;
  }
};

// Whether a flag is set of a neighbour of particle i.
template <int D, class P>
KERF_FUNCTION bool any_neighbour(const ParticleView<D, P>& particles, const NeighbourView& list,
                                 Index i, const std::uint8_t* flag) {
  for (Index k = list.first(i); k < list.last(i); ++k)
    if (flag[particles.mirrors.particle(list.neighbour[k])] != 0) return true;
  return false;
}

// Marks the particles as newly reached that have a moving neighbour in a new list, and returns
// whether there are any.
template <int D, class P>
struct ReachListedAnew {
  ParticleView<D, P> particles;
  NeighbourView list;
  const std::uint8_t* listed_anew;  // null: all are

  KERF_FUNCTION bool operator()(Index i) const {
    if (listed_anew != nullptr && listed_anew[i] == 0) return false;
    if (particles.reached[i] != activity::none ||
        !any_neighbour(particles, list, i, particles.moving))
      return false;
    particles.reached[i] = activity::newly;
    return true;
  }
};
// Wakes those that have a reached neighbour in a new list.
template <int D, class P>
struct WakeListedAnew {
  ParticleView<D, P> particles;
  NeighbourView list;
  const std::uint8_t* listed_anew;  // null: all are

  KERF_FUNCTION void operator()(Index i) const {
    if (!particles.is_asleep(i) || (listed_anew != nullptr && listed_anew[i] == 0)) return;
    if (any_neighbour(particles, list, i, particles.reached)) particles.asleep[i] = 0;
  }
};

// Whether a particle of a solid is exactly undeformed.
template <int D, class P>
struct IsUndeformed {
  using Real = typename P::Real;
  SolidView<D, P> solid;

  KERF_FUNCTION bool operator()(Index s) const {
    if (solid.detached[s] != 0) return false;
    const auto& own = solid.ends[s];
    bool zero = is_zero(own.displacement) && is_zero(own.remainder);
    for (int k = 0; k < D * D; ++k)
      zero =
          zero && own.traction.component[k] == Real(0) && solid.gradient[s].component[k] == Real(0);
    return zero;
  }
  KERF_FUNCTION static bool is_zero(const Vector<D, Real>& v) {
    bool zero = true;
    for (int a = 0; a < D; ++a) zero = zero && v[a] == Real(0);
    return zero;
  }
};

// Lets particles fall asleep, at the end of a step, all of whose forces are known.
template <int D, class P>
struct FallAsleep {
  using Real = typename P::Real;
  ParticleView<D, P> particles;
  NeighbourView list;
  SolidIndexView link;
  SolidView<D, P> solid;
  // Of all particles of a solid that ranks divide: whether it is undeformed, or reached.
  const std::uint8_t *undeformed = nullptr, *reached = nullptr;

  KERF_FUNCTION void operator()(Index s) const {
    const Index i = link.particle_of[s];
    if (i == no_index || particles.asleep[i] != 0) return;
    if (is_at_rest(i) && is_undeformed(s) &&
        !any_neighbour(particles, list, i, particles.reached) && !has_reached_bond_end(s))
      particles.asleep[i] = 1;
  }

 private:
  KERF_FUNCTION bool is_at_rest(Index i) const {
    return particles.reached[i] == 0 && IsUndeformed<D, P>::is_zero(particles.velocity[i]) &&
           IsUndeformed<D, P>::is_zero(particles.acceleration[i]) &&
           particles.compression_rate[i] == Real(0) && !particles.is_constrained(i) &&
           particles.fractured[i] == 0;
  }
  KERF_FUNCTION bool is_undeformed(Index s) const {
    return undeformed != nullptr ? undeformed[s] != 0 : IsUndeformed<D, P>{solid}(s);
  }
  KERF_FUNCTION bool has_reached_bond_end(Index s) const {
    for (Index k = solid.bonds.first(s); k < solid.bonds.last(s); ++k) {
      const Index end = solid.bond_end(s, k).particle, j = link.particle_of[end];
      if (reached != nullptr ? reached[end] != 0 : j != no_index && particles.reached[j] != 0)
        return true;
    }
    return false;
  }
};

}  // namespace kerf
