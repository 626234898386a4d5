// SPDX-License-Identifier: Apache-2.0
// The `standard` formulation: water by Riemann SPH, solids by total Lagrangian SPH over bonds, and
// contact between them at their current positions. `advance` is the order of a step;
// standard/follow_nozzle.hpp moves the window of a frame that travels, standard/wake_and_sleep.hpp
// lets solid sleep.
#pragma once

#include <algorithm>
#include <cmath>

#include "contact/contact_energy.hpp"
#include "fluid/density_reinitialisation.hpp"
#include "fluid/shifting.hpp"
#include "parallel/fused_kernel.hpp"
#include "simulation/particle_run.hpp"
#include "standard/pair_forces.hpp"
#include "standard/solid_part.hpp"
#include "standard/traits.hpp"
#include "standard/window_layout.hpp"
#include "time/kinetic_damping.hpp"
#include "time/reflect_at_symmetry.hpp"
#include "time/save_step_start.hpp"
#include "time/verlet.hpp"

namespace kerf {

template <int D, class P>
class Standard : public ParticleRun<D, P, StandardTraits> {
  using Run = ParticleRun<D, P, StandardTraits>;

 public:
  explicit Standard(const RunSettings& settings)
      : Run(settings),
        lattice_(lattice_sums<D, ContactPairs::Kernel<D>>(settings.smoothing_ratio)),
        rates_(Run::gravity_, Run::media_, lattice_, settings.water_scheme),
        solid_(settings, Run::media_, Run::particles_) {
    for (const Nozzle& nozzle : Run::nozzles_)
      waking_speed_ = std::max(waking_speed_, std::ldexp(nozzle.fastest(), -24));
    rates_.set_pair_correction(solid_.pair_correction());
    if (rates_.separates_fluids()) list_.sort_neighbours_by_class();
    mark_driven();
    Run::open([this] {
      rates_.record_initial_overlap(particles_.view(), particles_.owned(), list_.view());
    });
    evaluate();  // the first rates
    for_each_index(particles_.owned(), UpdateSurfaceFlags<D, P>{particles_.view()});
  }

  void advance() override {
    follow_nozzle();
    Run::inject_inflow();
    const double dt = Run::choose_step(StepRates::pending, solid_limit());
    Run::renew_neighbours(0.5 * dt);  // the pairs are summed in the middle of the step
    drift_half(dt);
    Run::update_listed_ghosts();
    deform(dt);
    break_bonds();
    evaluate();
    finalize_step(dt);
    if (time_ < settings_.relax_time) damping_.end_step(particles_);
    solid_.remove_outflow(particles_);
    if (solid_.take_detached()) Run::refresh_fractured();  // they have further neighbours
    wake_and_sleep();
    Run::tick(dt);
  }

  Frame frame() const override { return frame_with(FrameContent::everything); }
  Frame frame_of_cut() const override { return frame_with(FrameContent::cut); }
  Balance balance() const override {
    Balance balance = Run::balance();
    solid_.record_losses(balance);
    balance.dissipated_damping += damping_.dissipated();
    balance.damping_peak = damping_.peak();
    for (std::size_t a = 0; a < 3; ++a) balance.impulse_constraint[a] += damping_.impulse()[a];
    return balance;
  }
  Frame layout() const override {
    return Run::settings_.window ? make_layout(solid_.members(), Run::media_, settings_.origins)
                                 : Run::frame();
  }
  double bytes_per_particle() const override {
    const double n = std::max<double>(1.0, particles_.size());
    const std::size_t beside =
        solid_.bytes() + rates_.bytes() +
        concentration_gradient_.size() * sizeof(ConcentrationGradient<D, typename P::Real>);
    return Run::bytes_per_particle() + static_cast<double>(beside) / n;
  }
  RankLoads rank_loads(int count) const override {
    return Run::planned(
        count, [this](const std::vector<int>& rank, RankLoads& loads, PlannedMessages& messages) {
          solid_.plan(rank, loads, messages);
        });
  }
  void save(Archive& archive) const override {
    Run::save(archive);
    solid_.gather();
    solid_.save(archive);
    archive.arrays["damping"] = damping_.save();
    if (settings_.window) archive.arrays["solid/ids"] = solid_.members().id;
  }
  void restore(const Archive& archive) override {
    if (settings_.window) restore_window(archive);
    solid_.restore(archive);
    damping_.restore(find_array<double>(archive, "damping"));
    Run::restore(archive);
  }

 protected:
  using Run::settings_, Run::prescribed_motions_, Run::list_, Run::pair_interactions_,
      Run::particles_, Run::time_, Run::timers_;

  // The stages of a step, in their order; benchmarks time them one by one.
  void drift_half(double dt) {
    const auto timer = timers_.stage("integrate");
    Run::load_prescribed_motions(time_ + 0.5 * dt, time_ + dt);
    solid_.set_time(time_ + 0.5 * dt);
    for_each_index(
        particles_.owned(),
        OfAwake(particles_.view(),
                FusedKernel(SaveStepStart<D, P>{particles_.view()},
                            DriftHalf<D, P>{particles_.view(), pointer(prescribed_motions_), dt})));
  }

  void deform(double dt) {
    const auto timer = timers_.stage("solid");
    solid_.predict(particles_, dt);
    count_bonds();
  }

  void break_bonds() {
    const auto timer = timers_.stage("fracture");
    solid_.break_bonds(particles_);
    if (solid_.has_detached()) Run::update_listed_ghosts();  // they are fluid from now on
  }

  void evaluate() {
    compute_pair_forces();
    compute_bond_forces();
  }

