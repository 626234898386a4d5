// SPDX-License-Identifier: Apache-2.0
// BalanceAccumulator adds the impulses, work and dissipation of each step, inflow and outflow to
// the balance.
#pragma once

#include "simulation/balance.hpp"
#include "simulation/balance_sums.hpp"

namespace kerf {

template <int D, class P, class Traits>
class BalanceAccumulator {
 public:
  void set_masses(const std::vector<double>& mass_per_source) {
    to_device(mass_per_source, mass_of_);
    mass_on_host_ = mass_per_source;
  }

  void open(Particles<D, P>& particles, const Vector<D, double>& gravity) {
    const Balance now = state(particles, gravity);
    balance_.mass_initial = now.mass_now;
    balance_.momentum_initial = now.momentum_now;
    balance_.energy_initial = now.energy_total();
  }

  // Adds a step. Calls before(i) and after(i) around the sums of each particle, in the same pass
  // through memory. Returns how far the particles moved in the step.
  template <class Before, class After>
  StepMotion accumulate_step(Particles<D, P>& particles, const Vector<D, double>& gravity,
                             double dt, const Before& before, const After& after) {
    using Change = StepChange<D, P>;
    const Change change{particles.view(), pointer(mass_of_), gravity, dt};
    const auto sum = change_sum_(particles.sum_groups.view(), particles.size(),
                                 StepWithBodies<D, P, Before, After>{before, change, after});
    for (int a = 0; a < D; ++a) {
      const auto axis = static_cast<std::size_t>(a);
      balance_.impulse_rigid[axis] += sum.value[Change::plate + a];
      balance_.impulse_constraint[axis] += sum.value[Change::constraint + a];
      balance_.impulse_water[axis] += sum.value[Change::water + a];
      balance_.impulse_gravity[axis] += sum.value[Change::mass] * gravity[a] * dt;
    }
    balance_.constraint_scale += sum.value[Change::magnitude];
    balance_.work_gravity += sum.value[Change::gravity_work];
    balance_.work_constraint += sum.value[Change::constraint_work];
    balance_.dissipated_artificial += sum.value[Change::artificial];
    balance_.dissipated_viscous += sum.value[Change::viscous];
    balance_.dissipated_fracture += sum.value[Change::fracture];
    balance_.dissipated_density += sum.value[Change::continuity];
    balance_.dissipated_reinitialisation += sum.value[Change::reinitialisation];
    return sum.motion.roots();
  }

  void accumulate_outflow(Particles<D, P>& particles) {
    using Outflow = OutflowSum<D, P, Traits>;
    const auto sum = outflow_sum_(particles.sum_groups.view(), particles.size(),
                                  Outflow{particles.view(), pointer(mass_of_)});
    balance_.mass_out += sum.value[Outflow::mass_out];
    balance_.mass_erased += sum.value[Outflow::mass_erased];
    for (int a = 0; a < D; ++a)
      balance_.momentum_out[static_cast<std::size_t>(a)] += sum.value[Outflow::momentum + a];
    balance_.energy_out += sum.value[Outflow::energy];
  }

  // Adds a particle of unstressed water of the medium `source` that enters with `velocity`.
  void accumulate_inflow(std::size_t source, const std::array<double, 3>& velocity) {
    const double m = mass_on_host_[source];
    balance_.mass_in += m;
    double square = 0.0;
    for (std::size_t a = 0; a < static_cast<std::size_t>(D); ++a) {
      const double v = static_cast<typename P::Real>(velocity[a]);  // rounded as in the particle
      balance_.momentum_in[a] += m * v;
      square += v * v;
    }
    balance_.energy_in += 0.5 * m * square;
  }

  // Adds an exchange of solid in a travelling frame, from the balances before and after it.
  void accumulate_exchange(const Balance& before, const Balance& after, double mass_fed) {
    balance_.mass_fed += mass_fed;
    balance_.mass_left += before.mass_now + mass_fed - after.mass_now;
    for (std::size_t a = 0; a < 3; ++a)
      balance_.momentum_left[a] += before.momentum_now[a] - after.momentum_now[a];
    balance_.energy_left += before.energy_total() - after.energy_total();
  }

  // Returns the balance with the current state; the rates must be those of the state.
  Balance state(Particles<D, P>& particles, const Vector<D, double>& gravity) {
    using State = StateSum<D, P, Traits>;
    const auto sum = state_sum_(particles.sum_groups.view(), particles.size(),
                                State{particles.view(), pointer(mass_of_), gravity});
    Balance now = balance_;
    now.mass_now = sum.value[State::mass];
    now.mass_fractured = sum.value[State::fractured_mass];
    for (int a = 0; a < D; ++a) {
      now.momentum_now[static_cast<std::size_t>(a)] = sum.value[State::momentum + a];
      now.force_rigid[static_cast<std::size_t>(a)] = sum.value[State::rigid_force + a];
      now.force_water[static_cast<std::size_t>(a)] = sum.value[State::water_force + a];
    }
    now.kinetic = sum.value[State::kinetic];
    now.pressure_work = sum.value[State::pressure_work];
    now.stored_water = sum.value[State::stored_water];
    now.stored_solid = sum.value[State::stored_solid];
    now.elastic_deviatoric = sum.value[State::deviatoric];
    now.rigid_potential = sum.value[State::rigid_potential];
    now.momentum_scale = sum.value[State::momentum_scale];
    return now;
  }

  double mass_of(std::size_t source) const { return mass_on_host_[source]; }
  const Balance& totals() const { return balance_; }
  void restore(const Balance& balance) { balance_ = balance; }
  std::size_t bytes() const {
    return change_sum_.bytes() + state_sum_.bytes() + outflow_sum_.bytes();
  }

 private:
  Balance balance_;
  Array<double> mass_of_;
  std::vector<double> mass_on_host_;
  GroupSum<typename StepChange<D, P>::Sum> change_sum_;
  GroupSum<Terms<StateSum<D, P, Traits>::slots>> state_sum_;
  GroupSum<Terms<OutflowSum<D, P, Traits>::slots>> outflow_sum_;
};

}  // namespace kerf
