// SPDX-License-Identifier: Apache-2.0
// UnlikePairKernel sums the pair terms over the unlike neighbours of a particle and over the mirror
// images beside it (PairClass), a register of neighbours at a time: between two fluids, or two
// particles of one nearly incompressible solid, the Riemann solution of their line of centres,
// between a fluid and a solid that at a wall. The formulas are those of fluid/pair_terms.hpp and
// fluid/riemann.hpp, put together as in fluid/fluid_pair.hpp, which the general pair loop uses.
// With d = r_j - r_i and v = v_j - v_i, speeds along d are relative to i. The image of j acts on i
// as j does on the image of i, mirrored. It is compiled once for each instruction set.
#pragma once

#include <limits>
#include <type_traits>

#include "core/select.hpp"
#include "fluid/pair_terms.hpp"
#include "fluid/simd/unlike_flux.hpp"
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
  using Between = UnlikeFlux<D, Real>;
  using Own = typename Between::Own;
  using Batch = typename Between::Batch;
  using Flux = typename Between::Flux;
  using Position = stdx::rebind_simd_t<typename Packed::Position, T>;
  using Sums = FluidSums<D, Real>;
  static constexpr int room = (Packed::slots + 3) / 4 * 4;  // load_transposed() may fill more

 public:
  explicit UnlikePairKernel(const UnlikeKernelTask<D, Real>& task)
      : task_(task),
        closest_squared_(std::is_same_v<Real, float> ? task.unit * task.unit
                                                     : std::numeric_limits<Real>::min()) {}

  [[gnu::always_inline]] void run(std::uint32_t i, Sums& sums) const {
    if (task_.asleep != nullptr && task_.asleep[i] != 0) return;
    if (task_.unlike[i] != 0) {
      const Own own(task_.particles[i], task_.gravity);
      run_over<false>(own, task_.neighbour + task_.begin[i] + task_.same_fluid[i], task_.unlike[i],
                      sums);
    }
    if (task_.images[i] != 0) run_over_images(i, sums);
  }

 private:
  // Lists the images plane by plane; those in one plane are neighbours of one image of the
  // particle.
  void run_over_images(std::uint32_t i, Sums& sums) const {
    constexpr std::uint32_t most = 256;
    std::uint32_t neighbours[most];
    const std::uint32_t* entry = task_.neighbour + task_.end[i] - task_.images[i];
    const std::uint32_t *const first = entry, *const end = task_.neighbour + task_.end[i];
    const Real* const factors = factors_of_images(i);
    while (entry < end) {
      const MirrorCode code = task_.mirrors.code(*entry);
      const Real* const correction = factors == nullptr ? nullptr : factors + (entry - first);
      std::uint32_t count = 0;
      for (; entry < end && count < most && task_.mirrors.code(*entry) == code; ++entry)
        neighbours[count++] = task_.mirrors.particle(*entry);
      const Packed image = mirrored(task_.particles[i], code);
      Own own(image, MirrorPlanes<D>::image(code, task_.gravity));
      own.code = code;
      run_over<true>(own, neighbours, count, sums, correction);
    }
  }
  const Real* factors_of_images(std::uint32_t i) const {
    if (task_.correction == nullptr || task_.graded_begin[i] == task_.graded_begin[i + 1])
      return nullptr;
    return task_.correction + task_.graded_begin[i] +
           (task_.graded[i] != 0 ? task_.same_fluid[i] : 0);
  }
  Packed mirrored(Packed packed, MirrorCode code) const {
    for (int a = 0; a < D; ++a) {
      if (!MirrorPlanes<D>::flips(code, a)) continue;
      const auto twice = task_.twice_plane[(code & MirrorPlanes<D>::low_face(a)) != 0 ? 0 : 1][a];
      using Scalar = stdx::simd<typename Packed::Position, stdx::simd_abi::scalar>;
      packed.position[a] = wrapping_difference(Scalar(twice), Scalar(packed.position[a]))[0];
      packed.velocity[a] = -packed.velocity[a];
      packed.wall_normal[a] = -packed.wall_normal[a];
    }
    return packed;
  }

  struct PairSums {
    Vector<D, T> pressure_force = Vector<D, T>::zero(), dissipative_force = Vector<D, T>::zero(),
                 concentration_gradient = Vector<D, T>::zero(), wall = Vector<D, T>::zero();
    T compression_rate = T(0), kernel_sum = T(0), fastest_squared = T(0);
    Mask near_free_surface = Mask(false);
  };

  template <bool images>
  [[gnu::always_inline]] void run_over(const Own& own, const std::uint32_t* list,
                                       std::uint32_t count, Sums& sums,
                                       const Real* correction = nullptr) const {
    if (own.is_fluid)
      run_for<true, images>(own, list, static_cast<int>(count), sums, nullptr);
    else
      run_for<false, images>(own, list, static_cast<int>(count), sums, correction);
  }
  template <bool own_is_fluid, bool images>
  [[gnu::always_inline]] void run_for(const Own& own, const std::uint32_t* list, int left,
                                      Sums& sums, const Real* correction) const {
    PairSums pairs;
    for (; left > 0; left -= width, list += width) {
      Batch batch;
      load(own, list, left, batch);
      if (correction != nullptr) {
        batch.correction.copy_from(correction, stdx::element_aligned);
        batch.correction = select(batch.is_fluid, T(1), batch.correction);
        correction += width;
      }
      add<own_is_fluid, images>(own, batch, pairs);
    }
    finish(own, pairs, sums);
  }

  // Loads the next neighbours; the last batch is padded with the first of them, out of reach.
  [[gnu::always_inline]] void load(const Own& own, const std::uint32_t* list, int left,
                                   Batch& batch) const {
    alignas(64) std::uint32_t padded[width];
    const std::uint32_t* indices = list;
    if (left < width) {
      pad_with_self<width>(list, left, *list, padded);
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
    const T lane([](auto number) { return Real(number); });
    weigh(own, select(lane < T(Real(left)), distance_squared, T(0)), batch);
  }

  // The kernel has the mean smoothing length of one phase, else the larger one.
  [[gnu::always_inline]] void weigh(const Own& own, const T& distance_squared, Batch& batch) const {
    const T own_h(own.smoothing_length), h = batch.smoothing_length;
    const T per_h =
        reciprocal(select(batch.same_phase, T(Real(0.5)) * (own_h + h), maximum(own_h, h)));
    const T per_diameter = per_h * T(Real(1 / Kernel::support));
    batch.is_near =
        distance_squared * per_diameter * per_diameter < T(1) && distance_squared > T(0);
    const auto apart = root_and_inverse(maximum(distance_squared, T(closest_squared_)));
    batch.distance = apart.root;
    batch.inverse = apart.inverse;
    const T w = select(batch.is_near, T(1) - batch.distance * per_diameter, T(0));
    const T scale = T(Real(Kernel::sigma)) * per_h * per_h * (D == 2 ? T(1) : per_h);
    batch.value = scale * Kernel::value_shape(w);
    batch.slope = Kernel::slope_shape(w, T(T(5) * scale * per_h * per_h));
  }

  template <bool own_is_fluid, bool images>
  [[gnu::always_inline]] void add(const Own& own, const Batch& batch, PairSums& sums) const {
    Vector<D, T> normal = batch.wall_normal;  // of the fluid of the two
    if constexpr (own_is_fluid)
      for (int a = 0; a < D; ++a) normal[a] = T(own.packed.wall_normal[a]);
    const T viscosity = images ? Between::viscosity_with_image(own, batch)
                               : T(batch.viscosity + T(own.packed.viscosity));
    const Flux flux = own_is_fluid
                          ? Between::template on_fluid<images>(own, normal, viscosity, batch)
                          : Between::template on_solid<images>(own, normal, batch);
    const T weight = pair_weight(batch.volume, batch.slope) * batch.correction;
    sums.pressure_force -= pair_force(weight, flux.pressure, batch.d);
    sums.dissipative_force -= pair_force(weight, flux.dissipation, batch.d);
    sums.dissipative_force += pair_force(weight, flux.along_normal, normal);
    sums.dissipative_force += pair_drag(weight, viscosity, batch.v);
    sums.concentration_gradient += pair_weight(batch.rest_volume, batch.slope) * batch.d;
    sums.kernel_sum += batch.value * select(batch.same_phase, batch.rest_volume,
                                            minimum(batch.volume, batch.rest_volume));
    const Mask sees_fluid = batch.is_near && batch.is_fluid;
    sums.fastest_squared =
        maximum(sums.fastest_squared, select(sees_fluid, batch.speed_squared, T(0)));
    sums.near_free_surface = sums.near_free_surface || (sees_fluid && batch.in_surface);
    if constexpr (own_is_fluid || images)
      sums.compression_rate -= pair_strain_rate(weight, batch.distance, flux.speed);
    if constexpr (own_is_fluid) sums.wall -= select(batch.is_fluid, T(0), weight) * batch.d;
  }

  [[gnu::always_inline]] void finish(const Own& own, const PairSums& pairs, Sums& sums) const {
    T parts[Sums::count];
    Real factor[Sums::count], total[Sums::count];
    const Real gradient = Real(2) * task_.kernel_gradient_normalisation;
    for (int n = 0; n < Sums::count; ++n) factor[n] = Real(1);
    for (int a = 0; a < D; ++a) {
      const Real sign = MirrorPlanes<D>::flips(own.code, a) ? Real(-1) : Real(1);
      parts[Sums::pressure_force_at + a] = pairs.pressure_force[a];
      parts[Sums::dissipative_force_at + a] = pairs.dissipative_force[a];
      parts[Sums::concentration_gradient_at + a] = pairs.concentration_gradient[a];
      factor[Sums::pressure_force_at + a] = factor[Sums::dissipative_force_at + a] =
          sign * gradient * own.volume;
      factor[Sums::concentration_gradient_at + a] = sign;
      sums.wall[a] += sign * stdx::reduce(pairs.wall[a]);
    }
    parts[Sums::compression_rate_at] = pairs.compression_rate;
    parts[Sums::kernel_sum_at] = pairs.kernel_sum;
    factor[Sums::compression_rate_at] = gradient;
    factor[Sums::kernel_sum_at] = own.has_density ? Real(1) : Real(0);
    sum_each(parts, total);
    for (int n = 0; n < Sums::count; ++n) {
      total[n] *= factor[n];
      sums.sum[n] += total[n];
    }
    if (own.code != 0)
      for (int a = 0; a < D; ++a)
        sums.image_force[a] +=
            total[Sums::pressure_force_at + a] + total[Sums::dissipative_force_at + a];
    const Real fastest = stdx::hmax(pairs.fastest_squared);
    if (fastest > sums.fastest_squared) sums.fastest_squared = fastest;
    if (stdx::any_of(pairs.near_free_surface)) sums.near_free_surface = Real(1);
  }

  const UnlikeKernelTask<D, Real>& task_;
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
