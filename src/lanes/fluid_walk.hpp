// SPDX-License-Identifier: Apache-2.0
// The body of the walk of lanes/packed_fluid.hpp: the formulas of rates/fluid_force.hpp,
// fluid_continuity.hpp, water_viscosity.hpp, filling.hpp and crowding.hpp for two particles of one
// fluid. With d = r_i - r_j, in units of places, and q = |d| / h, the sums of i lack until their
// end that unit and the factors of
//   nabla W = - K s d,  s = w^3,  w = 1 - q/2,  K = 5 alpha / h^2,   W = alpha s w (5 - 4 w).
// Compiled once for each instruction set.
#pragma once

#include "core/select.hpp"
#include "kernels/wendland_c2.hpp"
#include "lanes/blocks_of.hpp"
#include "lanes/packed_fluid.hpp"
#include "lanes/transposed_load.hpp"
#include "lanes/transposed_sum.hpp"
#include "materials/shock_hugoniot.hpp"
#include "rates/riemann.hpp"

namespace kerf::lanes::KERF_LANES {

template <int D, class Real, bool shocks>
class WalkOfOne {
  using T = Numbers<Real>;
  static constexpr int width = static_cast<int>(T::size());
  using Record = PackedFluid<D, Real>;
  using Place = simd::rebind_simd_t<typename Record::Place, T>;
  using Index = std::uint32_t;

 public:
  [[gnu::always_inline]] static void run(const FluidWalkTask<D, Real>& task, Index i,
                                         FluidSums<D, Real>& result) {
    const FluidLaw<Real>& law = task.laws[task.source[i]];
    const Fixed fixed(task.fluid[i], law, task.unit);
    Sums sums;
    // The particle itself adds nothing.
    for_each_block<width>(
        {task.neighbour, task.begin[i], task.begin[i] + task.alike[i]}, i,
        [&](const Index* neighbours, Index, int) { add(task.fluid, neighbours, &fixed, sums); });
    finish(task, law, fixed.volume, sums, result);
  }

 private:
  struct Sums {
    T pressing[D] = {}, damping[D] = {}, crowd[D] = {};
    T opening = T(0), filling = T(0), fastest_squared = T(0);
    typename T::mask_type sees_surface{false};
  };
  // What is the same for all neighbours, as plain numbers in memory: registers are for sums.
  struct Fixed {
    typename Record::Place place[D];
    Real velocity[D];
    Real volume, pressure;
    Real reach_squared, per_diameter, viscosity;  // 1 / (2 h)
    Real mass, sound_speed, mass_times_sound_speed, per_mass_times_sound_speed;
    Real rest_volume, slope;              // of fluids with shocks
    Real own_impedance, own_sound_speed;  // likewise

    [[gnu::always_inline]] Fixed(const Record& record, const FluidLaw<Real>& law, Real unit)
        : volume(std::abs(record.volume)),
          pressure(record.pressure),
          per_diameter(unit * law.per_smoothing_length / Real(WendlandC2<D>::support)),
          viscosity(law.viscosity / unit),
          mass(law.mass),
          sound_speed(law.sound_speed),
          mass_times_sound_speed(law.mass * law.sound_speed),
          per_mass_times_sound_speed(Real(1) / mass_times_sound_speed),
          rest_volume(law.volume),
          slope(law.hugoniot_slope) {
      for (int a = 0; a < D; ++a) {
        place[a] = record.place[a];
        velocity[a] = record.velocity[a];
      }
      reach_squared = Real(1) / (per_diameter * per_diameter);
      if constexpr (shocks) {
        const Real inverse = Real(1) / volume;
        own_sound_speed =
            ShockHugoniot::sound_speed(sound_speed, slope, rest_volume * inverse - Real(1));
        own_impedance = mass * inverse * own_sound_speed;
      }
    }
    // With a neighbour that moves at `speed` beside the particle.
    [[gnu::always_inline]] RiemannStar<T> exchange(T other_volume, T other_pressure,
                                                   T speed) const {
      if constexpr (!shocks)
        return solve_riemann(VolumeSide<T>{T(volume), T(pressure)},
                             VolumeSide<T>{other_volume, other_pressure}, speed,
                             ParticlesOfOneFluid<T>{T(mass), T(mass_times_sound_speed),
                                                    T(per_mass_times_sound_speed)});
      const RiemannSide<T> own{T(own_impedance), T(pressure), T(0), T(own_sound_speed)};
      const T inverse = reciprocal(other_volume);
      const T sound =
          ShockHugoniot::sound_speed(T(sound_speed), T(slope), T(rest_volume) * inverse - T(1));
      const RiemannSide<T> other{T(mass) * inverse * sound, other_pressure, speed, sound};
      return solve_riemann(own, other, shock_smoothing(own, other));
    }
  };

