// SPDX-License-Identifier: Apache-2.0
// UnlikePairKernel sums the pair terms over the unlike neighbours of a particle (PairClass), a
// register of neighbours at a time: between two fluids the Riemann solution of their line of
// centres, between a fluid and a solid that at a wall. The formulas are those of
// fluid/pair_terms.hpp and fluid/riemann.hpp, put together as in fluid/fluid_pair.hpp, which the
// general pair loop uses. With d = r_j - r_i and v = v_j - v_i, speeds along d are relative to i.
// It is compiled once for each instruction set.
#pragma once

#include <limits>
#include <type_traits>

#include "core/select.hpp"
#include "fluid/pair_terms.hpp"
#include "fluid/riemann.hpp"
#include "fluid/simd/packed_unlike.hpp"
#include "kernels/wendland_c2.hpp"
#include "simd/pad_with_self.hpp"
#include "simd/transposed_load.hpp"
#include "simd/transposed_sum.hpp"

namespace kerf::simd::KERF_SIMD {

template <int D, class Real>
class UnlikePairKernel {
  using T = SimdNumbers<Real>;
  using Mask = typename T::mask_type;
  static constexpr int width = static_cast<int>(T::size());
  using Kernel = WendlandC2<D>;
  using Packed = PackedUnlike<D, Real>;
  using Position = stdx::rebind_simd_t<typename Packed::Position, T>;
  using Sums = FluidSums<D, Real>;
  static constexpr int room = (Packed::slots + 3) / 4 * 4;  // load_transposed() may fill more

 public:
  explicit UnlikePairKernel(const UnlikeKernelTask<D, Real>& task)
      : task_(task),
        closest_squared_(std::is_same_v<Real, float> ? task.unit * task.unit
                                                     : std::numeric_limits<Real>::min()) {
    for (int a = 0; a < D; ++a) gravity_[a] = T(task.gravity[a]);
  }

  [[gnu::always_inline]] void run(std::uint32_t i, Sums& sums) const {
    if (task_.unlike[i] == 0) return;
    const Own own(task_.particles[i]);
    if (own.is_fluid)
      run_for<true>(i, own, sums);
    else
      run_for<false>(i, own, sums);
  }

 private:
  // The particle itself.
  struct Own {
    const Packed& packed;
    bool is_fluid, is_weak, is_water, has_density, has_wall;
    Real volume, sound_speed, smoothing_length;

    explicit Own(const Packed& of)
        : packed(of),
          is_fluid(of.rest_volume < 0),
          is_weak(of.sound_speed < 0),
          is_water(of.smoothing_length < 0),
          has_density(of.sound_speed != 0),
          has_wall(false),
          volume(std::abs(of.volume)),
          sound_speed(std::abs(of.sound_speed)),
          smoothing_length(std::abs(of.smoothing_length)) {
      for (int a = 0; a < D; ++a) has_wall = has_wall || of.wall_normal[a] != 0;
    }
    RiemannSide<T> side() const {
      return {T(packed.density * sound_speed), T(packed.pressure), T(0), T(sound_speed)};
    }
  };
  // A batch of neighbours.
  struct Batch {
    Vector<D, T> d, v, wall_normal;
    T along, speed_squared;  // v . d, v . v
    T pressure, volume, density, sound_speed, rest_volume, smoothing_length, viscosity;
    Mask is_fluid, is_weak, same_phase, in_surface;
    // Of the pair: r and 1 / r, W, S; the last two vanish where it is out of reach.
    Mask is_near;
    T distance, inverse, value, slope;

    RiemannSide<T> side(const T& speed) const {
      return {density * sound_speed, pressure, speed, sound_speed};
    }
  };
  // What acts between two: P*, U*, and P_d along d or, times a length, along the normal of a wall.
  struct Flux {
    T pressure, speed, dissipation, along_normal;
  };
  struct PairSums {
    Vector<D, T> pressure_force = Vector<D, T>::zero(), dissipative_force = Vector<D, T>::zero(),
                 concentration_gradient = Vector<D, T>::zero(), wall = Vector<D, T>::zero();
    T compression_rate = T(0), kernel_sum = T(0), fastest_squared = T(0);
    Mask near_free_surface = Mask(false);
  };

  template <bool own_is_fluid>
  [[gnu::always_inline]] void run_for(std::uint32_t i, const Own& own, Sums& sums) const {
    PairSums pairs;
    const std::uint32_t* list = task_.neighbour + task_.begin[i] + task_.same_fluid[i];
    int left = static_cast<int>(task_.unlike[i]);
    for (; left > 0; left -= width, list += width) {
      Batch batch;
      load(own, i, list, left, batch);
      add<own_is_fluid>(own, batch, pairs);
    }
    finish(own, pairs, sums);
  }

