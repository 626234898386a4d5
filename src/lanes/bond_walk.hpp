// SPDX-License-Identifier: Apache-2.0
// The bodies of the walks over bonds of lanes/packed_bonds.hpp. Compiled once for each instruction
// set.
#pragma once

#include "core/select.hpp"
#include "lanes/fill_up.hpp"
#include "lanes/packed_bonds.hpp"
#include "lanes/transposed_load.hpp"
#include "lanes/transposed_sum.hpp"

namespace kerf::lanes::KERF_LANES {

template <int D, class Real>
class BondsOfOne {
  using T = Numbers<Real>;
  static constexpr int width = static_cast<int>(T::size());
  using End = PackedBondEnd<D, Real>;
  using Place = simd::rebind_simd_t<typename End::Place, T>;
  using Index = std::uint32_t;
  using Apart = std::int32_t;
  using Task = Bonds<D, Real>;

  // Several bonds of the particle.
  struct Some {
    Index first;         // the first of them
    const Apart* ends;   // how far their ends are from the particle
    T slot[End::slots];  // of those ends
    T bond[D];           // X_j - X_i, m
    T weight;            // w_ij, 0 where it is broken
    T per_length;        // 1 / |X_j - X_i|
  };

 public:
  BondsOfOne(const Task& task, Index i)
      : task_(task),
        own_(task.ends + i),
        law_(task.laws[task.medium[i]]),
        begin_(task.begin[i]),
        end_(task.begin[i] + task.count[i]),
        whole_(task.torn[i] ? task.whole + i * task.words : nullptr) {}

  template <bool shared, bool stretches>
  [[gnu::always_inline]] void gather(BondGradient<D, Real>& result) const {
    T sum[D * D] = {};
    T stretch(0);
    each<shared>([&](Some& some) KERF_LANE_BODY {
      load_transposed<End, 0, 2 * D>(own_, some.ends, some.slot);
      if constexpr (!shared)
        load_transposed<End, End::reference_slot, End::slots>(own_, some.ends, some.slot);
      measure<shared>(some);
      T change[D];
      for (int a = 0; a < D; ++a) change[a] = change_of(some, a);
      for (int b = 0; b < D; ++b) {
        const T weighted = some.weight * some.bond[b];
        for (int a = 0; a < D; ++a) sum[D * a + b] += change[a] * weighted;
      }
      if constexpr (stretches) {
        T longer(0);
        for (int a = 0; a < D; ++a) longer += (T(Real(2)) * some.bond[a] + change[a]) * change[a];
        const T ratio = longer * some.per_length * some.per_length;
        stretch = select(some.weight > T(0), maximum(stretch, ratio), stretch);
      }
    });
    sum_each(sum, result.sum.component);
    result.stretch = stretches ? simd::hmax(stretch) : Real(0);
  }

  // sum_j w [(A_i + A_j) R + (mu_i + mu_j) (u_j - u_i)].
  template <bool shared, bool viscous>
  [[gnu::always_inline]] void push(BondPush<D, Real>& result) const {
    T sum[D + 1] = {};  // force, power
    each<shared>([&](Some& some) KERF_LANE_BODY {
      load_transposed<End, 0, shared ? End::reference_slot : End::slots>(own_, some.ends,
                                                                         some.slot);
      measure<shared>(some);
      T change[D], weighted[D];
      for (int a = 0; a < D; ++a) {
        change[a] = change_of(some, a);
        weighted[a] = some.weight * some.bond[a];
      }
      const T stiffness = some.weight * (T(own_->hourglass) + some.slot[End::hourglass_slot]);
      for (int a = 0; a < D; ++a) {
        sum[a] += stiffness * change[a];
        for (int b = 0; b < D; ++b)
          sum[a] +=
              (T(own_->traction(a, b)) + some.slot[End::traction_slot + D * a + b]) * weighted[b];
      }
      if constexpr (viscous) damp(some, change, sum);
    });
    Real total[D + 1];
    sum_each(sum, total);
    for (int a = 0; a < D; ++a) result.force[a] = total[a];
    result.power = total[D];
  }

 private:
  // u_j - u_i, m.
  [[gnu::always_inline]] T change_of(const Some& some, int a) const {
    return (some.slot[End::displacement_slot + a] - T(own_->displacement[a])) +
           (some.slot[End::remainder_slot + a] - T(own_->remainder[a]));
  }

