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
#include "lanes/fill_up.hpp"
#include "lanes/packed_fluid.hpp"
#include "lanes/transposed_load.hpp"
#include "lanes/transposed_sum.hpp"
#include "materials/shock_hugoniot.hpp"
#include "rates/riemann.hpp"

namespace kerf::lanes::KERF_LANES {

template <int D, class Real, bool shocks>
class WalkOfLaw {
  using T = Numbers<Real>;
  static constexpr int width = static_cast<int>(T::size());
  using Record = PackedFluid<D, Real>;
  using Place = simd::rebind_simd_t<typename Record::Place, T>;
  using Index = std::uint32_t;
  using Result = FluidSums<D, Real>;

 public:
  WalkOfLaw(const FluidWalkTask<D, Real>& task, const FluidLaw<Real>& law)
      : task_(task), fixed_(law, task.unit) {}

  // While a block of neighbours is worked out the next one is on its way already: what takes most
  // of the time is not work but waiting for numbers.
  [[gnu::always_inline]] void run(Index i, Result& result) {
    fixed_.set(task_.fluid[i]);
    Sums sums;
    Row row{task_.neighbour + task_.begin[i], task_.alike[i], i};
    T slot[Record::slots];
    load_block(row, slot);
    while (row.left > 0) {
      T next[Record::slots];
      load_block(row, next);
      add(slot, &fixed_, sums);
      for (int n = 0; n < Record::slots; ++n) slot[n] = next[n];
    }
    add(slot, &fixed_, sums);
    finish(sums, result);
  }

 private:
  // What is left of the neighbours of a particle.
  struct Row {
    const Index* list;
    Index left, self;
  };
  // The next of them; the last block is filled up with the particle itself, which adds nothing.
  [[gnu::always_inline]] void load_block(Row& row, T (&slot)[Record::slots]) const {
    alignas(64) Index filled[width];
    const Index* indices = row.list;
    if (row.left < Index(width)) {
      fill_up<width>(row.list, static_cast<int>(row.left), row.self, filled);
      indices = filled;
    }
    row.list += width;
    row.left -= std::min(row.left, Index(width));
    load_transposed<Record, 0, Record::slots>(task_.fluid, indices, slot);
  }
  struct Sums {
    T pressing[D] = {}, damping[D] = {}, crowd[D] = {};
    T opening = T(0), filling = T(0), fastest_squared = T(0);
    typename T::mask_type sees_surface{false};
  };
  // What the two do to one another, all but the speed with one factor.
  struct Exchange {
    T factor;
    T pressing, damping;  // Pa: pressures, without and with loss
    T speed;              // m/s, U*; without shocks that factor times the volume of the particle
  };
  // What is the same for all neighbours, as plain numbers in memory: registers are for sums.
  struct Fixed {
    // Of the law.
    Real reach_squared, per_diameter, viscosity;  // 1 / (2 h)
    Real mass, triple_mass, sound_speed, mass_times_sound_speed, per_mass_times_sound_speed;
    Real per_rest_density, slope;            // of fluids with shocks
    alignas(64) Real factor[Result::count];  // of the sums; those of forces lack the volume
    // Of the particle.
    typename Record::Place place[D];
    Real velocity[D];
    Real volume, pressure;
    Real own_impedance, own_sound_speed;  // of fluids with shocks

    Fixed(const FluidLaw<Real>& law, Real unit)
        : per_diameter(unit * law.per_smoothing_length / Real(WendlandC2<D>::support)),
          viscosity(law.viscosity / unit),
          mass(law.mass),
          triple_mass(Real(3) * law.mass),
          sound_speed(law.sound_speed),
          mass_times_sound_speed(law.mass * law.sound_speed),
          per_mass_times_sound_speed(Real(1) / mass_times_sound_speed),
          per_rest_density(law.volume / law.mass),
          slope(law.hugoniot_slope) {
      reach_squared = Real(1) / (per_diameter * per_diameter);
      const Real bare = law.kernel_slope * unit, push = Real(2) * law.steepening * bare;
      for (int a = 0; a < D; ++a) {
        factor[Result::pressing_at + a] = push;
        factor[Result::damping_at + a] = push;
        factor[Result::crowd_at + a] = -law.volume * bare;
      }
      factor[Result::strain_rate_at] = push;
      factor[Result::filling_at] = law.volume * law.kernel_scale;
    }
    [[gnu::always_inline]] void set(const Record& record) {
      volume = std::abs(record.volume);
      pressure = record.pressure;
      for (int a = 0; a < D; ++a) {
        place[a] = record.place[a];
        velocity[a] = record.velocity[a];
      }
      if constexpr (shocks) {
        const Real density = mass / volume;
        own_sound_speed =
            ShockHugoniot::sound_speed(sound_speed, slope, density * per_rest_density - Real(1));
        own_impedance = density * own_sound_speed;
      }
    }
    // With a neighbour that moves at `speed` beside the particle; `inverse`: one over its distance.
    [[gnu::always_inline]] Exchange exchange(const VolumeSide<T>& other, T speed, T inverse) const {
      // What beyond_viscosity does, of dissipation that is never negative.
      const T viscous = T(viscosity) * inverse;
      if constexpr (!shocks) {
        const auto parts =
            riemann_parts(VolumeSide<T>{T(volume), T(pressure)}, other, speed,
                          ParticlesOfOneFluid<T>{T(triple_mass), T(mass_times_sound_speed),
                                                 T(per_mass_times_sound_speed)});
        const T damping = maximum(parts.damping - viscous * parts.volume, T(0));
        return {reciprocal(parts.volume), parts.pressing, parts.approach * damping, parts.speed};
      }
      const RiemannSide<T> own{T(own_impedance), T(pressure), T(0), T(own_sound_speed)};
      const T density = T(mass) * reciprocal(other.volume);
      const T sound = ShockHugoniot::sound_speed(T(sound_speed), T(slope),
                                                 density * T(per_rest_density) - T(1));
      const RiemannSide<T> side{density * sound, other.pressure, speed, sound};
      const auto star = solve_riemann(own, side, shock_smoothing(own, side));
      const T damping = maximum(star.dissipation - viscous * maximum(-speed, T(0)), T(0));
      return {T(1), star.mean_pressure, damping, star.speed};
    }
  };

