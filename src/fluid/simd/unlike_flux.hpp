// SPDX-License-Identifier: Apache-2.0
// UnlikeFlux computes what acts between a particle and a batch of its neighbours in the pairs of
// fluid/simd/unlike_pair_kernel.hpp. It is compiled once for each instruction set.
#pragma once

#include "core/select.hpp"
#include "fluid/riemann.hpp"
#include "fluid/simd/packed_unlike.hpp"

namespace kerf::simd::KERF_SIMD {

template <int D, class Real>
struct UnlikeFlux {
  using T = SimdNumbers<Real>;
  using Mask = typename T::mask_type;
  using Packed = PackedUnlike<D, Real>;

  // The particle itself, or its mirror image.
  struct Own {
    const Packed& packed;
    bool is_fluid, is_weak, is_water, has_density, has_wall;
    Real volume, sound_speed, smoothing_length;
    Vector<D, T> gravity;
    MirrorCode code = 0;

    Own(const Packed& of, const Vector<D, Real>& g)
        : packed(of),
          is_fluid(of.rest_volume < 0),
          is_weak(of.sound_speed < 0),
          is_water(of.smoothing_length < 0),
          has_density(of.sound_speed != 0),
          has_wall(false),
          volume(std::abs(of.volume)),
          sound_speed(std::abs(of.sound_speed)),
          smoothing_length(std::abs(of.smoothing_length)) {
      for (int a = 0; a < D; ++a) {
        has_wall = has_wall || of.wall_normal[a] != 0;
        gravity[a] = T(g[a]);
      }
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
    T correction = T(1);  // s_ij

    RiemannSide<T> side(const T& speed) const {
      return {density * sound_speed, pressure, speed, sound_speed};
    }
  };
  // What acts between two: P*, U*, and P_d along d or, times a length, along the normal of a wall.
  struct Flux {
    T pressure, speed, dissipation, along_normal;
  };
  // mu of a pair of which one is water, or both: their harmonic mean.
  [[gnu::always_inline]] static T viscosity_with_image(const Own& own, const Batch& batch) {
    const T sum = batch.viscosity + T(own.packed.viscosity);
    const T product = T(Real(2)) * batch.viscosity * T(own.packed.viscosity);
    const Mask both = product > T(0);  // both are water
    return select(both, product * reciprocal(select(both, sum, T(1))),
                  select(batch.same_phase && Mask(own.is_water), T(0), sum));
  }

  // On a fluid: by another fluid, or by a solid as a wall.
  template <bool images>
  [[gnu::always_inline]] static Flux on_fluid(const Own& own, const Vector<D, T>& normal,
                                              const T& viscosity, const Batch& batch) {
    const T speed = batch.along * batch.inverse;
    const auto left = own.side(), right = batch.side(speed);
    const T smoothing =
        own.is_weak ? T(1) : select(batch.is_weak, T(1), shock_smoothing(left, right));
    auto interior = solve_riemann(left, right, smoothing);
    if constexpr (images)
      if (own.is_water)
        interior.dissipation = select(
            batch.same_phase,
            beyond_viscosity(interior.dissipation, T(batch.inverse * viscosity * magnitude(speed))),
            interior.dissipation);
    const auto at_wall =
        solve_riemann_at_wall(left, speed, T(T(own.packed.density) * dot(own.gravity, batch.d)));
    const T into = own.has_wall ? dot(normal, batch.v) : T(-speed);
    const T damping = wall_dissipation(left, into);
    const T above = maximum(T(-dot(normal, batch.d)), T(0));
    return {select(batch.is_fluid, interior.mean_pressure, at_wall.mean_pressure),
            select(batch.is_fluid, interior.speed, at_wall.speed),
            select(batch.is_fluid, interior.dissipation, own.has_wall ? T(0) : damping),
            select(batch.is_fluid, T(0), damping * above)};
  }

  // On a solid: by a fluid, whose wall it is, or by the image of its own nearly incompressible
  // body.
  template <bool images>
  [[gnu::always_inline]] static Flux on_solid(const Own& own, const Vector<D, T>& normal,
                                              const Batch& batch) {
    const T speed = batch.along * batch.inverse;
    const auto fluid = batch.side(-speed);
    const auto star =
        solve_riemann_at_wall(fluid, T(0), T(-batch.density * dot(own.gravity, batch.d)));
    const Mask has_wall = dot(normal, normal) > T(0);
    const T damping =
        wall_dissipation(fluid, select(has_wall, T(-dot(normal, batch.v)), T(-speed)));
    const T below = minimum(T(-dot(normal, batch.d)), T(0));
    Flux flux{star.mean_pressure, T(0), select(has_wall, T(0), damping), damping * below};
    if constexpr (images) {
      const auto interior = solve_riemann(own.side(), batch.side(speed));
      flux.pressure = select(batch.is_fluid, flux.pressure, interior.mean_pressure);
      flux.speed = select(batch.is_fluid, T(0), interior.speed);
      flux.dissipation = select(batch.is_fluid, flux.dissipation, interior.dissipation);
      flux.along_normal = select(batch.is_fluid, flux.along_normal, T(0));
      flux.speed = select(batch.is_near, flux.speed, T(0));
    }
    // What fills the batch may have no solution.
    flux.pressure = select(batch.is_near, flux.pressure, T(0));
    flux.dissipation = select(batch.is_near, flux.dissipation, T(0));
    flux.along_normal = select(batch.is_near, flux.along_normal, T(0));
    return flux;
  }
};

}  // namespace kerf::simd::KERF_SIMD
