// SPDX-License-Identifier: Apache-2.0
// FluidPairKernel sums the pair terms over the neighbours of a particle that are of its own fluid,
// a register of neighbours at a time, by the formulas of fluid/pair_terms.hpp, fluid/riemann.hpp
// and kernels/wendland_c2.hpp. With d = r_j - r_i, in units of the fixed-point coordinates, the
// sums of i lack until their end that unit and the factors of
//   nabla W = K w^3 d,   K = 5 alpha / h^2,   W = alpha w^4 (5 - 4 w),   w = 1 - |d| / (2 h).
// In a graded solid a neighbour has the mass m q^D and the volume V_0 q^D, where q = h_j / h_i, and
// its pair the mean length h / c with c = 2 / (1 + q), the factor s_ij of the gradient in forces
// and rates, and Z = rho c_s in the Riemann solution with its own mass: that of two particles of
// the mass m q^D, the left one with the volume V_i q^D. It is compiled once for each instruction
// set.
#pragma once

#include <limits>
#include <type_traits>

#include "core/select.hpp"
#include "fluid/pair_terms.hpp"
#include "fluid/simd/fluid_pair_constants.hpp"
#include "kernels/wendland_c2.hpp"
#include "simd/pad_with_self.hpp"
#include "simd/transposed_load.hpp"
#include "simd/transposed_sum.hpp"

namespace kerf::simd::KERF_SIMD {

// `Equation`: as in fluid/simd/fluid_pair_constants.hpp.
template <int D, class Real, class Equation, bool graded = false>
class FluidPairKernel {
  static constexpr bool shocks = !std::is_same_v<Equation, WeaklyCompressible>;
  using T = SimdNumbers<Real>;
  static constexpr int width = static_cast<int>(T::size());
  using Kernel = WendlandC2<D>;
  using Constants = FluidPairConstants<D, Real, Equation>;
  using PackedParticle = PackedFluid<D, Real>;
  using Position = typename Constants::Position;
  using Index = std::uint32_t;
  // What takes the place of the squared distance where two particles coincide, so that one over it
  // is finite: one unit, or the least number.
  static constexpr Real closest_squared =
      std::is_same_v<Real, float> ? Real(1) : std::numeric_limits<Real>::min();
  using Result = FluidSums<D, Real>;
  // A batch of neighbours; those of graded solids have two numbers more.
  static constexpr int correction_slot = PackedParticle::slots, length_slot = correction_slot + 1,
                       slots = PackedParticle::slots + (graded ? 2 : 0);
  static_assert(!(graded && shocks));

 public:
  FluidPairKernel(const FluidKernelTask<D, Real>& task, const FluidLaw<Real>& law,
                  const Equation& equation)
      : task_(task), constants_(law, equation, task.unit) {}

  // Computes the sums of particles `first` .. `last` - 1.
  [[gnu::always_inline]] void run(Index first, Index last, Result* results) {
    if constexpr (many_registers)
      run_in_one_loop(first, last, results);
    else
      run_in_two_loops(first, last, results);
  }

 private:
  // The neighbours of a particle that are still to be loaded.
  struct Row {
    const Index* list;
    Index left, self, entry;  // the last: of the first of them in the numbers of graded pairs
  };
  // Loads the next of them; the last batch is padded with the particle itself, which adds nothing.
  [[gnu::always_inline]] void load_batch(Row& row, T (&slot)[slots]) const {
    alignas(64) Index padded[width];
    const Index* indices = row.list;
    if (row.left < Index(width)) {
      pad_with_self<width>(row.list, static_cast<int>(row.left), row.self, padded);
      indices = padded;
    }
    row.list += width;
    row.left -= std::min(row.left, Index(width));
    load_transposed<PackedParticle, 0, PackedParticle::slots>(task_.fluid, indices, slot);
    if constexpr (graded) {
      slot[correction_slot].copy_from(task_.correction + row.entry, stdx::element_aligned);
      slot[length_slot].copy_from(task_.length_ratio + row.entry, stdx::element_aligned);
      row.entry += width;
    }
  }
  // What a batch of neighbours adds to the sums of vectors: d and v of the neighbours relative to
  // the particle, and their weights.
  struct Batch {
    Vector<D, T> d, v;
    T pressure, dissipation, drag, slope;
  };
  struct VectorSums {
    Vector<D, T> pressure_force = Vector<D, T>::zero(), dissipative_force = Vector<D, T>::zero(),
                 concentration_gradient = Vector<D, T>::zero();

