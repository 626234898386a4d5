// SPDX-License-Identifier: Apache-2.0
// The `standard` formulation: water by Riemann SPH, solids by total Lagrangian SPH over bonds,
// contact between them where they are now; `advance` is the order of a step.
#pragma once

#include "exec/in_turn.hpp"
#include "integrate/midpoint.hpp"
#include "integrate/regain_density.hpp"
#include "integrate/shift_particles.hpp"
#include "integrate/trade_places.hpp"
#include "integrate/verlet.hpp"
#include "rates/standard_rates.hpp"
#include "simulation/flaw_media.hpp"
#include "simulation/particle_run.hpp"
#include "simulation/solid_part.hpp"

namespace kerf {

template <int D, class P>
class Standard : public ParticleRun<D, P, ContactPairs> {
  using Run = ParticleRun<D, P, ContactPairs>;

 public:
  explicit Standard(const Case& description)
      : Run(description),
        lattice_(lattice_sums<D, ContactPairs::Kernel<D>>(description.smoothing_ratio)),
        rates_(Vector<D, double>::from(description.gravity), Run::media_, lattice_,
               description.numerics.water),
        solid_(description, Run::media_, Run::particles_) {
    rates_.fit_pairs(solid_.pair_fit());
    if (rates_.takes_alike_apart()) list_.put_kin_first();
    Run::open([this] { rates_.fit_surfaces(particles_.view(), particles_.size(), list_.view()); });
    evaluate();  // of the first rates
    for_each_index(particles_.size(), KeepSurroundings<D, P>{particles_.view()});
  }

  void advance() override {
    Run::renew_neighbours();
    const double dt = Run::choose_step(StepRates::to_come, solid_limit());
    drift_half(dt);
    deform(dt);
    break_bonds();
    evaluate();
    close_step(dt);
    solid_.let_go_of_leavers(particles_);
    if (solid_.take_loosened()) Run::renew_list();  // what is loose sees further
    Run::tick(dt);
  }

  Frame frame() const override {
    Frame frame = Run::frame();
    solid_.show(frame);
    return frame;
  }
  Ledger ledger() const override {
    Ledger ledger = Run::ledger();
    solid_.book(ledger);
    return ledger;
  }
  double bytes_per_particle() const override {
    const double n = std::max<double>(1.0, particles_.size());
    const std::size_t beside =
        solid_.bytes() + rates_.bytes() + crowd_.size() * sizeof(Crowd<D, typename P::Real>);
    return Run::bytes_per_particle() + static_cast<double>(beside) / n;
  }
  void save(Archive& archive) const override {
    Run::save(archive);
    solid_.save(archive);
  }
  void restore(const Archive& archive) override {
    solid_.restore(archive);
    Run::restore(archive);
  }

 protected:
  using Run::case_, Run::drives_, Run::list_, Run::pair_interactions_, Run::particles_, Run::time_,
      Run::timers_;

  // The stages of a step, in their order; benchmarks time them one by one.
  void drift_half(double dt) {
    const auto timer = timers_.stage("integrate");
    Run::load_drives(time_ + 0.5 * dt);
    for_each_index(particles_.size(),
                   InTurn(KeepStart<D, P>{particles_.view()},
                          DriftHalf<D, P>{particles_.view(), pointer(drives_), dt}));
  }

  void deform(double dt) {
    const auto timer = timers_.stage("solid");
    solid_.begin(particles_, dt);
    count_bonds();
  }

  void break_bonds() {
    const auto timer = timers_.stage("fracture");
    solid_.break_bonds(particles_);
  }

  void evaluate() {
    push_by_neighbours();
    push_by_bonds();
  }

  void push_by_neighbours() {
    const auto timer = timers_.stage("water and contact");
    crowd_.resize(particles_.size());
    rates_.evaluate(particles_.view(), particles_.size(), solid_.without_held(list_.view()),
                    solid_.bonds(), pointer(crowd_));
    pair_interactions_ += static_cast<double>(list_.pairs());
  }

  void push_by_bonds() {
    const auto timer = timers_.stage("solid");
    solid_.accelerate(particles_);
    count_bonds();
  }

  // Velocities, places and densities to the end of the step, which is booked; then water is shifted
  // and what has left is marked.
  void close_step(double dt) {
    const auto timer = timers_.stage("integrate");
    Run::load_drives(time_ + dt);
    const auto view = particles_.view();
    const Crowd<D, typename P::Real>* crowd = case_.numerics.shifting ? pointer(crowd_) : nullptr;
    Run::book_step(
        dt,
        InTurn(KickAndDrift<D, P>{view, pointer(drives_), dt}, TradePlaces<D, P>{view, dt},
               KeepSurroundings<D, P>{view}, CloseDensity<D, P>{view, dt},
               RegainDensity<D, P>{view, dt, lattice_.filling}),
        InTurn(ShiftParticles<D, P>{view, crowd, dt}, Run::mark_leavers()));
    solid_.end_step(dt);
  }

 private:
  void after_reorder() override { solid_.find(particles_, list_.view()); }

  void evaluate_now() const override {
    rates_.accelerate(particles_.view(), particles_.size(), solid_.without_held(list_.view()),
                      solid_.bonds());
    solid_.deform_now(particles_);
    solid_.accelerate(particles_);
    solid_.show_pressure(particles_);
  }

  void accelerate_across(const AcrossPlane<D>& across) const override {
    rates_.accelerate(particles_.view(), particles_.size(), list_.view(), solid_.bonds(), across,
                      BodyForce<D, P>{});
    solid_.deform_now(particles_);
    solid_.accelerate(particles_, across);
  }

  StepLimit solid_limit() {
    const double most = case_.time.maximum_step;
    return solid_.step_limit(case_.time.courant, most > 0.0 ? most : 1e300);
  }
  void count_bonds() {
    if (solid_.begins()) pair_interactions_ += static_cast<double>(solid_.bond_entries());
  }

  LatticeSums lattice_;
  StandardRates<D, P> rates_;
  mutable SolidPart<D, P> solid_;
  Array<Crowd<D, typename P::Real>> crowd_;
};

}  // namespace kerf