  [[gnu::always_inline]] static void add(const Record* records, const Index* neighbours,
                                         const Fixed* from, Sums& sums) {
    asm("" : "+r"(from));  // it may be anything: not to be kept in registers
    const Fixed& fixed = *from;
    T slot[Record::slots];
    load_transposed<Record, 0, Record::slots>(records, neighbours, slot);
    T d[D], v[D];
    T distance_squared(0), along(0), speed_squared(0);
    for (int a = 0; a < D; ++a) {
      const Place there = std::bit_cast<Place>(slot[Record::place_slot + a]);
      d[a] = simd::static_simd_cast<T>(Place(fixed.place[a]) - there);
      v[a] = T(fixed.velocity[a]) - slot[Record::velocity_slot + a];
      distance_squared += d[a] * d[a];
      along += v[a] * d[a];
      speed_squared += v[a] * v[a];
    }
    const auto seen = distance_squared < T(fixed.reach_squared) && distance_squared > T(0);
    const T inverse = reciprocal_square_root(select(seen, distance_squared, T(1)));
    const T distance = distance_squared * inverse;
    const T rest = select(seen, T(1) - distance * T(fixed.per_diameter), T(0));
    const T s = rest * rest * rest;
    const T volume = magnitude(slot[Record::volume_slot]);

    const T speed = along * inverse;  // < 0 where the two approach
    const auto star = fixed.exchange(volume, slot[Record::pressure_slot], speed);
    const T viscosity(fixed.viscosity);
    // What beyond_viscosity does, of dissipation that is never negative.
    const T viscous = viscosity * inverse * maximum(-speed, T(0));
    const T damped = maximum(star.dissipation - viscous, T(0));

    const T weight = volume * s;
    const T pressing = weight * star.mean_pressure, damping = weight * damped;
    const T drag = weight * viscosity;
    for (int a = 0; a < D; ++a) {
      sums.pressing[a] += pressing * d[a];
      sums.damping[a] += damping * d[a];
      sums.damping[a] -= drag * v[a];
      sums.crowd[a] += s * d[a];
    }
    sums.opening -= weight * distance * star.speed;
    sums.filling += s * rest * (T(5) - T(4) * rest);
    sums.fastest_squared =
        select(seen, maximum(sums.fastest_squared, speed_squared), sums.fastest_squared);
    const auto surface = seen && slot[Record::volume_slot] < T(0);
    sums.sees_surface = sums.sees_surface || surface;
  }

  [[gnu::always_inline]] static void finish(const FluidWalkTask<D, Real>& task,
                                            const FluidLaw<Real>& law, Real volume,
                                            const Sums& sums, FluidSums<D, Real>& result) {
    using Result = FluidSums<D, Real>;
    const Real slope = law.kernel_slope * task.unit, push = Real(2) * law.steepening * slope;
    T parts[Result::count];
    Real factor[Result::count];
    for (int a = 0; a < D; ++a) {
      parts[Result::pressing_at + a] = sums.pressing[a];
      parts[Result::damping_at + a] = sums.damping[a];
      parts[Result::crowd_at + a] = sums.crowd[a];
      factor[Result::pressing_at + a] = push * volume;
      factor[Result::damping_at + a] = push * volume;
      factor[Result::crowd_at + a] = -law.volume * slope;
    }
    parts[Result::strain_rate_at] = sums.opening;
    parts[Result::filling_at] = sums.filling;
    factor[Result::strain_rate_at] = push;
    factor[Result::filling_at] = law.volume * law.kernel_scale;
    sum_each(parts, factor, result.sum);
    result.fastest_squared = simd::hmax(sums.fastest_squared);
    result.sees_surface = simd::any_of(sums.sees_surface) ? Real(1) : Real(0);
  }
};

template <int D, class Real>
[[gnu::flatten]] void walk_fluid(const FluidWalkTask<D, Real>& task, std::uint32_t first,
                                 std::uint32_t last) {
  for (std::uint32_t i = first; i < last; ++i) {
    FluidSums<D, Real>& result = task.sums[i - first];
    if (task.alike[i] == 0 || task.fluid[i].volume == Real(0)) {
      result = {};
    } else if (task.laws[task.source[i]].has_shocks != 0) {
      WalkOfOne<D, Real, true>::run(task, i, result);
    } else {
      WalkOfOne<D, Real, false>::run(task, i, result);
    }
  }
}

}  // namespace kerf::lanes::KERF_LANES