    [[gnu::always_inline]] void add(const Batch& batch) {
      pressure_force += batch.pressure * batch.d;
      dissipative_force += batch.dissipation * batch.d;
      dissipative_force -= batch.drag * batch.v;
      concentration_gradient += batch.slope * batch.d;
    }
  };
  struct NumberSums {
    T compression_rate = T(0), kernel_sum = T(0), fastest_squared = T(0);
    NegativeSeen<T> surface_seen;
  };
  bool has_pairs(Index i) const {
    return task_.same_fluid[i] != 0 && task_.fluid[i].volume != Real(0) &&
           (task_.asleep == nullptr || task_.asleep[i] == 0);
  }
  Row row_of(Index i) const {
    return {task_.neighbour + task_.begin[i], task_.same_fluid[i], i,
            graded ? task_.graded_begin[i] : 0};
  }

  // The next batch of neighbours is loaded before the current one is computed, because most of the
  // time is latency of memory.
  [[gnu::always_inline]] void run_in_one_loop(Index first, Index last, Result* results) {
    for (Index i = first; i < last; ++i, ++results) {
      if (!has_pairs(i)) {
        *results = {};
        continue;
      }
      constants_.set(task_.fluid[i]);
      NumberSums numbers;
      VectorSums vectors;
      Row row = row_of(i);
      T slot[slots];
      load_batch(row, slot);
      while (row.left > 0) {
        T next[slots];
        load_batch(row, next);
        vectors.add(compute(slot, &constants_, numbers));
        for (int n = 0; n < slots; ++n) slot[n] = next[n];
      }
      vectors.add(compute(slot, &constants_, numbers));
      finish(i, numbers, vectors, *results);
    }
  }

  // The sums of a particle whose last batches are not yet added to the sums of vectors.
  struct UnfinishedSums {
    static constexpr int most = 24;
    NumberSums numbers;
    VectorSums vectors;
    Batch* end;
    Batch batches[most];

    [[gnu::always_inline]] void add_batches() {
      VectorSums sums = vectors;  // in registers
      for (const Batch* batch = batches; batch != end; ++batch) sums.add(*batch);
      vectors = sums;
      end = batches;
    }
  };
  // Sixteen registers do not hold the sums of vectors beside the numbers of the formulas, so those
  // sums have a loop of their own. It runs one particle later, when what it adds is there.
  [[gnu::always_inline]] void run_in_two_loops(Index first, Index last, Result* results) {
    UnfinishedSums sums[2];
    for (Index i = first; i < last; ++i) {
      begin(i, sums[i % 2]);
      if (i > first) end(i - 1, sums[(i - 1) % 2], *results++);
    }
    if (first < last) end(last - 1, sums[(last - 1) % 2], *results);
  }
  [[gnu::always_inline]] void begin(Index i, UnfinishedSums& sums) {
    if (!has_pairs(i)) return;
    constants_.set(task_.fluid[i]);
    NumberSums numbers;
    sums.vectors = {};
    sums.end = sums.batches;
    Row row = row_of(i);
    Batch* batch = sums.batches;
    do {
      if (batch == sums.batches + UnfinishedSums::most) [[unlikely]] {
        sums.end = batch;
        sums.add_batches();
        batch = sums.batches;
      }
      T slot[slots];
      load_batch(row, slot);
      compute(slot, &constants_, numbers, *batch++);
    } while (row.left > 0);
    sums.numbers = numbers;
    sums.end = batch;
  }
  [[gnu::always_inline]] void end(Index i, UnfinishedSums& sums, Result& result) const {
    if (!has_pairs(i)) {
      result = {};
      return;
    }
    sums.add_batches();
    finish(i, sums.numbers, sums.vectors, result);
  }