  [[gnu::always_inline]] static void add(const T (&slot)[Record::slots], const Fixed* from,
                                         Sums& sums) {
    asm("" : "+r"(from));  // it may be anything: not to be kept in registers
    const Fixed& fixed = *from;
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
    const auto star = fixed.exchange({volume, slot[Record::pressure_slot]}, speed, inverse);
    const T weight = volume * s, shared = weight * star.factor;
    const T pressing = shared * star.pressing, damping = shared * star.damping;
    const T drag = weight * T(fixed.viscosity);
    for (int a = 0; a < D; ++a) {
      sums.pressing[a] += pressing * d[a];
      sums.damping[a] += damping * d[a];
      sums.damping[a] -= drag * v[a];
      sums.crowd[a] += s * d[a];
    }
    sums.opening -= shared * distance * star.speed;
    sums.filling += s * rest * (T(5) - T(4) * rest);
    sums.fastest_squared =
        select(seen, maximum(sums.fastest_squared, speed_squared), sums.fastest_squared);
    const auto surface = seen && slot[Record::volume_slot] < T(0);
    sums.sees_surface = sums.sees_surface || surface;
  }

  [[gnu::always_inline]] void finish(const Sums& sums, Result& result) const {
    T parts[Result::count];
    for (int a = 0; a < D; ++a) {
      parts[Result::pressing_at + a] = sums.pressing[a];
      parts[Result::damping_at + a] = sums.damping[a];
      parts[Result::crowd_at + a] = sums.crowd[a];
    }
    parts[Result::strain_rate_at] = sums.opening;
    parts[Result::filling_at] = sums.filling;
    static_assert(Result::pressing_at == 0 && Result::damping_at == D);
    sum_each<shocks ? 2 * D : 2 * D + 1>(parts, fixed_.factor, fixed_.volume, result.sum);
    result.fastest_squared = simd::hmax(sums.fastest_squared);
    result.sees_surface = simd::any_of(sums.sees_surface) ? Real(1) : Real(0);
  }

  const FluidWalkTask<D, Real>& task_;
  Fixed fixed_;
};

// The particles `first` .. `last` - 1, which are of one law.
template <int D, class Real, bool shocks>
void walk_alike(const FluidWalkTask<D, Real>& task, std::uint32_t first, std::uint32_t last,
                FluidSums<D, Real>* sums) {
  WalkOfLaw<D, Real, shocks> walk(task, task.laws[task.source[first]]);
  for (std::uint32_t i = first; i < last; ++i, ++sums) {
    if (task.alike[i] == 0 || task.fluid[i].volume == Real(0))
      *sums = {};
    else
      walk.run(i, *sums);
  }
}

template <int D, class Real>
[[gnu::flatten]] void walk_fluid(const FluidWalkTask<D, Real>& task, std::uint32_t first,
                                 std::uint32_t last) {
  FluidSums<D, Real>* sums = task.results;
  while (first < last) {
    std::uint32_t end = first + 1;
    while (end < last && task.source[end] == task.source[first]) ++end;
    if (task.laws[task.source[first]].has_shocks != 0)
      walk_alike<D, Real, true>(task, first, end, sums);
    else
      walk_alike<D, Real, false>(task, first, end, sums);
    sums += end - first;
    first = end;
  }
}

}  // namespace kerf::lanes::KERF_LANES
