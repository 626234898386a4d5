// SPDX-License-Identifier: Apache-2.0
// FilteredPairLoop visits the neighbours of a particle once and sums the chosen pair terms over
// them. A term is a struct with a nested Sum and
//   void add(const View&, const Pair&, Sum&) const    for each pair,
//   void finish(const View&, Index i, const Sum&) const   once per particle,
//   void start(const View&, Index i, Sum&) const   where a part of the sum is known beforehand,
//   static constexpr bool only_adds = true   where `finish` does nothing for a sum over no pairs,
//   KnownSums known   where that part comes from SIMD kernels (fluid/known_sums.hpp),
//   static Vector force(const Sum&)   where it adds a force whose part from mirror images is to be
//     recorded: the force so far, N, without that of rigid bodies, which is recorded apart,
//   Vector known_image_force(Index) const   the part of images in the known sums, N;
// each particle sums over its own neighbours in the order of the list.
#pragma once

#include "neighbours/neighbour_list.hpp"
#include "pairs/pair.hpp"

namespace kerf {

template <class... Terms>
struct TermSums : Terms::Sum... {};

struct EveryPair {
  template <int D, class P>
  KERF_FUNCTION bool operator()(const ParticleView<D, P>&, Index, Index, MirrorCode) const {
    return true;
  }
};

// `Scheme` as in neighbours/pair_range.hpp. `Filter` chooses pairs, e.g. those across a plane.
template <int D, class P, class Scheme, class Filter, class... Terms>
struct FilteredPairLoop : Terms... {
  using Real = typename P::Real;
  using Sums = TermSums<Terms...>;
  using Kernel = typename Scheme::template Kernel<D>;
  static constexpr bool includes_rigid = (Terms::includes_rigid || ...);

  ParticleView<D, P> particles;
  NeighbourView list;
  Filter filter;

  // Whether a term adds forces between particles that move.
  template <class Term>
  static constexpr bool adds_force = requires(const typename Term::Sum& sum) {
    Term::force(sum);
  };
  static constexpr bool adds_forces = (adds_force<Terms> || ...);

  FilteredPairLoop(const ParticleView<D, P>& view, const NeighbourView& neighbours,
                   const Filter& chosen, const Terms&... terms)
      : Terms(terms)..., particles(view), list(neighbours), filter(chosen) {}

  // Takes the known sums of a block of particles, which the loop visits next.
  template <class Known>
  KERF_FUNCTION void take(const Known& sums) {
    (take_for<Terms>(sums), ...);
  }

  KERF_FLATTEN KERF_FUNCTION void operator()(Index i) const {
    if (particles.is_asleep(i)) return;
    if (list.first(i) == list.last(i))
      finish_alone(i);
    else
      sum_pairs(i);
  }

 private:
  // A function of its own, term by term: the sums are numbers in registers, most of them 0.
  KERF_FUNCTION void finish_alone(Index i) const {
    (finish_alone<Terms>(i), ...);
    if constexpr (adds_forces)
      if (particles.mirrors.faces != 0)
        particles.mirror_acceleration[i] =
            (Real(1) / particles.medium(i).mass) * known_image_force(i);
  }

  KERF_FLATTEN KERF_NOINLINE KERF_FUNCTION void sum_pairs(Index i) const {
    Sums sums{start<Terms>(i)...};
    const auto& medium_i = particles.medium(i);
    auto by_particles = Vector<D, Real>::zero();
    bool is_mirrored = false;
    for (Index k = list.first(i); k < list.last(i); ++k) {
      Pair<D, P> pair;
      pair.i = i;
      pair.j = particles.mirrors.particle(list.neighbour[k]);
      pair.mirror = particles.mirrors.code(list.neighbour[k]);
      if (pair.mirror != 0 && !is_mirrored) {  // images come after all particles
        is_mirrored = true;
        by_particles = force(sums);
      }
      if (!filter(particles, i, pair.j, pair.mirror)) continue;
      pair.medium_i = &medium_i;
      pair.medium_j = &particles.medium(pair.j);
      pair.separation = Vector<D, Real>::from(particles.mirrors.separation(
          pair.mirror, particles.position[i], particles.position[pair.j]));
      pair.distance = norm(pair.separation);
      if (Scheme::rigid_repels && pair.medium_j->phase == Phase::rigid) {
        if constexpr (includes_rigid) add_rigid(pair, sums);
        continue;
      }
      pair.smoothing_length = Scheme::template smoothing_length<Real>(medium_i, *pair.medium_j);
      if (pair.distance >= Scheme::template cutoff<Kernel>(particles, pair)) continue;
      add_pair(pair, sums);
    }
    (finish<Terms>(i, sums), ...);
    if constexpr (adds_forces)
      if (particles.mirrors.faces != 0)
        particles.mirror_acceleration[i] =
            (Real(1) / medium_i.mass) * (is_mirrored
                                             ? known_image_force(i) + (force(sums) - by_particles)
                                             : known_image_force(i));
  }

