// SPDX-License-Identifier: Apache-2.0
// FluidPairKernel sums the pair terms over the neighbours of a particle that are of its own fluid,
// a register of neighbours at a time, by the formulas of fluid/pair_terms.hpp, fluid/riemann.hpp
// and kernels/wendland_c2.hpp. With d = r_i - r_j, in units of the fixed-point coordinates, the
// sums of i lack until their end that unit and the factors of
//   nabla W = - K w^3 d,   K = 5 alpha / h^2,   W = alpha w^4 (5 - 4 w),   w = 1 - |d| / (2 h).
// In a graded solid a neighbour has the mass m q^D and the volume V_0 q^D, where q = h_j / h_i, and
// its pair the mean length h / c with c = 2 / (1 + q), the factor s_ij of the gradient in forces
// and rates, and Z = rho c_s in the Riemann solution with its own mass: that of two particles of
// the mass m q^D, the left one with the volume V_i q^D. It is compiled once for each instruction
// set.
#pragma once

#include <type_traits>

#include "core/select.hpp"
#include "fluid/pair_terms.hpp"
#include "fluid/riemann.hpp"
#include "fluid/simd/packed_fluid.hpp"
#include "kernels/wendland_c2.hpp"
#include "materials/equation_of_state.hpp"
#include "simd/pad_with_self.hpp"
#include "simd/transposed_load.hpp"
#include "simd/transposed_sum.hpp"

namespace kerf::simd::KERF_SIMD {

// `Equation`: of state, where the sound speed depends on the density; else WeaklyCompressible.
struct WeaklyCompressible {};

template <int D, class Real, class Equation, bool graded = false>
class FluidPairKernel {
  static constexpr bool shocks = !std::is_same_v<Equation, WeaklyCompressible>;
  using T = SimdNumbers<Real>;
  static constexpr int width = static_cast<int>(T::size());
  using Kernel = WendlandC2<D>;
  using PackedParticle = PackedFluid<D, Real>;
  using Position = stdx::rebind_simd_t<typename PackedParticle::Position, T>;
  using Index = std::uint32_t;
  using Result = FluidSums<D, Real>;
  // A batch of neighbours; those of graded solids have two numbers more.
  static constexpr int correction_slot = PackedParticle::slots, length_slot = correction_slot + 1,
                       slots = PackedParticle::slots + (graded ? 2 : 0);
  static_assert(!(graded && shocks));

 public:
  FluidPairKernel(const FluidKernelTask<D, Real>& task, const FluidLaw<Real>& law,
                  const Equation& equation)
      : task_(task), constants_(law, equation, task.unit) {}

  // Sums over the neighbours of particle i. The next batch of neighbours is loaded before the
  // current one is computed, because most of the time is latency of memory.
  [[gnu::always_inline]] void run(Index i, Result& result) {
    constants_.set(task_.fluid[i]);
    Sums sums;
    Row row{task_.neighbour + task_.begin[i], task_.same_fluid[i], i, task_.begin[i]};
    T slot[slots];
    load_batch(row, slot);
    while (row.left > 0) {
      T next[slots];
      load_batch(row, next);
      add(slot, &constants_, sums);
      for (int n = 0; n < slots; ++n) slot[n] = next[n];
    }
    add(slot, &constants_, sums);
    finish(sums, result);
  }

 private:
  // The neighbours of a particle that are still to be loaded.
  struct Row {
    const Index* list;
    Index left, self;
    Index entry;  // of the first of them in the whole list
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
  struct Sums {
    Vector<D, T> pressure_force = Vector<D, T>::zero(), dissipative_force = Vector<D, T>::zero(),
                 concentration_gradient = Vector<D, T>::zero();
    T compression_rate = T(0), kernel_sum = T(0), fastest_squared = T(0);
    typename T::mask_type near_free_surface{false};
  };
  // The Riemann solution of a pair; all but the speed lack one factor.
  struct PairFlux {
    T factor;
    T pressure, dissipation;  // Pa, P* and P_d
    T speed;                  // m/s, U*; without shocks it lacks `factor` times the volume of i
  };
  // What is the same for all neighbours, as plain numbers in memory: registers are for sums.
  struct ParticleConstants {
    // Of the fluid.
    Real reach_squared, per_diameter, viscosity;  // 1 / (2 h)
    Real mass, triple_mass, sound_speed, mass_times_sound_speed, per_mass_times_sound_speed;
    Real per_rest_density;  // of fluids with shocks
    Equation equation;
    RestState<Real> rest;
    alignas(64) Real factor[Result::count];  // of the sums; those of forces lack the volume
    // Of the particle.
    typename PackedParticle::Position position[D];
    Real velocity[D];
    Real volume, pressure;
    Real own_impedance, own_sound_speed;  // of fluids with shocks