  void compute_pair_forces() {
    const auto timer = timers_.stage("water and contact");
    concentration_gradient_.resize(particles_.owned());
    find_contacts();
    if (rates_.find_density_gradients(particles_.view(), particles_.owned(), list_.view()))
      Run::update_ghosts(rates_.density_gradients());
    rates_.evaluate(particles_.view(), particles_.owned(),
                    solid_.without_fully_bonded(list_.view()), solid_.bonds(),
                    pointer(concentration_gradient_));
    complete_at_walls(WallCompletion::of_all_rates);
    rates_.find_rigid_power(particles_.view(), particles_.owned(), list_.view());
    pair_interactions_ += static_cast<double>(list_.pairs());
  }

  void compute_bond_forces() {
    const auto timer = timers_.stage("solid");
    solid_.accelerate_by_all(particles_, pointer(particles_.start_velocity));
    count_bonds();
  }

  // Integrates velocities, positions and densities to the end of the step, which the balance adds;
  // then shifts water and marks outflow.
  void finalize_step(double dt) {
    const auto timer = timers_.stage("integrate");
    Run::load_prescribed_motions(time_ + dt, time_ + dt);
    Run::respond_at_exits(dt);
    const auto view = particles_.view();
    const ConcentrationGradient<D, typename P::Real>* concentration_gradient =
        settings_.shifting ? pointer(concentration_gradient_) : nullptr;
    Run::accumulate_step(
        dt,
        OfAwake(view, FusedKernel(KickAndDrift<D, P>{view, pointer(prescribed_motions_), dt},
                                  ReflectAtSymmetry<D, P>{view, dt}, UpdateSurfaceFlags<D, P>{view},
                                  KeepContactEnergy<D, P>{view}, FinalizeDensity<D, P>{view, dt},
                                  ContinuityLoss<D, P>{view, dt},
                                  DensityReinitialisation<D, P>{view, dt, lattice_.kernel_sum})),
        OfAwake(view, FusedKernel(ShiftParticles<D, P>{view, concentration_gradient, dt},
                                  Run::mark_outflow())));
    solid_.end_step(particles_, dt);
  }

  // Wakes what interacts with newly moving particles, and lets solid at rest fall asleep.
  void wake_and_sleep();

 private:
  Frame frame_with(FrameContent content) const {
    Frame frame = Run::frame();
    solid_.gather();
    solid_.add_columns(content, frame);
    return frame;
  }

  // Shifts the window of a frame that travels with the nozzle as often as is due.
  void follow_nozzle();
  void shift_window(std::uint64_t shifts);
  void restore_window(const Archive& archive);

  void after_reorder(const std::uint8_t* listed_anew) override {
    solid_.relink(particles_, list_.view());
    rates_.take_list(particles_.view(), particles_.owned(), list_.view(), listed_anew);
    wake_listed_anew(listed_anew);
  }
  void after_refresh() override {
    solid_.mark_fully_bonded(particles_, list_.view(), list_.listed_anew());
    rates_.take_list(particles_.view(), particles_.owned(), list_.view(), list_.listed_anew());
    wake_listed_anew(list_.listed_anew());
  }
  // The stages of sleep (standard/wake_and_sleep.hpp).
  void mark_driven();
  void wake_listed_anew(const std::uint8_t* listed_anew);
  void wake_beside_newly_reached();
  template <template <int, class> class Action>
  void spread(const Action<D, P>& action, Array<std::uint8_t>& marks);

  // Finds the contacts of solids, also of ghosts.
  void find_contacts() const {
    if (rates_.find_contacts(particles_.view(), particles_.owned(), list_.view()))
      Run::update_ghosts(particles_.solid_contact);
  }

  // Completes the forces at smooth walls, and gives solid walls the reaction.
  void complete_at_walls(WallCompletion completion) const {
    const auto view = particles_.view();
    const auto list = list_.view();
    if (!rates_.complete_at_walls(view, particles_.owned(), list, completion)) return;
    Run::update_ghosts(particles_.wall_push);
    rates_.react_at_walls(view, particles_.owned(), list);
  }

  void evaluate_current() const override {
    clear_forces_asleep();
    find_contacts();
    rates_.accelerate(particles_.view(), particles_.owned(),
                      solid_.without_fully_bonded(list_.view()), solid_.bonds());
    complete_at_walls(WallCompletion::of_accelerations);
    solid_.deform_to_current(particles_);
    solid_.set_time(time_);
    solid_.accelerate_by_all(particles_, pointer(particles_.velocity));
    solid_.show_pressure(particles_);
  }

  void accelerate_across(const AcrossPlane<D>& across) const override {
    clear_forces_asleep();
    find_contacts();
    rates_.accelerate(particles_.view(), particles_.owned(), list_.view(), solid_.bonds(), across,
                      BodyForce<D, P>{});
    solid_.deform_to_current(particles_);
    solid_.accelerate(particles_, across);
  }

  void clear_forces_asleep() const {
    if (particles_.groups.sleep)
      for_each_index(particles_.size(), ClearForcesAsleep<D, P>{particles_.view()});
  }

  StepLimit solid_limit() {
    const double most = settings_.maximum_step;
    return solid_.step_limit(most > 0.0 ? most : 1e300);
  }
  void count_bonds() {
    if (solid_.is_first_substep()) pair_interactions_ += static_cast<double>(solid_.bond_entries());
  }

  double waking_speed_ = 0.0;  // m/s (standard/sleep.hpp)
  LatticeSums lattice_;
  StandardRates<D, P> rates_;
  mutable SolidPart<D, P> solid_;
  KineticDamping<D, P> damping_;
  Array<ConcentrationGradient<D, typename P::Real>> concentration_gradient_;
};

}  // namespace kerf

#include "standard/follow_nozzle.hpp"
#include "standard/wake_and_sleep.hpp"
