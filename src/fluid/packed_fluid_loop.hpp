// SPDX-License-Identifier: Apache-2.0
// PackedFluidLoop sums the pair terms over the neighbours of a particle that are of its own fluid,
// from packed records, with one thread per particle: on a GPU it takes the place of the SIMD kernel
// (fluid/simd/fluid_pair_kernel.hpp), with the same formulas, of fluid/pair_terms.hpp,
// fluid/riemann.hpp and kernels/wendland_c2.hpp. With d = r_j - r_i, in units of the fixed-point
// coordinates, the sums of i lack until their end that unit and the factors of
//   nabla W = K w^3 d,   K = 5 alpha / h^2,   W = alpha w^4 (5 - 4 w),   w = 1 - |d| / (2 h).
#pragma once

#include <limits>

#include "core/select.hpp"
#include "fluid/pair_terms.hpp"
#include "fluid/riemann.hpp"
#include "fluid/simd/packed_fluid.hpp"
#include "kernels/wendland_c2.hpp"
#include "parallel/load_record.hpp"
#include "parallel/loops.hpp"

namespace kerf {

// The Riemann solution of a particle and its neighbours, in weakly compressible fluids, whose sound
// speed is the same everywhere. It lacks the `scale` of the particle in forces and rates.
template <class Real>
struct WeaklyCompressiblePairs {
  static constexpr bool shocks = false;
  VolumeSide<Real> own;
  ParticlesOfOneFluid<Real> fluid;
  Real viscosity;

  template <class Packed>
  KERF_FUNCTION WeaklyCompressiblePairs(const FluidLaw<Real>& law, const Packed& particle,
                                        Real unit)
      : own{std::abs(particle.volume), particle.pressure},
        fluid{Real(3) * law.mass, law.mass * law.sound_speed,
              reciprocal(law.mass * law.sound_speed)},
        viscosity(law.viscosity / unit) {}
  KERF_FUNCTION Real scale() const { return own.volume; }
  // `speed`: of the neighbour away from the particle, m/s; `inverse`: one over their distance.
  KERF_FUNCTION RiemannStar<Real> operator()(const VolumeSide<Real>& other, Real speed,
                                             Real inverse) const {
    const auto parts = riemann_parts(own, other, speed, fluid);
    const Real left = beyond_viscosity(parts.dissipative_force, viscosity * inverse * parts.volume);
    const Real factor = reciprocal(parts.volume);
    return {factor * parts.pressure_force, factor * parts.approach * left, factor * parts.speed};
  }
};

// The same in fluids with shocks, whose sound speed depends on the density.
template <class Real>
struct ShockPairs {
  static constexpr bool shocks = true;
  const FluidLaw<Real>& law;
  RiemannSide<Real> own;
  Real viscosity;

  template <class Packed>
  KERF_FUNCTION ShockPairs(const FluidLaw<Real>& of, const Packed& particle, Real unit)
      : law(of),
        own(side({std::abs(particle.volume), particle.pressure}, Real(0))),
        viscosity(of.viscosity / unit) {}
  KERF_FUNCTION Real scale() const { return Real(1); }
  KERF_FUNCTION RiemannStar<Real> operator()(const VolumeSide<Real>& other, Real speed,
                                             Real inverse) const {
    const auto right = side(other, speed);
    auto star = solve_riemann(own, right, shock_smoothing(own, right));
    star.dissipation =
        beyond_viscosity(star.dissipation, viscosity * inverse * maximum(-speed, Real(0)));
    return star;
  }

 private:
  KERF_FUNCTION RiemannSide<Real> side(const VolumeSide<Real>& of, Real speed) const {
    const RestState<Real> rest{law.mass / law.volume, law.sound_speed};
    const Real compression = law.volume / of.volume - Real(1);
    const Real sound_speed = EquationOfStateSet<Real>::visit(
        law.equations, law.equation_of_state,
        [&](const auto& equation) { return equation.sound_speed(rest, compression); });
    return {law.mass / of.volume * sound_speed, of.pressure, speed, sound_speed};
  }
};

// `Pairs` is one of both: particles of the other kind of fluids are left out. Each result is
// written once, by one of the two loops.
template <int D, class Real, class Pairs>
struct PackedFluidLoop {
  using Packed = PackedFluid<D, Real>;
  using Result = FluidSums<D, Real>;
  using Kernel = WendlandC2<D>;
  static constexpr Index batch = 4;  // entries of the list, which are one load

  FluidKernelTask<D, Real> task;

  KERF_FUNCTION void operator()(Index i) const {
    const FluidLaw<Real>& law = task.laws[task.source[i]];
    if (is_weakly_compressible(law.equations, law.equation_of_state) == Pairs::shocks) return;
    const Packed own = load_record(task.fluid + i);
    const bool asleep = task.asleep != nullptr && task.asleep[i] != 0;
    const bool has_pairs = task.same_fluid[i] != 0 && own.volume != Real(0) && !asleep;
    store_record(has_pairs ? sums_of(i, own, law) : Result{}, task.results + i);
  }

