// SPDX-License-Identifier: Apache-2.0
// Keeps the ledger: adds each step's impulses, work and dissipation, and what enters and leaves.
#pragma once

#include "simulation/ledger.hpp"
#include "simulation/ledger_sums.hpp"

namespace kerf {

template <int D, class P>
class LedgerBook {
 public:
  void set_masses(const std::vector<double>& mass_per_source) {
    to_device(mass_per_source, mass_of_);
    mass_on_host_ = mass_per_source;
  }

  void open(Particles<D, P>& particles, const Vector<D, double>& gravity) {
    const Ledger now = state(particles, gravity);
    ledger_.mass_initial = now.mass_now;
    ledger_.momentum_initial = now.momentum_now;
    ledger_.energy_initial = now.energy_total();
  }

  // Calls before(i) and after(i) around the booking of each particle, in the same pass through
  // memory. Returns how far they moved in the step.
  template <class Before, class After>
  StepMotion book_step(Particles<D, P>& particles, const Vector<D, double>& gravity, double dt,
                       const Before& before, const After& after) {
    using Change = StepChange<D, P>;
    const Change change{particles.view(), pointer(mass_of_), gravity, dt};
    const auto sum =
        add_up(particles.size(), BookedStep<D, P, Before, After>{before, change, after});
    for (int a = 0; a < D; ++a) {
      const auto axis = static_cast<std::size_t>(a);
      ledger_.impulse_plate[axis] += sum.value[Change::plate + a];
      ledger_.impulse_constraint[axis] += sum.value[Change::constraint + a];
      ledger_.impulse_water[axis] += sum.value[Change::water + a];
      ledger_.impulse_gravity[axis] += sum.value[Change::mass] * gravity[a] * dt;
    }
    ledger_.work_gravity += sum.value[Change::gravity_work];
    ledger_.work_constraint += sum.value[Change::constraint_work];
    ledger_.dissipated_artificial += sum.value[Change::artificial];
    ledger_.dissipated_viscous += sum.value[Change::viscous];
    ledger_.dissipated_fracture += sum.value[Change::fracture];
    return sum.motion.roots();
  }

  void book_leavers(Particles<D, P>& particles) {
    using Leavers = LeaverSum<D, P>;
    const auto sum = leaver_sum_(particles.size(), Leavers{particles.view(), pointer(mass_of_)});
    ledger_.mass_out += sum.value[Leavers::mass_out];
    ledger_.mass_erased += sum.value[Leavers::mass_erased];
    for (int a = 0; a < D; ++a)
      ledger_.momentum_out[static_cast<std::size_t>(a)] += sum.value[Leavers::momentum + a];
    ledger_.energy_out += sum.value[Leavers::energy];
  }

  // Water of source `source` entering with `velocity`, unstressed.
  void book_entry(std::size_t source, const std::array<double, 3>& velocity) {
    const double m = mass_on_host_[source];
    ledger_.mass_in += m;
    double square = 0.0;
    for (std::size_t a = 0; a < static_cast<std::size_t>(D); ++a) {
      const double v = static_cast<typename P::Real>(velocity[a]);  // as the particle holds it
      ledger_.momentum_in[a] += m * v;
      square += v * v;
    }
    ledger_.energy_in += 0.5 * m * square;
  }

  void set_jet_mass(double due, double emitted) {
    ledger_.jet_mass_due = due;
    ledger_.jet_mass_carried = due - emitted;
  }

  // The ledger with the state filled in; rates must be those of the state.
  Ledger state(Particles<D, P>& particles, const Vector<D, double>& gravity) {
    using State = StateSum<D, P>;
    const auto sum =
        state_sum_(particles.size(), State{particles.view(), pointer(mass_of_), gravity});
    Ledger now = ledger_;
    now.mass_now = sum.value[State::mass];
    now.mass_fractured = sum.value[State::fractured_mass];
    for (int a = 0; a < D; ++a) {
      now.momentum_now[static_cast<std::size_t>(a)] = sum.value[State::momentum + a];
      now.force_plate[static_cast<std::size_t>(a)] = sum.value[State::plate_force + a];
      now.force_water[static_cast<std::size_t>(a)] = sum.value[State::water_force + a];
    }
    now.kinetic = sum.value[State::kinetic];
    now.pressure_work = sum.value[State::pressure_work];
    now.stored_water = sum.value[State::stored_water];
    now.stored_solid = sum.value[State::stored_solid];
    now.elastic_deviatoric = sum.value[State::deviatoric];
    now.plate_potential = sum.value[State::plate_potential];
    now.momentum_scale = sum.value[State::momentum_scale];
    return now;
  }

  const Ledger& totals() const { return ledger_; }
  void restore(const Ledger& ledger) { ledger_ = ledger; }

 private:
  // A block is one thread's: on a GPU what is more than a sum goes over all particles by itself.
  template <class Booked>
  typename Booked::Sum add_up(Index count, const Booked& booked) {
    if constexpr (!on_gpu) return change_sum_(count, booked);
    for_each_index(count, booked.before);
    auto sum = change_sum_(count, booked.change);
    for_each_index(count, booked.after);
    sum.motion = reduce_unordered(count, MotionOf<D, P>{booked.change.particles}, MotionSquares{},
                                  FartherMotion{});
    return sum;
  }

  Ledger ledger_;
  Array<double> mass_of_;
  std::vector<double> mass_on_host_;
  OrderedFold<typename StepChange<D, P>::Sum> change_sum_;
  OrderedSum<StateSum<D, P>::slots> state_sum_;
  OrderedSum<LeaverSum<D, P>::slots> leaver_sum_;
};

}  // namespace kerf
