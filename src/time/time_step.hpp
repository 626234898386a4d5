// SPDX-License-Identifier: Apache-2.0
// The time step is at most the least of these limits over all particles:
//   acoustic  C h / (c + |v| + 1.2 A c), with the artificial viscosity A (Monaghan 1989, 1992),
//   force     0.25 sqrt(h / |a|),
//   viscous   0.125 h^2 rho / mu,
//   density   e / |d ln rho / dt| of a fluid, of an open one only where it is compressed;
//             largest_compression is e.
// The limit of the waves in solids is solid/wave_time_limit.hpp; ParticleRun::choose_step
// (simulation/particle_run_step.hpp) takes the least and records which limit it was. A particle
// whose state is not a number, or that moves ten times faster than the fastest wave of the run,
// stops the run.
#pragma once

#include <algorithm>
#include <cmath>

#include "materials/equation_of_state.hpp"
#include "particles/fields.hpp"

namespace kerf {

enum class Limit : int {
  acoustic_water,
  acoustic_solid,
  joint,
  acceleration,
  viscosity,
  compression,
  maximum_step,
  end_of_run,
  not_a_number,  // from here on: faults
  runaway,
  negative_density,
  too_dense,
};

inline const char* limit_name(Limit limit) {
  switch (limit) {
    case Limit::acoustic_water:
      return "acoustic (water)";
    case Limit::acoustic_solid:
      return "acoustic (solid)";
    case Limit::joint:
      return "joint (solid)";
    case Limit::acceleration:
      return "acceleration";
    case Limit::viscosity:
      return "viscosity";
    case Limit::compression:
      return "compression";
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
    case Limit::too_dense:
      return "a density beyond all pressures of its equation of state";
  }
  return "unknown";
}

struct StepLimit {
  double dt;  // s; negative for a fault
  Limit limit;
  Index particle;
};

// Of equal steps that of the particle with the lesser id.
struct SmallerStep {
  const std::uint32_t* id;  // of each particle

  KERF_FUNCTION StepLimit operator()(const StepLimit& a, const StepLimit& b) const {
    if (a.dt != b.dt) return a.dt < b.dt ? a : b;
    return id[a.particle] <= id[b.particle] ? a : b;
  }
};

// Whether the accelerations of the state that the step starts from are known. Where they are
// pending, the limits of the state itself, such as the acoustic one, have to do.
enum class StepRates : std::uint8_t { known, pending };

// Returns by what share of itself a density may rise in a step, 1. The sound speed of Tait's
// equation of state rises with its cube, (rho / rho_0)^((gamma - 1) / 2) with gamma = 7, and waves
// grow from a Courant number of 0.6 on (docs/theory/verlet.md), which it does not reach within the
// step. Jets much faster than the waves of a light solid crush it to a fraction of its volume in a
// few steps.
inline double largest_compression(double courant) {
  return std::max(0.05, std::cbrt(0.6 / courant) - 1.0);
}

template <int D, class P>
struct ParticleStepLimit {
  using Real = typename P::Real;
  ParticleView<D, P> particles;
  double courant, largest_compression;
  double runaway_speed;  // m/s
  double unlimited;      // s, a step longer than any
  StepRates rates;

  KERF_FUNCTION StepLimit operator()(Index i) const {
    StepLimit result{unlimited, Limit::maximum_step, i};
    if (particles.ghosts.has(i)) return result;
    const auto& medium = particles.medium(i);
    const double speed = norm(particles.velocity[i]);
    const bool known = rates == StepRates::known;
    const double acceleration = known ? double(norm(particles.acceleration[i])) : 0.0;
    const Limit fault = state_fault(i, speed);
    if (fault != Limit::maximum_step) return {broken_state, fault, i};
    if (medium.phase == Phase::rigid) return result;
    if (!is_number(acceleration + particles.compression_rate[i]))
      return {broken_rate, Limit::not_a_number, i};
    const bool water = medium.phase == Phase::water;
    const double h = medium.smoothing_length;
    const double wave_speed = sound_speed(medium, i);
    const double damping = 1.2 * medium.artificial_linear * medium.sound_speed;
    shorten(result, courant * h / (wave_speed + speed + damping),
            water ? Limit::acoustic_water : Limit::acoustic_solid);
    if (particles.is_constrained(i)) return result;
    if (acceleration > 0.0)
      shorten(result, 0.25 * std::sqrt(h / acceleration), Limit::acceleration);
    if (medium.viscosity > Real(0))
      shorten(result, 0.125 * h * h * particles.density(i) / medium.viscosity, Limit::viscosity);
    if (particles.has_density(i)) limit_compression(i, result);
    return result;
  }

 private:
  // Fastest wave, m/s. Solids of the `standard` formulation have a density where it stiffens them.
  KERF_FUNCTION double sound_speed(const Medium<Real>& medium, Index i) const {
    if (medium.phase != Phase::water && !medium.cavitates) return medium.longitudinal_speed;
    const bool solid = medium.phase == Phase::solid && !particles.fractured[i];
    return sound_speed_at(medium, particles.compression[i]) *
           (solid ? medium.longitudinal_speed / medium.sound_speed : Real(1));
  }

  // Matter that has not opened may swing: what expands now is compressed in the next step.
  KERF_FUNCTION void limit_compression(Index i, StepLimit& result) const {
    const double compression = particles.compression[i], rate = particles.compression_rate[i];
    const double fastest = compression < 0.0 ? rate : std::abs(rate);
    if (fastest > 0.0)
      shorten(result, largest_compression * (1.0 + compression) / fastest, Limit::compression);
  }

  // A broken state is reported rather than the rates that it breaks around it: the lesser step
  // wins.
  static constexpr double broken_state = -2.0, broken_rate = -1.0;

  KERF_FUNCTION static bool is_number(double value) { return value - value == 0.0; }

  // The fault of the state of particle i; maximum_step = none.
  KERF_FUNCTION Limit state_fault(Index i, double speed) const {
    double sum = speed + double(particles.compression[i]);
    for (int a = 0; a < D; ++a) sum += particles.position[i][a];
    // The stress of water follows from the rates.
    if (particles.shear != nullptr && particles.medium(i).phase == Phase::solid)
      sum += double(contract(particles.shear[i], particles.shear[i]));
    if (particles.compression[i] <= Real(-1)) return Limit::negative_density;
    if (!is_number(sum)) return Limit::not_a_number;
    if (is_too_dense(particles.medium(i), particles.compression[i])) return Limit::too_dense;
    return speed > runaway_speed ? Limit::runaway : Limit::maximum_step;
  }

  KERF_FUNCTION static void shorten(StepLimit& result, double dt, Limit limit) {
    if (dt < result.dt) {
      result.dt = dt;
      result.limit = limit;
    }
  }
};

}  // namespace kerf
