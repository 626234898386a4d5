// SPDX-License-Identifier: Apache-2.0
// The functors of the balance's sums over particles (parallel/group_sum.hpp). `Traits` are those
// of the formulation (simulation/particle_run.hpp): what a solid particle stores follows from its
// laws.
#pragma once

#include "materials/equation_of_state.hpp"
#include "neighbours/step_motion.hpp"
#include "particles/fields.hpp"

namespace kerf {

// Energy that a solid particle stores, J: by its density and by its deviatoric stress.
struct SolidStorage {
  double volumetric, deviatoric;
};

// Energy that particle i holds, J: kinetic and stored.
template <int D, class P, class Traits>
struct ParticleEnergy {
  double kinetic, pressure_work, deviatoric;
  double stored_water, stored_solid;  // by the equations of state, part of pressure_work

  KERF_FUNCTION static ParticleEnergy of(const ParticleView<D, P>& particles, Index i,
                                         double mass) {
    const auto& medium = particles.medium(i);
    const double compression = particles.compression[i];
    const auto v = Vector<D, double>::from(particles.velocity[i]);
    ParticleEnergy e{0.5 * mass * dot(v, v), mass * double(particles.pressure_work[i]), 0.0, 0.0,
                     0.0};
    if (medium.phase == Phase::water) {
      e.stored_water = mass * energy_at(medium, compression);
    } else {
      const SolidStorage stored = Traits::stored_by_solid(particles, i, mass);
      e.stored_solid = stored.volumetric;
      e.deviatoric = stored.deviatoric;
    }
    return e;
  }
};

// The force on a particle of water besides gravity, rigid bodies and mirror images, N. The forces
// between particles of water cancel, so that the sum over all water is the force of the solids.
template <int D, class P>
KERF_FUNCTION Vector<D, double> force_of_others(const ParticleView<D, P>& particles, Index i,
                                                double mass, const Vector<D, double>& gravity) {
  auto acceleration = Vector<D, double>::from(particles.acceleration[i]) - gravity -
                      Vector<D, double>::from(particles.repulsion[i]);
  if (particles.mirrors.faces != 0)
    acceleration -= Vector<D, double>::from(particles.mirror_acceleration[i]);
  return mass * acceleration;
}

// The changes over one step, from the rates at its middle and the states at both ends. The pressure
// work of each particle is advanced in the same loop.
template <int D, class P>
struct StepChange {
  enum Slot {
    plate = 0,
    constraint = D,
    water = 2 * D,
    magnitude = 3 * D,  // of the impulses of rigid bodies and constraints
    mass,
    gravity_work,
    constraint_work,
    artificial,
    viscous,
    fracture,
    continuity,
    reinitialisation,
    slots
  };
  struct Sum : Terms<slots> {
    MotionSquares motion;

    KERF_FUNCTION static Sum zero() { return {Terms<slots>::zero(), {}}; }
    KERF_FUNCTION void join(const Sum& other) {
      Terms<slots>::join(other);
      motion.join(other.motion);
    }
  };
  ParticleView<D, P> particles;
  const double* mass_of;  // kg, per source
  Vector<D, double> gravity;
  double dt;

  KERF_FUNCTION void add(Index i, Terms<slots>& sum) const {
    const auto& medium = particles.medium(i);
    if (medium.phase == Phase::rigid || particles.is_asleep(i)) return;
    particles.pressure_work[i] += static_cast<typename P::Real>(dt) * particles.pressure_power[i];
    const double m = mass_of[particles.source[i]];
    if (particles.continuity_loss != nullptr) add_density_losses(i, m, sum);
    const auto moved = particles.position[i] - particles.start_position[i];
    const auto acceleration = Vector<D, double>::from(particles.acceleration[i]);
    add_impulse(plate, m * dt * Vector<D, double>::from(particles.repulsion[i]), sum);
    if (particles.mirrors.faces != 0)
      add_impulse(constraint, m * dt * Vector<D, double>::from(particles.mirror_acceleration[i]),
                  sum);
    sum.value[mass] += m;
    sum.value[gravity_work] += m * dot(gravity, moved);
    sum.value[artificial] += m * artificial_work(i, moved);
    if (particles.rigid_power != nullptr) add_rigid_work(i, m, sum);
    if (particles.fracture_loss != nullptr)
      sum.value[fracture] += double(particles.fracture_loss[i]);
    if (medium.phase == Phase::water) {
      const auto force = force_of_others(particles, i, m, gravity);
      for (int a = 0; a < D; ++a) sum.value[water + a] -= dt * force[a];
      if (particles.shear != nullptr)
        sum.value[viscous] += m * dt / double(particles.density(i)) *
                              double(contract(particles.shear[i], particles.velocity_gradient[i]));
    }
    if (!particles.is_constrained(i)) return;
    const auto before = Vector<D, double>::from(particles.start_velocity[i]);
    const auto after = Vector<D, double>::from(particles.velocity[i]);
    add_impulse(constraint, m * (after - before - dt * acceleration), sum);
    sum.value[constraint_work] +=
        m * (0.5 * (dot(after, after) - dot(before, before)) - dot(acceleration, moved));
  }

