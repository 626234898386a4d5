// SPDX-License-Identifier: Apache-2.0
// The body of the walk of lanes/packed_fluid.hpp: the formulas of rates/fluid_force.hpp,
// fluid_continuity.hpp, water_viscosity.hpp, filling.hpp and crowding.hpp for two particles of one
// fluid. With d = r_i - r_j, in units of places, and q = |d| / h, the sums of i lack until their
// end that unit and the factors of
//   nabla W = - K s d,  s = (1 - q/2)^3,  K = 5 alpha / h^2,   W = alpha s (1 - q/2) (2 q + 1).
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
  [[gnu::always_inline]] static void run(const FluidWalkTask<D, Real>& task, Index i) {
    const FluidLaw<Real>& law = task.laws[task.source[i]];
    const Fixed fixed(task.fluid[i], law, task.unit);
    const T sound(law.sound_speed);  // what hangs on it alone is worked out once
    Sums sums;
    const Index begin = task.begin[i];
    // The particle itself adds nothing.
    for_each_block<width>({task.neighbour, begin, begin + task.alike[i]}, i,
                          [&](const Index* neighbours, Index, int) {
                            add(task.fluid, neighbours, sound, &fixed, sums);
                          });
    finish(task, law, std::abs(task.fluid[i].volume), sums, task.sums[i]);
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
    RiemannSide<Real> own;
    Real reach_squared, per_smoothing_length, viscosity;
    Real impedance_times_volume, rest_volume, slope;

    [[gnu::always_inline]] Fixed(const Record& record, const FluidLaw<Real>& law, Real unit)
        : per_smoothing_length(unit * law.per_smoothing_length),
          viscosity(law.viscosity / unit),
          impedance_times_volume(law.mass * (shocks ? Real(1) : law.sound_speed)),
          rest_volume(law.volume),
          slope(law.hugoniot_slope) {
      for (int a = 0; a < D; ++a) {
        place[a] = record.place[a];
        velocity[a] = record.velocity[a];
      }
      const Real reach = Real(WendlandC2<D>::support) * law.smoothing_length / unit;
      reach_squared = reach * reach;
      const Real inverse = Real(1) / std::abs(record.volume);
      own = {impedance_times_volume * inverse, record.pressure, Real(0), law.sound_speed};
      if constexpr (shocks) {
        own.sound_speed =
            ShockHugoniot::sound_speed(law.sound_speed, slope, rest_volume * inverse - Real(1));
        own.impedance *= own.sound_speed;
      }
    }
    // `sound`: at rest.
    [[gnu::always_inline]] RiemannSide<T> own_side(T sound) const {
      return {T(own.impedance), T(own.pressure), T(0), shocks ? T(own.sound_speed) : sound};
    }
    [[gnu::always_inline]] RiemannSide<T> other_side(T sound, T other_pressure, T speed,
                                                     T volume) const {
      const T inverse = reciprocal(volume);
      const T per_sound = T(impedance_times_volume) * inverse;
      if constexpr (!shocks) return {per_sound, other_pressure, speed, sound};
      const T now = ShockHugoniot::sound_speed(sound, T(slope), T(rest_volume) * inverse - T(1));
      return {per_sound * now, other_pressure, speed, now};
    }
  };

  [[gnu::always_inline]] static void add(const Record* records, const Index* neighbours, T sound,
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
    const T q = distance * T(fixed.per_smoothing_length);
    const T rest = select(seen, T(1) - T(Real(0.5)) * q, T(0));
    const T s = rest * rest * rest;
    const T volume = magnitude(slot[Record::volume_slot]);

    const T approach = -along * inverse;
    auto star = exchange(fixed.own_side(sound),
                         fixed.other_side(sound, slot[Record::pressure_slot], -approach, volume));
    const T viscosity(fixed.viscosity);
    star.dissipation = beyond_viscosity(star.dissipation, viscosity * inverse * approach);

    const T weight = volume * s;
    const T pressing = weight * star.mean_pressure, damping = weight * star.dissipation;
    const T drag = weight * viscosity;
    for (int a = 0; a < D; ++a) {
      sums.pressing[a] += pressing * d[a];
      sums.damping[a] += damping * d[a] - drag * v[a];
      sums.crowd[a] += s * d[a];
    }
    sums.opening -= weight * distance * star.speed;
    sums.filling += s * rest * (T(2) * q + T(1));
    sums.fastest_squared =
        select(seen, maximum(sums.fastest_squared, speed_squared), sums.fastest_squared);
    const auto surface = seen && slot[Record::volume_slot] < T(0);
    sums.sees_surface = sums.sees_surface || surface;
  }
  [[gnu::always_inline]] static RiemannStar<T> exchange(const RiemannSide<T>& own,
                                                        const RiemannSide<T>& other) {
    if constexpr (shocks) return solve_riemann(own, other, shock_smoothing(own, other));
    return solve_riemann(own, other);
  }

  [[gnu::always_inline]] static void finish(const FluidWalkTask<D, Real>& task,
                                            const FluidLaw<Real>& law, Real volume,
                                            const Sums& sums, FluidSums<D, Real>& result) {
    constexpr int count = 3 * D + 2;
    T parts[count];
    for (int a = 0; a < D; ++a) {
      parts[a] = sums.pressing[a];
      parts[D + a] = sums.damping[a];
      parts[2 * D + a] = sums.crowd[a];
    }
    parts[3 * D] = sums.opening;
    parts[3 * D + 1] = sums.filling;
    Real total[count];
    sum_each(parts, total);
    const Real slope = law.kernel_slope * task.unit, push = Real(2) * law.steepening * slope;
    for (int a = 0; a < D; ++a) {
      result.pressing[a] = push * volume * total[a];
      result.damping[a] = push * volume * total[D + a];
      result.crowd[a] = -law.volume * slope * total[2 * D + a];
    }
    result.strain_rate = push * total[3 * D];
    result.filling = law.volume * law.kernel_scale * total[3 * D + 1];
    result.fastest_squared = simd::hmax(sums.fastest_squared);
    result.sees_surface = simd::any_of(sums.sees_surface) ? Real(1) : Real(0);
  }
};

template <int D, class Real>
[[gnu::flatten]] void walk_fluid(const FluidWalkTask<D, Real>& task, std::uint32_t first,
                                 std::uint32_t last) {
  for (std::uint32_t i = first; i < last; ++i) {
    if (task.alike[i] == 0 || task.fluid[i].volume == Real(0)) {
      task.sums[i] = {};
    } else if (task.laws[task.source[i]].has_shocks != 0) {
      WalkOfOne<D, Real, true>::run(task, i);
    } else {
      WalkOfOne<D, Real, false>::run(task, i);
    }
  }
}

}  // namespace kerf::lanes::KERF_LANES
