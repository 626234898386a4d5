// SPDX-License-Identifier: Apache-2.0
// BondsOfParticle sums over the bonds of a particle, a register of bonds at a time, by the formulas
// of solid/bond_terms.hpp and solid/bond_weight.hpp. It is compiled once for each instruction set.
#pragma once

#include "core/select.hpp"
#include "simd/pad_with_self.hpp"
#include "simd/transposed_load.hpp"
#include "simd/transposed_sum.hpp"
#include "solid/bond_terms.hpp"
#include "solid/simd/packed_bonds.hpp"

namespace kerf::simd::KERF_SIMD {

template <int D, class Real>
class BondsOfParticle {
  using T = SimdNumbers<Real>;
  static constexpr int width = static_cast<int>(T::size());
  using End = PackedBondEnd<D, Real>;
  using Position = stdx::rebind_simd_t<typename End::Position, T>;
  using Index = std::uint32_t;
  using IndexOffset = std::int32_t;
  using Task = Bonds<D, Real>;

  // A register of bonds of the particle.
  struct BondBatch {
    Index first;              // the first of them
    const IndexOffset* ends;  // index of the other end minus that of the particle
    T slot[End::slots];       // of the other ends
    BondGeometry<D, T> bond;
    T per_length;   // 1 / R, 1/m
    T mean_length;  // h, m, of both ends, where the body has levels
  };

 public:
  BondsOfParticle(const Task& task, Index i)
      : task_(task),
        own_(task.ends + i),
        law_(task.laws[task.medium[i]]),
        begin_(task.begin[i]),
        end_(task.begin[i] + task.count[i]),
        intact_(task.has_broken_bonds[i] ? task.bond_intact + i * task.words : nullptr) {}

  template <bool shared, bool stretches>
  [[gnu::always_inline]] void sum_gradient(BondGradientSum<D, Real>& result) const {
    auto sum = Matrix<D, T>::zero();
    T stretch(0);
    for_each_batch<shared>([&](BondBatch& batch) KERF_SIMD_BODY {
      load_geometry<shared>(batch);
      add_bond_gradient(sum, batch.bond);
      if constexpr (stretches) {
        const T growth = square_growth(batch.bond.reference, batch.bond.change);
        const T ratio = growth * batch.per_length * batch.per_length;
        stretch = select(batch.bond.weight > T(0), maximum(stretch, ratio), stretch);
      }
    });
    sum_each(sum.component, result.sum.component);
    result.stretch = stretches ? stdx::hmax(stretch) : Real(0);
  }

  template <bool shared>
  [[gnu::always_inline]] void sum_misfit(const Matrix<D, Real>& gradient,
                                         BondMisfitSum<D, Real>& result) const {
    T sum(0);
    for_each_batch<shared>([&](BondBatch& batch) KERF_SIMD_BODY {
      load_geometry<shared>(batch);
      T square(0);
      for (int a = 0; a < D; ++a) {
        T gamma = -batch.bond.change[a];
        for (int b = 0; b < D; ++b) gamma += T(gradient(a, b)) * batch.bond.reference[b];
        square += gamma * gamma;
      }
      sum += batch.bond.weight * square;
    });
    result.misfit = stdx::reduce(sum);
  }

  template <bool shared>
  [[gnu::always_inline]] void sum_moments(BondMoments<D, Real>& result) const {
    result = {Matrix<D, double>::zero(), Matrix<D, double>::zero()};
    const Real hourglass = law_.hourglass;
    for_each_batch<shared>([&](BondBatch& batch) KERF_SIMD_BODY {
      load_geometry<shared>(batch);
      const T stiffness = batch.bond.weight * T(hourglass);
      const Vector<D, T> weighted = batch.bond.weight * batch.bond.reference;
      for (int lane = 0; lane < width; ++lane) {
        Vector<D, Real> of_lane, weighted_of_lane;
        for (int a = 0; a < D; ++a) {
          of_lane[a] = batch.bond.reference[a][lane];
          weighted_of_lane[a] = weighted[a][lane];
        }
        add_bond_moments(result, of_lane, weighted_of_lane, Real(stiffness[lane]), hourglass);
      }
    });
  }