  // Loads the next neighbours; the last batch is padded with the particle itself, which adds
  // nothing.
  [[gnu::always_inline]] void load(const Own& own, std::uint32_t i, const std::uint32_t* list,
                                   int left, Batch& batch) const {
    alignas(64) std::uint32_t padded[width];
    const std::uint32_t* indices = list;
    if (left < width) {
      pad_with_self<width>(list, left, i, padded);
      indices = padded;
    }
    T slot[room];
    load_transposed<Packed, 0, Packed::slots>(task_.particles, indices, slot);
    T distance_squared(0);
    batch.along = batch.speed_squared = T(0);
    for (int a = 0; a < D; ++a) {
      const auto off =
          wrapping_difference(std::bit_cast<Position>(slot[a]), Position(own.packed.position[a]));
      batch.d[a] = stdx::static_simd_cast<T>(off) * T(task_.unit);
      batch.v[a] = slot[Packed::velocity_slot + a] - T(own.packed.velocity[a]);
      batch.wall_normal[a] = slot[Packed::wall_normal_slot + a];
      distance_squared += batch.d[a] * batch.d[a];
      batch.along += batch.v[a] * batch.d[a];
      batch.speed_squared += batch.v[a] * batch.v[a];
    }
    batch.pressure = slot[Packed::pressure_slot];
    batch.in_surface = slot[Packed::volume_slot] < T(0);
    batch.volume = magnitude(slot[Packed::volume_slot]);
    batch.density = slot[Packed::density_slot];
    batch.is_weak = slot[Packed::sound_speed_slot] < T(0);
    batch.sound_speed = magnitude(slot[Packed::sound_speed_slot]);
    batch.is_fluid = slot[Packed::rest_volume_slot] < T(0);
    batch.rest_volume = magnitude(slot[Packed::rest_volume_slot]);
    batch.same_phase = (slot[Packed::smoothing_length_slot] < T(0)) == Mask(own.is_water);
    batch.smoothing_length = magnitude(slot[Packed::smoothing_length_slot]);
    batch.viscosity = slot[Packed::viscosity_slot];
    weigh(own, distance_squared, batch);
  }

  // The kernel has the mean smoothing length of one phase, else the larger one.
  [[gnu::always_inline]] void weigh(const Own& own, const T& distance_squared, Batch& batch) const {
    const T own_h(own.smoothing_length), h = batch.smoothing_length;
    const T per_h =
        reciprocal(select(batch.same_phase, T(Real(0.5)) * (own_h + h), maximum(own_h, h)));
    const T per_diameter = per_h * T(Real(1 / Kernel::support));
    batch.is_near =
        distance_squared * per_diameter * per_diameter < T(1) && distance_squared > T(0);
    batch.inverse = reciprocal_square_root(maximum(distance_squared, T(closest_squared_)));
    batch.distance = distance_squared * batch.inverse;
    const T w = select(batch.is_near, T(1) - batch.distance * per_diameter, T(0));
    const T scale = T(Real(Kernel::sigma)) * per_h * per_h * (D == 2 ? T(1) : per_h);
    batch.value = scale * Kernel::value_shape(w);
    batch.slope = Kernel::slope_shape(w, T(T(5) * scale * per_h * per_h));
  }

  template <bool own_is_fluid>
  [[gnu::always_inline]] void add(const Own& own, const Batch& batch, PairSums& sums) const {
    Vector<D, T> normal = batch.wall_normal;  // of the fluid of the two
    if constexpr (own_is_fluid)
      for (int a = 0; a < D; ++a) normal[a] = T(own.packed.wall_normal[a]);
    const Flux flux =
        own_is_fluid ? flux_on_fluid(own, normal, batch) : flux_on_solid(normal, batch);
    const T weight = pair_weight(batch.volume, batch.slope);
    sums.pressure_force -= pair_force(weight, flux.pressure, batch.d);
    sums.dissipative_force -= pair_force(weight, flux.dissipation, batch.d);
    sums.dissipative_force += pair_force(weight, flux.along_normal, normal);
    sums.dissipative_force +=
        pair_drag(weight, T(batch.viscosity + T(own.packed.viscosity)), batch.v);
    sums.concentration_gradient += pair_weight(batch.rest_volume, batch.slope) * batch.d;
    sums.kernel_sum += batch.value * select(batch.same_phase, batch.rest_volume,
                                            minimum(batch.volume, batch.rest_volume));
    const Mask sees_fluid = batch.is_near && batch.is_fluid;
    sums.fastest_squared =
        maximum(sums.fastest_squared, select(sees_fluid, batch.speed_squared, T(0)));
    sums.near_free_surface = sums.near_free_surface || (sees_fluid && batch.in_surface);
    if constexpr (own_is_fluid) {
      sums.compression_rate -= pair_strain_rate(weight, batch.distance, flux.speed);
      sums.wall -= select(batch.is_fluid, T(0), weight) * batch.d;
    }
  }