 private:
  KERF_FUNCTION static void add_impulse(Slot first, const Vector<D, double>& impulse,
                                        Terms<slots>& sum) {
    for (int a = 0; a < D; ++a) sum.value[first + a] += impulse[a];
    sum.value[magnitude] += norm(impulse);
  }
  // What dissipative forces take in the step, J/kg: those of the `standard` formulation are known,
  // artificial terms give their power.
  KERF_FUNCTION double artificial_work(Index i, const Vector<D, double>& moved) const {
    if (particles.artificial_power != nullptr) return dt * double(particles.artificial_power[i]);
    return -dot(Vector<D, double>::from(particles.damping_acceleration[i]), moved);
  }
  // Dissipative forces of a body that moves take what they do not give to the particle.
  KERF_FUNCTION void add_rigid_work(Index i, double m, Terms<slots>& sum) const {
    const auto& power = particles.rigid_power[i];
    sum.value[constraint_work] += m * dt * double(power.total());
    sum.value[artificial] += m * dt * double(power.dissipation);
  }
  // What the densities do not store is no longer pressure work.
  KERF_FUNCTION void add_density_losses(Index i, double m, Terms<slots>& sum) const {
    particles.pressure_work[i] -= particles.continuity_loss[i] + particles.reinitialisation_loss[i];
    sum.value[continuity] += m * double(particles.continuity_loss[i]);
    sum.value[reinitialisation] += m * double(particles.reinitialisation_loss[i]);
  }
};

// The end of a step, group by group: the body that ends it for each particle, the sums, and the
// body that follows. These are separate loops over a few particles, which stay in the cache between
// them.
template <int D, class P, class Before, class After>
struct StepWithBodies {
  using Sum = typename StepChange<D, P>::Sum;
  static constexpr Index length = 64;  // particles

  Before before;
  StepChange<D, P> change;
  After after;

  KERF_FUNCTION void add_all(Index begin, Index end, Sum& sum) const {
    for (; begin < end; begin += length) {
      const Index last = end - begin < length ? end : begin + length;
      for (Index i = begin; i < last; ++i) before(i);
      for (Index i = begin; i < last; ++i) change.add(i, sum);
      for (Index i = begin; i < last; ++i) after(i);
      for (Index i = begin; i < last; ++i) sum.motion.include(change.particles, i);
    }
  }
};

// The state of the particles.
template <int D, class P, class Traits>
struct StateSum {
  enum Slot {
    mass = 0,
    fractured_mass,
    momentum,
    kinetic = momentum + D,
    pressure_work,
    deviatoric,
    stored_water,
    stored_solid,
    rigid_potential,
    rigid_force,
    water_force = rigid_force + D,
    momentum_scale = water_force + D,
    slots
  };
  ParticleView<D, P> particles;
  const double* mass_of;
  Vector<D, double> gravity;

  KERF_FUNCTION void add(Index i, Terms<slots>& sum) const {
    const Phase phase = particles.medium(i).phase;
    if (phase == Phase::rigid) return;
    const double m = mass_of[particles.source[i]];
    if (phase == Phase::water) {
      const auto force = force_of_others(particles, i, m, gravity);
      for (int a = 0; a < D; ++a) sum.value[water_force + a] -= force[a];
    }
    const auto energy = ParticleEnergy<D, P, Traits>::of(particles, i, m);
    sum.value[mass] += m;
    sum.value[fractured_mass] += particles.fractured[i] ? m : 0.0;
    for (int a = 0; a < D; ++a) {
      sum.value[momentum + a] += m * double(particles.velocity[i][a]);
      sum.value[rigid_force + a] -= m * double(particles.repulsion[i][a]);
    }
    sum.value[kinetic] += energy.kinetic;
    sum.value[pressure_work] += energy.pressure_work;
    sum.value[deviatoric] += energy.deviatoric;
    sum.value[stored_water] += energy.stored_water;
    sum.value[stored_solid] += energy.stored_solid;
    sum.value[rigid_potential] += m * double(particles.repulsion_potential[i]);
    sum.value[momentum_scale] += m * norm(Vector<D, double>::from(particles.velocity[i]));
  }
};

// Mass, momentum and energy of the particles that are marked for removal.
template <int D, class P, class Traits>
struct OutflowSum {
  enum Slot { mass_out = 0, mass_erased, count, momentum, energy = momentum + D, slots };
  ParticleView<D, P> particles;
  const double* mass_of;

  KERF_FUNCTION void add(Index i, Terms<slots>& sum) const {
    if (!particles.has(i, flag::outside | flag::erased)) return;
    const double m = mass_of[particles.source[i]];
    const auto e = ParticleEnergy<D, P, Traits>::of(particles, i, m);
    sum.value[particles.has(i, flag::outside) ? mass_out : mass_erased] += m;
    sum.value[count] += 1.0;
    for (int a = 0; a < D; ++a) sum.value[momentum + a] += m * double(particles.velocity[i][a]);
    sum.value[energy] += e.kinetic + e.pressure_work + e.deviatoric;
  }
};

}  // namespace kerf
