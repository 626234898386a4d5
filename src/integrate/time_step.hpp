// SPDX-License-Identifier: Apache-2.0
// The time step: the least of the limits below over all particles, and the name of the one that set
// it. Acoustic: C h / (c + |v| + 1.2 A c), the viscous term after Monaghan (1989, 1992); force:
// 0.25 sqrt(h / |a|); viscous: 0.125 h^2 rho / mu. A particle whose state is no longer a number, or
// that moves ten times faster than the fastest wave of the run, stops it.
#pragma once

#include <cmath>

#include "materials/tait_water.hpp"
#include "particles/fields.hpp"

namespace kerf {

enum class Limit : int {
  acoustic_water,
  acoustic_solid,
  acceleration,
  viscosity,
  maximum_step,
  end_of_run,
  not_a_number,  // from here on: faults
  runaway,
  negative_density,
};

inline const char* limit_name(Limit limit) {
  switch (limit) {
    case Limit::acoustic_water:
      return "acoustic (water)";
    case Limit::acoustic_solid:
      return "acoustic (solid)";
    case Limit::acceleration:
      return "acceleration";
    case Limit::viscosity:
      return "viscosity";
    case Limit::maximum_step:
      return "maximum step";
    case Limit::end_of_run:
      return "end of run";
    case Limit::not_a_number:
      return "a value that is not a number";
    case Limit::runaway:
      return "a speed over ten times the fastest speed of sound";
    case Limit::negative_density:
      return "a density of zero or less";
  }
  return "unknown";
}

struct StepLimit {
  double dt;  // s; negative for a fault
  Limit limit;
  Index particle;
};

struct SmallerStep {
  KERF_FUNCTION StepLimit operator()(const StepLimit& a, const StepLimit& b) const {
    if (a.dt != b.dt) return a.dt < b.dt ? a : b;
    return a.particle <= b.particle ? a : b;
  }
};

template <int D, class P>
struct ParticleStepLimit {
  using Real = typename P::Real;
  ParticleView<D, P> particles;
  double courant;
  double runaway_speed;  // m/s
  double unlimited;      // s, a step longer than any

  KERF_FUNCTION StepLimit operator()(Index i) const {
    StepLimit result{unlimited, Limit::maximum_step, i};
    const auto& medium = particles.medium(i);
    if (medium.phase == Phase::rigid) return result;
    const bool water = medium.phase == Phase::water;
    const double h = medium.smoothing_length;
    const double speed = norm(particles.velocity[i]);
    const double acceleration = norm(particles.acceleration[i]);
    const double compression = particles.compression[i];
    // NaN anywhere in the state reaches the acceleration or the rate of compression.
    const double sum = speed + acceleration + compression + particles.compression_rate[i] +
                       contract(particles.shear[i], particles.shear[i]);
    if (!(sum - sum == 0.0)) return {-1.0, Limit::not_a_number, i};
    if (compression <= -1.0) return {-1.0, Limit::negative_density, i};
    const double sound = water ? double(TaitWater::sound_speed(medium, Real(compression)))
                               : double(medium.longitudinal_speed);
    if (speed > runaway_speed) return {-1.0, Limit::runaway, i};

    const double damping = 1.2 * medium.artificial_linear * medium.sound_speed;
    shorten(result, courant * h / (sound + speed + damping),
            water ? Limit::acoustic_water : Limit::acoustic_solid);
    if (particles.is_constrained(i)) return result;
    if (acceleration > 0.0)
      shorten(result, 0.25 * std::sqrt(h / acceleration), Limit::acceleration);
    if (medium.viscosity > Real(0))
      shorten(result, 0.125 * h * h * particles.density(i) / medium.viscosity, Limit::viscosity);
    return result;
  }

 private:
  KERF_FUNCTION static void shorten(StepLimit& result, double dt, Limit limit) {
    if (dt < result.dt) {
      result.dt = dt;
      result.limit = limit;
    }
  }
};

}  // namespace kerf
