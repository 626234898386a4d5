// SPDX-License-Identifier: Apache-2.0
// RigidPowerSum is the power at which rigid bodies that move work on a particle: the sum of the
// force of each of their particles times its velocity, by the kind of the force. The rates of a
// step do not need it, the balance of energy does (docs/theory/balance.md), so that it is a loop of
// its own, only in runs in which a rigid body moves.
#pragma once

#include "contact/surface_contact.hpp"
#include "fluid/fluid_force.hpp"
#include "fluid/water_viscosity.hpp"

namespace kerf {

// It must come after all that adds to `repulsion`. What that holds for fluid besides the forces of
// pairs (fluid/gradient_at_wall.hpp) is a pressure force and works at the mean velocity of the
// walls.
template <int D, class P>
struct RigidPowerSum {
  using Real = typename P::Real;
  using RealVector = Vector<D, Real>;
  static constexpr bool includes_rigid = false;
  struct Sum {
    RigidPower<Real> power{};      // W
    RealVector force{};            // N, of all pairs
    RealVector weighted_motion{};  // m/s, velocities of the walls by their weights
    Real weight{};
  };
  FluidForce<D, P> fluid;
  WaterViscosity<D, P> viscosity;
  SurfaceContact<D, P> contact;

  KERF_FUNCTION void add(const ParticleView<D, P>& particles, const Pair<D, P>& pair,
                         Sum& sum) const {
    if (pair.medium_i->phase == Phase::rigid || pair.medium_j->phase != Phase::rigid) return;
    const RealVector velocity = pair.of_j(particles.velocity[pair.j]);
    const Real weight = pair.medium_j->volume * pair.slope_per_distance;
    sum.weight += weight;
    sum.weighted_motion += weight * velocity;
    typename FluidForce<D, P>::Sum by_pressure{};
    typename WaterViscosity<D, P>::Sum by_viscosity{};
    typename SurfaceContact<D, P>::Sum by_contact{};
    fluid.add(particles, pair, by_pressure);
    viscosity.add(particles, pair, by_viscosity);
    contact.add(particles, pair, by_contact);
    const RealVector damping =
        by_pressure.dissipative_force + by_viscosity.friction + by_contact.friction;
    sum.force += by_pressure.pressure_force + damping + by_contact.normal_force;
    sum.power.pressure += dot(by_pressure.pressure_force, velocity);
    sum.power.dissipation += dot(damping, velocity);
    sum.power.contact += dot(by_contact.normal_force, velocity);
  }
  KERF_FUNCTION void finish(const ParticleView<D, P>& particles, Index i, const Sum& sum) const {
    RigidPower<Real> power{};
    if (sum.weight > Real(0)) {
      const Real inverse = Real(1) / particles.medium(i).mass;
      power = {inverse * sum.power.pressure, inverse * sum.power.dissipation,
               inverse * sum.power.contact};
      if (particles.is_fluid(i)) {
        const RealVector rest = particles.repulsion[i] - inverse * sum.force;
        power.pressure += dot(rest, sum.weighted_motion) / sum.weight;
      }
    }
    particles.rigid_power[i] = power;
  }
};

}  // namespace kerf