  template <bool shared, bool viscous>
  [[gnu::always_inline]] void sum_force(BondForceSum<D, Real>& result) const {
    auto force = Vector<D, T>::zero();
    T power(0);
    for_each_batch<shared>([&](BondBatch& batch) KERF_SIMD_BODY {
      load_transposed<End, 0, shared ? End::reference_slot : End::slots>(own_, batch.ends,
                                                                         batch.slot);
      set_geometry<shared>(batch);
      Matrix<D, T> traction;
      for (int k = 0; k < D * D; ++k)
        traction.component[k] = T(own_->traction.component[k]) + batch.slot[End::traction_slot + k];
      add_bond_force(force, batch.bond, traction,
                     T(own_->hourglass) + batch.slot[End::hourglass_slot]);
      if constexpr (viscous) {
        Vector<D, T> velocity;
        for (int a = 0; a < D; ++a)
          velocity[a] = batch.slot[End::velocity_slot + a] - T(own_->velocity[a]);
        if constexpr (!shared)
          if (task_.has_levels) {
            add_bond_viscosity(force, power, batch.bond, velocity, batch.per_length,
                               viscosity_of(batch.mean_length));
            return;
          }
        add_bond_viscosity(force, power, batch.bond, velocity, batch.per_length, law_.viscosity);
      }
    });
    T parts[D + 1];
    for (int a = 0; a < D; ++a) parts[a] = force[a];
    parts[D] = power;
    Real total[D + 1];
    sum_each(parts, total);
    for (int a = 0; a < D; ++a) result.force[a] = total[a];
    result.power = total[D];
  }

 private:
  // Loads what the geometry of the bonds needs of the other ends, and sets it.
  template <bool shared>
  [[gnu::always_inline]] void load_geometry(BondBatch& batch) const {
    load_transposed<End, 0, 2 * D>(own_, batch.ends, batch.slot);
    if constexpr (!shared)
      load_transposed<End, End::reference_slot, End::slots>(own_, batch.ends, batch.slot);
    set_geometry<shared>(batch);
  }
  // Sets the geometry of the bonds. The padding of the last batch adds nothing: it has no weight in
  // shared lists, and in others it is the particle itself.
  template <bool shared>
  [[gnu::always_inline]] void set_geometry(BondBatch& batch) const {
    BondGeometry<D, T>& bond = batch.bond;
    if constexpr (shared) {
      const auto& known = task_.shared;
      for (int a = 0; a < D; ++a) bond.reference[a] = load(known.bond[a] + batch.first);
      bond.weight = load(known.weight + batch.first);
      batch.per_length = load(known.per_length + batch.first);
    } else {
      set_reference(batch);
    }
    if (intact_ != nullptr) bond.weight *= intact(batch.first);
    for (int a = 0; a < D; ++a)
      bond.change[a] = displacement_difference(T(own_->displacement[a]), T(own_->remainder[a]),
                                               batch.slot[End::displacement_slot + a],
                                               batch.slot[End::remainder_slot + a]);
  }
  [[gnu::always_inline]] void set_reference(BondBatch& batch) const {
    BondGeometry<D, T>& bond = batch.bond;
    T square(0);
    for (int a = 0; a < D; ++a) {
      const Position other = std::bit_cast<Position>(batch.slot[End::reference_slot + a]);
      bond.reference[a] = T(task_.unit) * stdx::static_simd_cast<T>(wrapping_difference(
                                              other, Position(own_->reference[a])));
      square += bond.reference[a] * bond.reference[a];
    }
    batch.per_length = reciprocal_square_root(select(square > T(0), square, T(1)));
    bond.weight = task_.has_levels ? weight_to_levels(batch, square * batch.per_length)
                                   : law_.scale.weight(square * batch.per_length);
    if (task_.correction != nullptr) bond.weight *= correction(batch.first);
  }
  [[gnu::always_inline]] T weight_to_levels(BondBatch& batch, const T& distance) const {
    const T length = batch.slot[End::length_slot];
    batch.mean_length = T(Real(0.5)) * (T(own_->length) + length);
    return weight_of_levels<D>(law_.scale, T(length / T(own_->length)), distance);
  }
  [[gnu::always_inline]] BondViscosityLaw<T> viscosity_of(const T& length) const {
    const auto& law = law_.viscosity;
    return {T(law.density), length, T(law.linear), T(law.quadratic)};
  }
  [[gnu::always_inline]] static T load(const Real* from) { return T(from, stdx::element_aligned); }
  [[gnu::always_inline]] T correction(Index k) const {
    return T([&](auto lane) { return k + lane < end_ ? task_.correction[k + lane] : Real(0); });
  }
  // Returns 1 for each intact bond from k on, else 0.
  [[gnu::always_inline]] T intact(Index k) const {
    const Index number = k - begin_;
    const Index bits = intact_[number / bonds_per_word] >> (number % bonds_per_word);
    return T([&](auto lane) { return static_cast<Real>((bits >> lane) & 1u); });
  }

