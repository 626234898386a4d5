// SPDX-License-Identifier: Apache-2.0
// The formulation of Shinohara et al. (2004): `advance` is the order of a step.
#pragma once

#include "exec/in_turn.hpp"
#include "fracture/break_particles.hpp"
#include "integrate/midpoint.hpp"
#include "rates/rates.hpp"
#include "simulation/particle_run.hpp"

namespace kerf {

template <int D, class P>
class Shinohara2004 final : public ParticleRun<D, P, JointPairs> {
  using Run = ParticleRun<D, P, JointPairs>;

 public:
  explicit Shinohara2004(const Case& description)
      : Run(description),
        rates_(Vector<D, double>::from(description.gravity), description.artificial_stress) {
    Run::open([] {});
  }

  void advance() override {
    Run::renew_neighbours();
    evaluate_rates();
    const double dt = Run::choose_step(StepRates::at_hand);
    keep_start();
    advance_to(0.5 * dt);
    evaluate_rates();
    advance_to(dt);
    break_particles();
    close_step(dt);
    Run::tick(dt);
  }

 private:
  using Run::drives_, Run::list_, Run::pair_interactions_, Run::particles_, Run::time_,
      Run::timers_;

  void evaluate_now() const override { rates_.evaluate(particles_, list_.view()); }

  void accelerate_across(const AcrossPlane<D>& across) const override {
    rates_.accelerate(particles_, particles_.view(), list_.view(), across, BodyForce<D, P>{});
  }

  void evaluate_rates() const {
    const auto timer = timers_.stage("rates");
    rates_.evaluate(particles_, list_.view());
    pair_interactions_ += static_cast<double>(list_.pairs()) * Rates<D, P>::pair_passes;
  }

  void keep_start() { for_each_index(particles_.size(), KeepStart<D, P>{particles_.view()}); }

  void advance_to(double dt) {
    const auto timer = timers_.stage("integrate");
    Run::load_drives(time_ + dt);
    for_each_index(particles_.size(),
                   AdvanceFromStart<D, P>{particles_.view(), pointer(drives_), dt});
  }

  void break_particles() {
    const auto timer = timers_.stage("fracture");
    for_each_index(particles_.size(), BreakParticles<D, P>{particles_.view()});
  }

  void close_step(double dt) {
    const auto timer = timers_.stage("integrate");
    Run::book_step(dt, Idle{}, Run::mark_leavers());
  }

  Rates<D, P> rates_;
};

}  // namespace kerf