  // On a fluid: by another fluid, or by a solid as a wall.
  [[gnu::always_inline]] Flux flux_on_fluid(const Own& own, const Vector<D, T>& normal,
                                            const Batch& batch) const {
    const T speed = batch.along * batch.inverse;
    const auto left = own.side(), right = batch.side(speed);
    const T smoothing =
        own.is_weak ? T(1) : select(batch.is_weak, T(1), shock_smoothing(left, right));
    const auto interior = solve_riemann(left, right, smoothing);
    const auto at_wall =
        solve_riemann_at_wall(left, speed, T(T(own.packed.density) * dot(gravity_, batch.d)));
    const T into = own.has_wall ? dot(normal, batch.v) : T(-speed);
    const T damping = wall_dissipation(left, into);
    const T above = maximum(T(-dot(normal, batch.d)), T(0));
    return {select(batch.is_fluid, interior.mean_pressure, at_wall.mean_pressure),
            select(batch.is_fluid, interior.speed, at_wall.speed),
            select(batch.is_fluid, interior.dissipation, own.has_wall ? T(0) : damping),
            select(batch.is_fluid, T(0), damping * above)};
  }

  // On a solid, which is the wall of the fluid.
  [[gnu::always_inline]] Flux flux_on_solid(const Vector<D, T>& normal, const Batch& batch) const {
    const T speed = batch.along * batch.inverse;
    const auto fluid = batch.side(-speed);
    const auto star =
        solve_riemann_at_wall(fluid, T(0), T(-batch.density * dot(gravity_, batch.d)));
    const Mask has_wall = dot(normal, normal) > T(0);
    const T damping =
        wall_dissipation(fluid, select(has_wall, T(-dot(normal, batch.v)), T(-speed)));
    const T below = minimum(T(-dot(normal, batch.d)), T(0));
    // The particle itself, which fills the batch, has no solution.
    return {select(batch.is_near, star.mean_pressure, T(0)), T(0),
            select(has_wall || !batch.is_near, T(0), damping),
            select(batch.is_near, damping * below, T(0))};
  }
  [[gnu::always_inline]] void finish(const Own& own, const PairSums& pairs, Sums& sums) const {
    T parts[Sums::count];
    Real factor[Sums::count], total[Sums::count];
    const Real gradient = Real(2) * task_.kernel_gradient_normalisation;
    for (int n = 0; n < Sums::count; ++n) factor[n] = Real(1);
    for (int a = 0; a < D; ++a) {
      parts[Sums::pressure_force_at + a] = pairs.pressure_force[a];
      parts[Sums::dissipative_force_at + a] = pairs.dissipative_force[a];
      parts[Sums::concentration_gradient_at + a] = pairs.concentration_gradient[a];
      factor[Sums::pressure_force_at + a] = factor[Sums::dissipative_force_at + a] =
          gradient * own.volume;
    }
    parts[Sums::compression_rate_at] = pairs.compression_rate;
    parts[Sums::kernel_sum_at] = pairs.kernel_sum;
    factor[Sums::compression_rate_at] = gradient;
    factor[Sums::kernel_sum_at] = own.has_density ? Real(1) : Real(0);
    sum_each(parts, total);
    for (int n = 0; n < Sums::count; ++n) sums.sum[n] += factor[n] * total[n];
    const Real fastest = stdx::hmax(pairs.fastest_squared);
    if (fastest > sums.fastest_squared) sums.fastest_squared = fastest;
    if (stdx::any_of(pairs.near_free_surface)) sums.near_free_surface = Real(1);
    for (int a = 0; a < D; ++a) sums.wall[a] += stdx::reduce(pairs.wall[a]);
  }

  const UnlikeKernelTask<D, Real>& task_;
  Vector<D, T> gravity_;
  // What takes the place of the squared distance where two coincide, so that one over it is finite.
  Real closest_squared_;
};

template <int D, class Real>
[[gnu::flatten]] void add_unlike_sums(const UnlikeKernelTask<D, Real>& task, std::uint32_t first,
                                      std::uint32_t last) {
  const UnlikePairKernel<D, Real> kernel(task);
  for (std::uint32_t i = first; i < last; ++i) kernel.run(i, task.results[i - first]);
}

}  // namespace kerf::simd::KERF_SIMD