 private:
  struct Sums {
    Vector<D, Real> pressure_force = Vector<D, Real>::zero(),
                    dissipative_force = Vector<D, Real>::zero(),
                    concentration_gradient = Vector<D, Real>::zero();
    Real compression_rate = Real(0), kernel_sum = Real(0), fastest_squared = Real(0);
    bool near_free_surface = false;
  };
  // Of the particle and its fluid.
  struct Centre {
    const Packed& own;
    Pairs pairs;
    Real per_diameter, reach_squared;  // 1 / (2 h)

    KERF_FUNCTION Centre(const Packed& particle, const FluidLaw<Real>& law, Real unit)
        : own(particle),
          pairs(law, particle, unit),
          per_diameter(unit * law.per_smoothing_length / Real(Kernel::support)),
          reach_squared(Real(1) / (per_diameter * per_diameter)) {}
  };

  KERF_FUNCTION Result sums_of(Index i, const Packed& own, const FluidLaw<Real>& law) const {
    const Centre centre(own, law, task.unit);
    Sums sums;
    const Index count = task.same_fluid[i];
    const std::uint32_t* list = task.neighbour + task.begin[i];
    for (Index first = 0; first < count; first += batch) {
      struct alignas(16) Entries {
        std::uint32_t of[batch];
      };
      const Entries entries = load_record(reinterpret_cast<const Entries*>(list + first));
      Packed other[batch];
      for (Index k = 0; k < batch; ++k)  // the particle itself adds nothing
        other[k] = load_record(task.fluid + (first + k < count ? entries.of[k] : i));
      for (Index k = 0; k < batch; ++k) add(centre, other[k], sums);
    }
    return finish(own, law, sums, centre.pairs.scale());
  }

  // What takes the place of the squared distance where two particles coincide, so that one over it
  // is finite.
  static constexpr Real closest_squared =
      std::is_same_v<Real, float> ? Real(1) : std::numeric_limits<Real>::min();

  KERF_FUNCTION static void add(const Centre& centre, const Packed& other, Sums& sums) {
    Vector<D, Real> d, v;
    Real distance_squared(0), along(0), speed_squared(0);
    for (int a = 0; a < D; ++a) {
      d[a] = static_cast<Real>(wrapping_difference(other.position[a], centre.own.position[a]));
      v[a] = other.velocity[a] - centre.own.velocity[a];
      distance_squared += d[a] * d[a];
      along += v[a] * d[a];
      speed_squared += v[a] * v[a];
    }
    const bool is_near = distance_squared < centre.reach_squared && distance_squared > Real(0);
    sums.fastest_squared = maximum(sums.fastest_squared, select(is_near, speed_squared, Real(0)));
    sums.near_free_surface |= is_near && other.volume < Real(0);

    const auto [distance, inverse] =
        root_and_inverse(maximum(distance_squared, Real(closest_squared)));
    const Real w = select(is_near, Real(1) - distance * centre.per_diameter, Real(0));
    const Real slope = Kernel::slope_shape(w);
    sums.kernel_sum += Kernel::value_shape(w);
    const Real volume = std::abs(other.volume);
    const auto star =
        centre.pairs(VolumeSide<Real>{volume, other.pressure}, along * inverse, inverse);
    const Real weight = pair_weight(volume, slope);
    sums.compression_rate -= pair_strain_rate(weight, distance, star.speed);
    const Real pressure = weight * star.mean_pressure, dissipation = weight * star.dissipation,
               drag = weight * centre.pairs.viscosity;
    sums.pressure_force += pressure * d;
    sums.dissipative_force += dissipation * d;
    sums.dissipative_force -= drag * v;
    sums.concentration_gradient += slope * d;
  }

  // `scale`: that of `Pairs`; the drag lacks the volume of the particle too.
  KERF_FUNCTION Result finish(const Packed& own, const FluidLaw<Real>& law, const Sums& sums,
                              Real scale) const {
    const Real gradient = law.kernel_slope * task.unit,
               normalised = Real(2) * law.kernel_gradient_normalisation * gradient,
               force = -normalised * std::abs(own.volume);
    Result result{};
    for (int a = 0; a < D; ++a) {
      result.sum[Result::pressure_force_at + a] = force * sums.pressure_force[a];
      result.sum[Result::dissipative_force_at + a] = force * sums.dissipative_force[a];
      result.sum[Result::concentration_gradient_at + a] =
          law.volume * gradient * sums.concentration_gradient[a];
    }
    result.sum[Result::compression_rate_at] = normalised * scale * sums.compression_rate;
    result.sum[Result::kernel_sum_at] = law.volume * law.kernel_scale * sums.kernel_sum;
    result.fastest_squared = sums.fastest_squared;
    result.near_free_surface = sums.near_free_surface ? Real(1) : Real(0);
    return result;
  }
};

}  // namespace kerf