  // What the bonds are in the reference configuration. What the last block is filled up with adds
  // nothing: no weight in shared lists, in others the particle itself.
  template <bool shared>
  [[gnu::always_inline]] void measure(Some& some) const {
    if constexpr (shared) {
      const auto& known = task_.shared;
      for (int a = 0; a < D; ++a) some.bond[a] = load(known.bond[a] + some.first);
      some.weight = load(known.weight + some.first);
      some.per_length = load(known.per_length + some.first);
    } else {
      measure_by_places(some);
    }
    if (whole_ != nullptr) some.weight *= whole(some.first);
  }
  [[gnu::always_inline]] void measure_by_places(Some& some) const {
    T square(0);
    for (int a = 0; a < D; ++a) {
      const Place there = std::bit_cast<Place>(some.slot[End::reference_slot + a]);
      some.bond[a] = T(task_.unit) * simd::static_simd_cast<T>(there - Place(own_->reference[a]));
      square += some.bond[a] * some.bond[a];
    }
    some.per_length = reciprocal_square_root(select(square > T(0), square, T(1)));
    some.weight = law_.scale.weight(square * some.per_length);
    if (task_.fit != nullptr) some.weight *= fit(some.first);
  }
  [[gnu::always_inline]] static T load(const Real* from) { return T(from, simd::element_aligned); }
  [[gnu::always_inline]] T fit(Index k) const {
    return T([&](auto lane) { return k + lane < end_ ? task_.fit[k + lane] : Real(0); });
  }
  // 1 for each unbroken bond at k and after it, else 0.
  [[gnu::always_inline]] T whole(Index k) const {
    const Index number = k - begin_;
    const Index bits = whole_[number / bonds_per_word] >> (number % bonds_per_word);
    return T([&](auto lane) { return static_cast<Real>((bits >> lane) & 1u); });
  }

  // Viscosity along the line of centres of bonds that shorten (solid/bond_force.hpp). R drops out
  // of w R q but for the quadratic part.
  [[gnu::always_inline]] void damp(const Some& some, const T (&change)[D], T* sum) const {
    T line[D], length_squared(0), along(0);
    for (int a = 0; a < D; ++a) {
      line[a] = some.bond[a] + change[a];
      length_squared += line[a] * line[a];
      along += (some.slot[End::velocity_slot + a] - T(own_->velocity[a])) * line[a];
    }
    const auto nears = along < T(0) && length_squared > T(0);
    const T inverse = reciprocal_square_root(select(nears, length_squared, T(1)));
    const T speed = select(nears, -along * inverse, T(0));
    const T theta = T(law_.length) * speed * some.per_length;
    const T push = some.weight * T(law_.density * law_.length) * speed *
                   (T(law_.linear) + T(law_.quadratic) * theta);
    for (int a = 0; a < D; ++a) sum[a] -= push * inverse * line[a];
    sum[D] += T(Real(0.5)) * push * speed;
  }

  // body(some) with as many bonds at a time as a register holds.
  template <bool shared, class Body>
  [[gnu::always_inline]] void each(const Body& body) const {
    Some some;
    for (some.first = begin_; some.first < end_; some.first += width) {
      some.ends = task_.entry + some.first;
      alignas(64) Apart last[width];
      const auto left = static_cast<int>(end_ - some.first);
      if (!shared && left < width) {
        fill_up<width>(some.ends, left, Apart(0), last);
        some.ends = last;
      }
      body(some);
    }
  }

  const Task& task_;
  const End* own_;
  const BondLaw<Real>& law_;
  Index begin_, end_;           // of its list
  const std::uint32_t* whole_;  // null: all are
};

// act(bonds, is_shared, number) for each, whether its list is shared by its type.
template <int D, class Real, class Act>
[[gnu::always_inline]] inline void for_each_in_lanes(const Bonds<D, Real>& task,
                                                     std::uint32_t first, std::uint32_t last,
                                                     const Act& act) {
  for (std::uint32_t i = first; i < last; ++i) {
    if (task.mixed[i] || task.loose[i]) continue;
    const BondsOfOne<D, Real> bonds(task, i);
    if (task.begin[i] < task.shared_entries)
      act(bonds, std::true_type{}, i - first);
    else
      act(bonds, std::false_type{}, i - first);
  }
}

template <int D, class Real>
[[gnu::flatten]] void gather_bonds(const BondWalkTask<D, Real, BondGradient>& task,
                                   std::uint32_t first, std::uint32_t last) {
  for_each_in_lanes(task, first, last, [&](const auto& bonds, auto shared, std::uint32_t n) {
    if (task.breakable)
      bonds.template gather<shared, true>(task.results[n]);
    else
      bonds.template gather<shared, false>(task.results[n]);
  });
}

template <int D, class Real>
[[gnu::flatten]] void push_bonds(const BondWalkTask<D, Real, BondPush>& task, std::uint32_t first,
                                 std::uint32_t last) {
  for_each_in_lanes(task, first, last, [&](const auto& bonds, auto shared, std::uint32_t n) {
    if (task.viscous)
      bonds.template push<shared, true>(task.results[n]);
    else
      bonds.template push<shared, false>(task.results[n]);
  });
}

}  // namespace kerf::lanes::KERF_LANES