  template <class Term, class Known>
  KERF_FUNCTION void take_for(const Known& sums) {
    if constexpr (requires(Term & term) { term.known = sums; })
      static_cast<Term&>(*this).known = sums;
  }

  template <class Term>
  KERF_FUNCTION typename Term::Sum start(Index i) const {
    typename Term::Sum sum{};
    if constexpr (requires(const Term& term) { term.start(particles, i, sum); })
      static_cast<const Term&>(*this).start(particles, i, sum);
    return sum;
  }

  template <class Term>
  KERF_FUNCTION void finish_alone(Index i) const {
    if constexpr (requires { Term::only_adds; }) return;
    static_cast<const Term&>(*this).finish(particles, i, start<Term>(i));
  }
  template <class Term>
  KERF_FUNCTION void finish(Index i, const Sums& sums) const {
    static_cast<const Term&>(*this).finish(particles, i,
                                           static_cast<const typename Term::Sum&>(sums));
  }

  KERF_FUNCTION static Vector<D, Real> force(const Sums& sums) {
    auto sum = Vector<D, Real>::zero();
    (add_force<Terms>(sums, sum), ...);
    return sum;
  }
  // The part of the known sums that is due to mirror images, N.
  KERF_FUNCTION Vector<D, Real> known_image_force(Index i) const {
    auto sum = Vector<D, Real>::zero();
    (add_known_image_force<Terms>(i, sum), ...);
    return sum;
  }
  template <class Term>
  KERF_FUNCTION void add_known_image_force(Index i, Vector<D, Real>& sum) const {
    if constexpr (requires(const Term& term) { term.known_image_force(i); })
      sum += static_cast<const Term&>(*this).known_image_force(i);
  }
  template <class Term>
  KERF_FUNCTION static void add_force(const typename Term::Sum& terms, Vector<D, Real>& sum) {
    if constexpr (adds_force<Term>) sum += Term::force(terms);
  }

  KERF_FUNCTION void add_pair(Pair<D, P>& pair, Sums& sums) const {
    pair.slope_per_distance = Kernel::slope_per_distance(pair.distance, pair.smoothing_length);
    pair.gradient = -pair.slope_per_distance * pair.separation;
    pair.velocity = particles.velocity[pair.i] - pair.of_j(particles.velocity[pair.j]);
    pair.same_phase = pair.medium_i->phase == pair.medium_j->phase;
    pair.cohesive = is_cohesive(particles, pair.i, pair.j);
    (static_cast<const Terms&>(*this).add(particles, pair, static_cast<typename Terms::Sum&>(sums)),
     ...);
  }

  KERF_FUNCTION void add_rigid(const Pair<D, P>& pair, Sums& sums) const {
    (add_rigid_to<Terms>(pair, sums), ...);
  }
  template <class Term>
  KERF_FUNCTION void add_rigid_to(const Pair<D, P>& pair, Sums& sums) const {
    if constexpr (Term::includes_rigid)
      static_cast<const Term&>(*this).add_rigid(particles, pair,
                                                static_cast<typename Term::Sum&>(sums));
  }
};

template <int D, class P, class Scheme, class... Terms>
using PairLoop = FilteredPairLoop<D, P, Scheme, EveryPair, Terms...>;

}  // namespace kerf