  // Adds a batch to the sums of numbers, and returns what it adds to those of vectors.
  [[gnu::always_inline]] static Batch compute(const T (&slot)[slots], const Constants* from,
                                              NumberSums& sums) {
    Batch batch;
    compute(slot, from, sums, batch);
    return batch;
  }
  [[gnu::always_inline]] static void compute(const T (&slot)[slots], const Constants* from,
                                             NumberSums& sums, Batch& batch) {
    asm("" : "+r"(from));  // the compiler must not keep the constants in registers
    const Constants& constants = *from;
    Vector<D, T> d, v;
    T distance_squared(0), along(0), speed_squared(0);
    for (int a = 0; a < D; ++a) {
      const Position other = std::bit_cast<Position>(slot[PackedParticle::position_slot + a]);
      d[a] = stdx::static_simd_cast<T>(wrapping_difference(other, Position(constants.position[a])));
      v[a] = slot[PackedParticle::velocity_slot + a] - T(constants.velocity[a]);
      distance_squared += d[a] * d[a];
      along += v[a] * d[a];
      speed_squared += v[a] * v[a];
      batch.d[a] = d[a];
      batch.v[a] = v[a];
    }
    if constexpr (graded) {
      compute_graded(slot, constants, {distance_squared, along}, sums, batch);
      return;
    }
    const auto is_near = distance_squared < T(constants.reach_squared) && distance_squared > T(0);
    const T signed_volume = slot[PackedParticle::volume_slot];
    sums.fastest_squared = maximum(sums.fastest_squared, select(is_near, speed_squared, T(0)));
    sums.surface_seen.add(is_near, signed_volume);

    const auto [distance, inverse] =
        root_and_inverse(maximum(distance_squared, T(closest_squared)));
    const T w = select(is_near, T(1) - distance * T(constants.per_diameter), T(0));
    const T slope = Kernel::slope_shape(w);
    sums.kernel_sum += Kernel::value_shape(w);

    const T volume = magnitude(signed_volume);
    const T speed = along * inverse;  // < 0 where the two approach
    const auto star =
        constants.pair_flux({volume, slot[PackedParticle::pressure_slot]}, speed, inverse);
    const T weight = pair_weight(volume, slope), flux_weight = weight * star.factor;
    sums.compression_rate -= pair_strain_rate(flux_weight, distance, star.speed);
    batch.pressure = flux_weight * star.pressure;
    batch.dissipation = flux_weight * star.dissipation;
    batch.drag = weight * T(constants.viscosity);
    batch.slope = slope;
  }

  struct Approach {
    T distance_squared, along;  // v . d, < 0 where the two approach
  };
  // Adds neighbours of a graded solid, which has no viscosity of water and no free surface.
  [[gnu::always_inline]] static void compute_graded(const T (&slot)[slots],
                                                    const Constants& constants,
                                                    const Approach& pair, NumberSums& sums,
                                                    Batch& batch) {
    const T q = slot[length_slot], c = T(2) * reciprocal(T(1) + q);
    const T volume_ratio = D == 3 ? q * q * q : q * q, kernel_ratio = D == 3 ? c * c * c : c * c;
    const T per_diameter = T(constants.per_diameter) * c;
    const auto is_near =
        pair.distance_squared * per_diameter * per_diameter < T(1) && pair.distance_squared > T(0);
    const auto [distance, inverse] =
        root_and_inverse(maximum(pair.distance_squared, T(closest_squared)));
    const T w = select(is_near, T(1) - distance * per_diameter, T(0));
    const T slope = Kernel::slope_shape(w) * kernel_ratio * c * c;
    sums.kernel_sum += Kernel::value_shape(w) * kernel_ratio * volume_ratio;

    const T volume = magnitude(slot[PackedParticle::volume_slot]);
    const T mass_speed = T(constants.mass_times_sound_speed) * volume_ratio;
    const auto parts = riemann_parts(
        VolumeSide<T>{T(constants.volume) * volume_ratio, T(constants.pressure)},
        VolumeSide<T>{volume, slot[PackedParticle::pressure_slot]}, T(pair.along * inverse),
        ParticlesOfOneFluid<T>{T(constants.triple_mass) * volume_ratio, mass_speed,
                               reciprocal(mass_speed)});
    const T weight = pair_weight(volume, slope) * slot[correction_slot] * reciprocal(parts.volume);
    sums.compression_rate -= pair_strain_rate(weight, distance, T(parts.speed * volume_ratio));
    batch.pressure = weight * parts.pressure_force;
    batch.dissipation = weight * parts.approach * parts.dissipative_force;
    batch.drag = T(0);
    batch.slope = slope * volume_ratio;
  }

  [[gnu::always_inline]] void finish(Index i, const NumberSums& numbers, const VectorSums& vectors,
                                     Result& result) const {
    T parts[Result::count];
    for (int a = 0; a < D; ++a) {
      parts[Result::pressure_force_at + a] = vectors.pressure_force[a];
      parts[Result::dissipative_force_at + a] = vectors.dissipative_force[a];
      parts[Result::concentration_gradient_at + a] = vectors.concentration_gradient[a];
    }
    parts[Result::compression_rate_at] = numbers.compression_rate;
    parts[Result::kernel_sum_at] = numbers.kernel_sum;
    static_assert(Result::pressure_force_at == 0 && Result::dissipative_force_at == D);
    sum_each<shocks ? 2 * D : 2 * D + 1>(parts, constants_.factor, std::abs(task_.fluid[i].volume),
                                         result.sum);
    result.fastest_squared = stdx::hmax(numbers.fastest_squared);
    result.near_free_surface = numbers.surface_seen.any() ? Real(1) : Real(0);
    result.wall = result.image_force = Vector<D, Real>::zero();
  }

  const FluidKernelTask<D, Real>& task_;
  Constants constants_;
};

}  // namespace kerf::simd::KERF_SIMD