    ParticleConstants(const FluidLaw<Real>& law, const Equation& equation_of_state, Real unit)
        : per_diameter(unit * law.per_smoothing_length / Real(Kernel::support)),
          viscosity(law.viscosity / unit),
          mass(law.mass),
          triple_mass(Real(3) * law.mass),
          sound_speed(law.sound_speed),
          mass_times_sound_speed(law.mass * law.sound_speed),
          per_mass_times_sound_speed(Real(1) / mass_times_sound_speed),
          per_rest_density(law.volume / law.mass),
          equation(equation_of_state),
          rest{law.mass / law.volume, law.sound_speed} {
      reach_squared = Real(1) / (per_diameter * per_diameter);
      const Real gradient = law.kernel_slope * unit,
                 normalised = Real(2) * law.kernel_gradient_normalisation * gradient;
      for (int a = 0; a < D; ++a) {
        factor[Result::pressure_force_at + a] = normalised;
        factor[Result::dissipative_force_at + a] = normalised;
        factor[Result::concentration_gradient_at + a] = -law.volume * gradient;
      }
      factor[Result::compression_rate_at] = normalised;
      factor[Result::kernel_sum_at] = law.volume * law.kernel_scale;
    }
    [[gnu::always_inline]] void set(const PackedParticle& particle) {
      volume = std::abs(particle.volume);
      pressure = particle.pressure;
      for (int a = 0; a < D; ++a) {
        position[a] = particle.position[a];
        velocity[a] = particle.velocity[a];
      }
      if constexpr (shocks) {
        const Real density = mass / volume;
        own_sound_speed = equation.sound_speed(rest, density * per_rest_density - Real(1));
        own_impedance = density * own_sound_speed;
      }
    }
    // Solves the Riemann problem with a neighbour whose velocity relative to the particle along the
    // line of centres is `speed`; `inverse` is one over its distance.
    [[gnu::always_inline]] PairFlux pair_flux(const VolumeSide<T>& other, T speed,
                                              T inverse) const {
      const T viscous = T(viscosity) * inverse;
      if constexpr (!shocks) {  // riemann_parts is faster than solve_riemann (fluid/riemann.hpp)
        const auto parts =
            riemann_parts(VolumeSide<T>{T(volume), T(pressure)}, other, speed,
                          ParticlesOfOneFluid<T>{T(triple_mass), T(mass_times_sound_speed),
                                                 T(per_mass_times_sound_speed)});
        const T left = beyond_viscosity(parts.dissipative_force, viscous * parts.volume);
        return {reciprocal(parts.volume), parts.pressure_force, parts.approach * left, parts.speed};
      } else {
        const RiemannSide<T> own{T(own_impedance), T(pressure), T(0), T(own_sound_speed)};
        const T density = T(mass) * reciprocal(other.volume);
        const T other_sound_speed =
            equation.sound_speed(rest, T(density * T(per_rest_density) - T(1)));
        const RiemannSide<T> side{density * other_sound_speed, other.pressure, speed,
                                  other_sound_speed};
        const auto star = solve_riemann(own, side, shock_smoothing(own, side));
        const T left = beyond_viscosity(star.dissipation, viscous * maximum(-speed, T(0)));
        return {T(1), star.mean_pressure, left, star.speed};
      }
    }
  };

