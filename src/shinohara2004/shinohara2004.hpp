// SPDX-License-Identifier: Apache-2.0
// The formulation of Shinohara et al. (2004): `advance` is the order of a step.
#pragma once

#include "parallel/fused_kernel.hpp"
#include "shinohara2004/midpoint.hpp"
#include "shinohara2004/rates.hpp"
#include "shinohara2004/simple_fracture.hpp"
#include "shinohara2004/traits.hpp"
#include "simulation/particle_run.hpp"
#include "time/save_step_start.hpp"

namespace kerf {

template <int D, class P>
class Shinohara2004 final : public ParticleRun<D, P, Shinohara2004Traits> {
  using Run = ParticleRun<D, P, Shinohara2004Traits>;

 public:
  explicit Shinohara2004(const RunSettings& settings)
      : Run(settings),
        rates_(Run::gravity_, settings.artificial_stress, settings.artificial_stress_exponent) {
    Run::open([] {});
  }

  void advance() override {
    Run::inject_inflow();
    // With a margin of half the last step, so that the list is valid to the end of this step.
    Run::renew_neighbours(1.5 * Run::last_step().dt);
    evaluate_rates();
    const double dt = Run::choose_step(StepRates::known);
    keep_start();
    advance_to(0.5 * dt, dt);
    evaluate_rates();
    advance_to(dt, dt);
    break_particles();
    finalize_step(dt);
    Run::tick(dt);
  }

  Frame frame() const override {
    Frame frame = Run::frame();
    show_equivalent_strain(frame);
    return frame;
  }

 private:
  using Run::prescribed_motions_, Run::list_, Run::pair_interactions_, Run::particles_, Run::time_,
      Run::timers_;

  void evaluate_current() const override { rates_.evaluate(particles_, list_.view()); }

  void accelerate_across(const AcrossPlane<D>& across) const override {
    rates_.accelerate(particles_, particles_.view(), list_.view(), across, BodyForce<D, P>{});
  }

  void evaluate_rates() const {
    const auto timer = timers_.stage("rates");
    rates_.evaluate(particles_, list_.view());
    pair_interactions_ += static_cast<double>(list_.pairs()) * Rates<D, P>::pair_passes;
  }

  void keep_start() { for_each_index(particles_.size(), SaveStepStart<D, P>{particles_.view()}); }

  // Advances by `dt` from the start of a step that is `whole` long, s.
  void advance_to(double dt, double whole) {
    const auto timer = timers_.stage("integrate");
    Run::load_prescribed_motions(time_ + dt, time_ + whole);
    for_each_index(particles_.size(),
                   AdvanceFromStart<D, P>{particles_.view(), pointer(prescribed_motions_), dt});
  }

  void break_particles() {
    const auto timer = timers_.stage("fracture");
    for_each_index(particles_.size(), BreakParticles<D, P>{particles_.view()});
  }

  void finalize_step(double dt) {
    const auto timer = timers_.stage("integrate");
    Run::accumulate_step(dt, NoOp{}, Run::mark_outflow());
  }

  void show_equivalent_strain(Frame& frame) const {
    const auto shear = to_host(particles_.shear);
    const auto source = to_host(particles_.source);
    Column strain{"equivalent_strain", "1", 1, {}, "equivalent strain"};
    for (std::size_t i = 0; i < shear.size(); ++i) {
      const Medium<double>& medium = Run::media_[source[i]];
      const auto shear_modulus = static_cast<typename P::Real>(medium.shear_modulus);
      const bool solid = medium.phase == Phase::solid;
      strain.values.push_back(solid ? static_cast<float>(equivalent_strain(shear[i], shear_modulus))
                                    : 0.0f);
    }
    frame.columns.push_back(std::move(strain));
  }

  Rates<D, P> rates_;
};

}  // namespace kerf