  // Calls body(batch) for all bonds.
  template <bool shared, class Body>
  [[gnu::always_inline]] void for_each_batch(const Body& body) const {
    BondBatch batch;
    for (batch.first = begin_; batch.first < end_; batch.first += width) {
      batch.ends = task_.entry + batch.first;
      alignas(64) IndexOffset last[width];
      const auto left = static_cast<int>(end_ - batch.first);
      if (!shared && left < width) {
        pad_with_self<width>(batch.ends, left, IndexOffset(0), last);
        batch.ends = last;
      }
      body(batch);
    }
  }

  const Task& task_;
  const End* own_;
  const BondLaw<Real>& law_;
  Index begin_, end_;            // of its list
  const std::uint32_t* intact_;  // bits; null: all bonds are intact
};

// Calls act(bonds, is_shared, number) for each particle that the SIMD kernels compute; the type of
// is_shared states whether its list is shared.
template <int D, class Real, class Act>
[[gnu::always_inline]] inline void for_each_particle_in_simd(const Bonds<D, Real>& task,
                                                             std::uint32_t first,
                                                             std::uint32_t last, const Act& act) {
  for (std::uint32_t i = first; i < last; ++i) {
    if (task.several_bodies[i] || task.detached[i] || task.asleep[i]) continue;
    const BondsOfParticle<D, Real> bonds(task, i);
    if (task.begin[i] < task.shared_entries)
      act(bonds, std::true_type{}, i - first);
    else
      act(bonds, std::false_type{}, i - first);
  }
}

template <int D, class Real>
[[gnu::flatten]] void sum_gradients(const BondKernelTask<D, Real, BondGradientSum>& task,
                                    std::uint32_t first, std::uint32_t last) {
  for_each_particle_in_simd(task, first, last,
                            [&](const auto& bonds, auto shared, std::uint32_t n) {
                              if (task.breakable)
                                bonds.template sum_gradient<shared, true>(task.results[n]);
                              else
                                bonds.template sum_gradient<shared, false>(task.results[n]);
                            });
}

template <int D, class Real>
[[gnu::flatten]] void sum_forces(const BondKernelTask<D, Real, BondForceSum>& task,
                                 std::uint32_t first, std::uint32_t last) {
  for_each_particle_in_simd(task, first, last,
                            [&](const auto& bonds, auto shared, std::uint32_t n) {
                              if (task.viscous)
                                bonds.template sum_force<shared, true>(task.results[n]);
                              else
                                bonds.template sum_force<shared, false>(task.results[n]);
                            });
}

template <int D, class Real>
[[gnu::flatten]] void sum_moments(const BondKernelTask<D, Real, BondMoments>& task,
                                  std::uint32_t first, std::uint32_t last) {
  for_each_particle_in_simd(task, first, last,
                            [&](const auto& bonds, auto shared, std::uint32_t n) {
                              bonds.template sum_moments<shared>(task.results[n]);
                            });
}

template <int D, class Real>
[[gnu::flatten]] void sum_misfits(const BondKernelTask<D, Real, BondMisfitSum>& task,
                                  std::uint32_t first, std::uint32_t last) {
  for_each_particle_in_simd(
      task, first, last, [&](const auto& bonds, auto shared, std::uint32_t n) {
        bonds.template sum_misfit<shared>(task.gradient[first + n], task.results[n]);
      });
}

}  // namespace kerf::simd::KERF_SIMD