  [[gnu::always_inline]] static void add(const T (&slot)[slots], const ParticleConstants* from,
                                         Sums& sums) {
    asm("" : "+r"(from));  // the compiler must not keep the constants in registers
    const ParticleConstants& constants = *from;
    Vector<D, T> d, v;
    T distance_squared(0), along(0), speed_squared(0);
    for (int a = 0; a < D; ++a) {
      const Position other = std::bit_cast<Position>(slot[PackedParticle::position_slot + a]);
      d[a] = stdx::static_simd_cast<T>(wrapping_difference(Position(constants.position[a]), other));
      v[a] = T(constants.velocity[a]) - slot[PackedParticle::velocity_slot + a];
      distance_squared += d[a] * d[a];
      along += v[a] * d[a];
      speed_squared += v[a] * v[a];
    }
    if constexpr (graded) {
      add_graded(slot, constants, {d, distance_squared, along}, sums);
      return;
    }
    const auto is_near = distance_squared < T(constants.reach_squared) && distance_squared > T(0);
    const T inverse = reciprocal_square_root(select(is_near, distance_squared, T(1)));
    const T distance = distance_squared * inverse;
    const T w = select(is_near, T(1) - distance * T(constants.per_diameter), T(0));
    const T slope = Kernel::slope_shape(w);
    const T volume = magnitude(slot[PackedParticle::volume_slot]);

    const T speed = along * inverse;  // < 0 where the two approach
    const auto star =
        constants.pair_flux({volume, slot[PackedParticle::pressure_slot]}, speed, inverse);
    const T weight = pair_weight(volume, slope), flux_weight = weight * star.factor;
    sums.pressure_force += pair_force(flux_weight, star.pressure, d);
    sums.dissipative_force += pair_force(flux_weight, star.dissipation, d);
    sums.dissipative_force -= pair_drag(weight, T(constants.viscosity), v);
    sums.concentration_gradient += slope * d;
    sums.compression_rate -= pair_strain_rate(flux_weight, distance, star.speed);
    sums.kernel_sum += Kernel::value_shape(w);
    sums.fastest_squared =
        select(is_near, maximum(sums.fastest_squared, speed_squared), sums.fastest_squared);
    const auto at_surface = is_near && slot[PackedParticle::volume_slot] < T(0);
    sums.near_free_surface = sums.near_free_surface || at_surface;
  }

  struct Approach {
    Vector<D, T> d;
    T distance_squared, along;  // v . d, < 0 where the two approach
  };
  // Adds neighbours of a graded solid, which has no viscosity of water and no free surface.
  [[gnu::always_inline]] static void add_graded(const T (&slot)[slots],
                                                const ParticleConstants& constants,
                                                const Approach& pair, Sums& sums) {
    const T q = slot[length_slot], c = T(2) * reciprocal(T(1) + q);
    const T volume_ratio = D == 3 ? q * q * q : q * q, kernel_ratio = D == 3 ? c * c * c : c * c;
    const T per_diameter = T(constants.per_diameter) * c;
    const auto is_near =
        pair.distance_squared * per_diameter * per_diameter < T(1) && pair.distance_squared > T(0);
    const T inverse = reciprocal_square_root(select(is_near, pair.distance_squared, T(1)));
    const T distance = pair.distance_squared * inverse;
    const T w = select(is_near, T(1) - distance * per_diameter, T(0));
    const T slope = Kernel::slope_shape(w) * kernel_ratio * c * c;
    const T volume = magnitude(slot[PackedParticle::volume_slot]);

    const T mass_speed = T(constants.mass_times_sound_speed) * volume_ratio;
    const auto parts = riemann_parts(
        VolumeSide<T>{T(constants.volume) * volume_ratio, T(constants.pressure)},
        VolumeSide<T>{volume, slot[PackedParticle::pressure_slot]}, T(pair.along * inverse),
        ParticlesOfOneFluid<T>{T(constants.triple_mass) * volume_ratio, mass_speed,
                               reciprocal(mass_speed)});
    const T weight = pair_weight(volume, slope) * slot[correction_slot] * reciprocal(parts.volume);
    sums.pressure_force += pair_force(weight, parts.pressure_force, pair.d);
    sums.dissipative_force +=
        pair_force(weight, T(parts.approach * parts.dissipative_force), pair.d);
    sums.concentration_gradient += (slope * volume_ratio) * pair.d;
    sums.compression_rate -= pair_strain_rate(weight, distance, T(parts.speed * volume_ratio));
    sums.kernel_sum += Kernel::value_shape(w) * kernel_ratio * volume_ratio;
  }

  [[gnu::always_inline]] void finish(const Sums& sums, Result& result) const {
    T parts[Result::count];
    for (int a = 0; a < D; ++a) {
      parts[Result::pressure_force_at + a] = sums.pressure_force[a];
      parts[Result::dissipative_force_at + a] = sums.dissipative_force[a];
      parts[Result::concentration_gradient_at + a] = sums.concentration_gradient[a];
    }
    parts[Result::compression_rate_at] = sums.compression_rate;
    parts[Result::kernel_sum_at] = sums.kernel_sum;
    static_assert(Result::pressure_force_at == 0 && Result::dissipative_force_at == D);
    sum_each<shocks ? 2 * D : 2 * D + 1>(parts, constants_.factor, constants_.volume, result.sum);
    result.fastest_squared = stdx::hmax(sums.fastest_squared);
    result.near_free_surface = stdx::any_of(sums.near_free_surface) ? Real(1) : Real(0);
  }

  const FluidKernelTask<D, Real>& task_;
  ParticleConstants constants_;
};

}  // namespace kerf::simd::KERF_SIMD
