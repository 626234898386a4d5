// SPDX-License-Identifier: Apache-2.0
// The bodies of the walks over bonds of lanes/packed_bonds.hpp. Compiled once for each instruction
// set.
#pragma once

#include "core/select.hpp"
#include "lanes/blocks_of.hpp"
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
  using Task = BondWalkTask<D, Real>;

 public:
  [[gnu::always_inline]] static void gather(const Task& task, Index i) {
    T sum[D * D + 1] = {};
    T stretch(0);
    each(task, i, [&](const Index* neighbours, T weight) {
      Bonds bonds;
      load_transposed<End, 0, End::geometry_slots>(task.ends, neighbours, bonds.slot);
      bonds.measure(task.ends[i], task.unit);
      const T *bond = bonds.rest, *change = bonds.change;
      T longer(0), square(0);
      for (int a = 0; a < D; ++a) {
        longer += (T(2) * bond[a] + change[a]) * change[a];
        square += bond[a] * bond[a];
      }
      const auto whole = weight > T(0) && square > T(0);
      const T ratio = longer * reciprocal(select(whole, square, T(1)));
      stretch = select(whole, maximum(stretch, ratio), stretch);
      for (int a = 0; a < D; ++a)
        for (int b = 0; b < D; ++b) sum[D * a + b] += change[a] * (weight * bond[b]);
    });
    Real total[D * D + 1];
    sum_each(sum, total);
    BondGradient<D, Real>& result = task.gradient[i];
    for (int n = 0; n < D * D; ++n) result.sum.component[n] = total[n];
    result.stretch = simd::hmax(stretch);
  }

  template <bool viscous>
  [[gnu::always_inline]] static void push(const Task& task, Index i) {
    T sum[D + 1] = {};
    const End& own = task.ends[i];
    BondLaw<Real> law{};
    if constexpr (viscous) law = task.laws[task.medium[i]];
    each(task, i, [&](const Index* neighbours, T weight) {
      Bonds bonds;
      load_transposed<End, 0, End::slots>(task.ends, neighbours, bonds.slot);
      bonds.measure(own, task.unit);
      const T *bond = bonds.rest, *change = bonds.change, *slot = bonds.slot;
      const T stiffness = T(own.hourglass) + slot[End::hourglass_slot];
      for (int a = 0; a < D; ++a) {
        T force = stiffness * change[a];
        for (int b = 0; b < D; ++b) {
          const int n = End::traction_slot + D * a + b;
          force += (T(own.traction[D * a + b]) + slot[n]) * bond[b];
        }
        sum[a] += weight * force;
      }
      if constexpr (viscous) damp(own, law, weight, bonds, sum);
    });
    Real total[D + 1];
    sum_each(sum, total);
    BondPush<D, Real>& result = task.push[i];
    for (int a = 0; a < D; ++a) result.force[a] = total[a];
    result.power = total[D];
  }

 private:
  // Several bonds of one particle.
  struct Bonds {
    T slot[End::slots];    // of the other ends
    T rest[D], change[D];  // X_j - X_i, u_j - u_i

    [[gnu::always_inline]] void measure(const End& own, Real unit) {
      for (int a = 0; a < D; ++a) {
        const Place before =
            std::bit_cast<Place>(slot[End::reference_slot + a]) - Place(own.reference[a]);
        rest[a] = T(unit) * simd::static_simd_cast<T>(before);
        change[a] = (slot[End::displacement_slot + a] - T(own.displacement[a])) +
                    (slot[End::remainder_slot + a] - T(own.remainder[a]));
      }
    }
  };

  // Viscosity along the line of centres of bonds that shorten.
  [[gnu::always_inline]] static void damp(const End& own, const BondLaw<Real>& law, T weight,
                                          const Bonds& bonds, T* sum) {
    T line[D], square(0), length_squared(0), along(0);
    for (int a = 0; a < D; ++a) {
      line[a] = bonds.rest[a] + bonds.change[a];
      square += bonds.rest[a] * bonds.rest[a];
      length_squared += line[a] * line[a];
      along += (bonds.slot[End::velocity_slot + a] - T(own.velocity[a])) * line[a];
    }
    const auto nears = along < T(0) && weight > T(0) && length_squared > T(0);
    const T inverse = reciprocal_square_root(select(nears, length_squared, T(1)));
    const T speed = select(nears, -along * inverse, T(0));
    const T reference = reciprocal_square_root(select(square > T(0), square, T(1)));
    const T theta = T(law.length) * speed * reference;
    const T pressure = T(law.density) * theta * (T(law.linear) + T(law.quadratic) * theta);
    const T push = weight * square * reference * pressure;
    for (int a = 0; a < D; ++a) sum[a] -= push * inverse * line[a];
    sum[D] += T(Real(0.5)) * push * speed;
  }

  template <class Body>
  [[gnu::always_inline]] static void each(const Task& task, Index i, const Body& body) {
    const auto take = [&](const Index* neighbours, Index k, int count) {
      alignas(64) Real last[width];
      const Real* weights = task.weight + k;
      if (count < width) {  // the particle itself has none
        for (int lane = 0; lane < width; ++lane)
          last[lane] = lane < count ? weights[lane] : Real(0);
        weights = last;
      }
      body(neighbours, T(weights, simd::element_aligned));
    };
    for_each_block<width>({task.neighbour, task.begin[i], task.begin[i + 1]}, i, take);
  }
};

template <int D, class Real>
[[gnu::flatten]] void gather_bonds(const BondWalkTask<D, Real>& task, std::uint32_t first,
                                   std::uint32_t last) {
  for (std::uint32_t i = first; i < last; ++i)
    if (!task.mixed[i] && !task.loose[i]) BondsOfOne<D, Real>::gather(task, i);
}

template <int D, class Real>
[[gnu::flatten]] void push_bonds(const BondWalkTask<D, Real>& task, std::uint32_t first,
                                 std::uint32_t last) {
  for (std::uint32_t i = first; i < last; ++i) {
    if (task.mixed[i]) continue;
    if (task.laws != nullptr)
      BondsOfOne<D, Real>::template push<true>(task, i);
    else
      BondsOfOne<D, Real>::template push<false>(task, i);
  }
}

}  // namespace kerf::lanes::KERF_LANES
