// SPDX-License-Identifier: Apache-2.0
// FluidPairConstants holds what is the same for all neighbours of a particle, and solves the
// Riemann problem with a register of them. It is compiled once for each instruction set.
#pragma once

#include <type_traits>

#include "core/select.hpp"
#include "fluid/riemann.hpp"
#include "fluid/simd/packed_fluid.hpp"
#include "kernels/wendland_c2.hpp"
#include "materials/equation_of_state.hpp"

namespace kerf::simd::KERF_SIMD {

#if defined(__AVX512F__)
inline constexpr bool many_registers = true;  // 32 of them, else 16
#else
inline constexpr bool many_registers = false;
#endif

// Whether any of the numbers seen is negative. Masks have registers of their own with AVX-512.
template <class T>
class NegativeSeen {
 public:
  [[gnu::always_inline]] void add(const typename T::mask_type& there, const T& number) {
    if constexpr (many_registers)
      seen_ = seen_ || (there && number < T(0));
    else
      seen_ = minimum(seen_, select(there, number, T(0)));
  }
  [[gnu::always_inline]] bool any() const {
    if constexpr (many_registers)
      return stdx::any_of(seen_);
    else
      return stdx::hmin(seen_) < 0;
  }

 private:
  std::conditional_t<many_registers, typename T::mask_type, T> seen_{0};
};

// `Equation`: of state, where the sound speed depends on the density; else WeaklyCompressible.
struct WeaklyCompressible {};

// The Riemann solution of a pair; all but the speed lack one factor.
template <class T>
struct PairFlux {
  T factor;
  T pressure, dissipation;  // Pa, P* and P_d
  T speed;                  // m/s, U*; without shocks it lacks `factor` times the volume of i
};

// It stays in memory, because registers are for sums. An instruction of AVX-512 takes one number in
// memory for all lanes, others take a whole register.
template <int D, class Real, class Equation>
struct FluidPairConstants {
  static constexpr bool shocks = !std::is_same_v<Equation, WeaklyCompressible>;
  using T = SimdNumbers<Real>;
  using PackedParticle = PackedFluid<D, Real>;
  using PositionNumber = typename PackedParticle::Position;
  using Position = stdx::rebind_simd_t<PositionNumber, T>;
  template <class Number, class Lanes>
  using InMemory = std::conditional_t<many_registers, Number, Lanes>;
  using Result = FluidSums<D, Real>;
  using Constant = InMemory<Real, T>;
  // Of the fluid.
  Constant reach_squared, per_diameter, viscosity;  // 1 / (2 h)
  Constant triple_mass, mass_times_sound_speed, per_mass_times_sound_speed;
  Real mass, per_rest_density;  // of fluids with shocks
  Equation equation;
  RestState<Real> rest;
  alignas(64) Real factor[Result::count];  // of the sums; those of forces lack the volume
  // Of the particle.
  InMemory<PositionNumber, Position> position[D];
  Constant velocity[D];
  Constant volume, pressure;
  Real own_impedance, own_sound_speed;  // of fluids with shocks

  FluidPairConstants(const FluidLaw<Real>& law, const Equation& equation_of_state, Real unit)
      : viscosity(Real(law.viscosity / unit)),
        triple_mass(Real(3) * law.mass),
        mass_times_sound_speed(Real(law.mass * law.sound_speed)),
        per_mass_times_sound_speed(Real(1) / (law.mass * law.sound_speed)),
        mass(law.mass),
        per_rest_density(law.volume / law.mass),
        equation(equation_of_state),
        rest{law.mass / law.volume, law.sound_speed} {
    const Real per_reach = unit * law.per_smoothing_length / Real(WendlandC2<D>::support);
    per_diameter = per_reach;
    reach_squared = Real(1) / (per_reach * per_reach);
    const Real gradient = law.kernel_slope * unit,
               normalised = Real(2) * law.kernel_gradient_normalisation * gradient;
    for (int a = 0; a < D; ++a) {
      factor[Result::pressure_force_at + a] = -normalised;
      factor[Result::dissipative_force_at + a] = -normalised;
      factor[Result::concentration_gradient_at + a] = law.volume * gradient;
    }
    factor[Result::compression_rate_at] = normalised;
    factor[Result::kernel_sum_at] = law.volume * law.kernel_scale;
  }
  [[gnu::always_inline]] void set(const PackedParticle& particle) {
    const Real own_volume = std::abs(particle.volume);
    volume = own_volume;
    pressure = particle.pressure;
    for (int a = 0; a < D; ++a) {
      position[a] = particle.position[a];
      velocity[a] = particle.velocity[a];
    }
    if constexpr (shocks) {
      const Real density = mass / own_volume;
      own_sound_speed = equation.sound_speed(rest, density * per_rest_density - Real(1));
      own_impedance = density * own_sound_speed;
    }
  }
  // Solves the Riemann problem with a neighbour whose velocity relative to the particle along the
  // line of centres is `speed`; `inverse` is one over its distance.
  [[gnu::always_inline]] PairFlux<T> pair_flux(const VolumeSide<T>& other, T speed,
                                               T inverse) const {
    const T viscous = T(viscosity) * inverse;
    if constexpr (!shocks) {  // riemann_parts is faster than solve_riemann (fluid/riemann.hpp)
      const auto parts =
          riemann_parts(VolumeSide<T>{T(volume), T(pressure)}, other, speed,
                        ParticlesOfOneFluid<T>{T(triple_mass), T(mass_times_sound_speed),
                                               T(per_mass_times_sound_speed)});
      const T left = beyond_viscosity(parts.dissipative_force, viscous * parts.volume);
      // Both branches are the same. With g++ 12, AVX2 keeps the first one's numbers in registers,
      // and AVX-512 those of the second.
      if constexpr (!many_registers) {
        const PairFlux<T> flux{reciprocal(parts.volume), parts.pressure_force,
                               parts.approach * left, parts.speed};
        return flux;
      }
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

}  // namespace kerf::simd::KERF_SIMD
