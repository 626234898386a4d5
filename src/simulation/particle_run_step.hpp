// SPDX-License-Identifier: Apache-2.0
// The stages of a step that formulations share: inflow, removal of outflow, neighbours, choice of
// the time step, failure, sums of the balance.
#pragma once

#include <algorithm>

#include "simulation/inflow.hpp"
#include "simulation/particle_run.hpp"
#include "simulation/populate.hpp"
#include "simulation/run_failure.hpp"

namespace kerf {

template <int D, class P, class Traits>
void ParticleRun<D, P, Traits>::renew_neighbours(double horizon) {
  const auto timer = timers_.stage("neighbours");
  // Particles outside the domain move on until the list is rebuilt: spray leaves in every other
  // step.
  if (settings_.removes_back_flow) list_is_due_ |= any_has(flag::erased);
  if (!list_is_due_) list_is_due_ = !refresh_list(horizon);
  if (list_is_due_) renew_list();
}

template <int D, class P, class Traits>
bool ParticleRun<D, P, Traits>::refresh_list(double horizon) {
  const bool have_come = next_id_ > next_listed_;
  if (!list_.holds_by_notes(horizon)) update_ghosts();
  const bool have_moved = list_.is_outdated(particles_, horizon);
  if (!have_come && !have_moved) return true;
  const auto outside = ranks::total(
      count_indices(particles_.owned(), HasFlag<D, P>{particles_.view(), flag::outside}));
  if (outside > particles() / 100) return false;  // they would be listed for nothing
  if (ranks::are_several()) return refresh_with_ghosts(horizon, have_moved);
  if (!list_.refresh(particles_, horizon, have_moved)) return false;
  next_listed_ = next_id_;
  if (have_come) exit_pressure_.find_columns(particles_, nozzles_, first_jet());
  after_refresh();
  return true;
}

// Fetches the ghosts anew: where particles have moved others are near enough to be ghosts.
template <int D, class P, class Traits>
bool ParticleRun<D, P, Traits>::refresh_with_ghosts(double horizon, bool have_moved) {
  if (!list_.mark_for_refresh(particles_, have_moved)) return false;
  list_.leave_ghosts(particles_);
  drop_ghosts();
  fetch_ghosts();
  update_ghosts(list_.moved(particles_.size()));
  list_.take_ghosts(particles_);
  note_listed();
  if (!list_.is_usable(particles_, horizon)) return false;
  note_order(list_.listed_anew());
  return true;
}

template <int D, class P, class Traits>
void ParticleRun<D, P, Traits>::list_particles() {
  fetch_ghosts();
  list_.build(particles_);
  note_listed();
}

template <int D, class P, class Traits>
void ParticleRun<D, P, Traits>::note_listed() {
  note_listed_ghosts();
  next_listed_ = next_id_;
}

template <int D, class P, class Traits>
void ParticleRun<D, P, Traits>::note_listed_ghosts() {
  if constexpr (ranks::exist)
    if (ranks::are_several()) decomposition_.take_lists(particles_, list_.view());
}

template <int D, class P, class Traits>
void ParticleRun<D, P, Traits>::update_listed_ghosts() {
  if constexpr (ranks::exist) {
    if (!ranks::are_several()) return;
    const auto timer = timers_.stage("exchange");
    decomposition_.update_listed_ghosts(particles_);
  }
}

template <int D, class P, class Traits>
void ParticleRun<D, P, Traits>::refresh_fractured() {
  const auto timer = timers_.stage("neighbours");
  update_ghosts();
  list_.refresh_fractured(particles_);
  note_listed_ghosts();
  after_refresh();
}

template <int D, class P, class Traits>
void ParticleRun<D, P, Traits>::renew_list() {
  drop_ghosts();
  remove_marked();
  rebuild_list();
  list_is_due_ = false;
  fresh_ = false;  // the particles have left their forces
}

template <int D, class P, class Traits>
bool ParticleRun<D, P, Traits>::any_has(std::uint8_t flags) const {
  return ranks::any(reduce_unordered(particles_.owned(), HasFlag<D, P>{particles_.view(), flags},
                                     false, Either{}));
}

template <int D, class P, class Traits>
void ParticleRun<D, P, Traits>::remove_marked() {
  if (!any_has(flag::outside | flag::erased)) return;
  balance_.accumulate_outflow(particles_);
  remove_outflow(particles_);
}

template <int D, class P, class Traits>
void ParticleRun<D, P, Traits>::inject_inflow() {
  emit_inflow(nozzles_, first_jet(), time_,
              [&](std::size_t medium, const std::vector<NewParticle>& newcomers) {
                for (const NewParticle& newcomer : newcomers)
                  balance_.accumulate_inflow(medium, newcomer.velocity);
                append(newcomers);
              });
}

template <int D, class P, class Traits>
void ParticleRun<D, P, Traits>::rebuild_list() {
  particles_.build_position = particles_.position;
  if (ranks::are_several()) {
    particles_.sorted_cell = list_.cell_numbers(particles_);
    distribute();
  }
  sort_particles(particles_, list_.cell_numbers(particles_));
  list_particles();
  note_order(nullptr);
}

template <int D, class P, class Traits>
void ParticleRun<D, P, Traits>::note_order(const std::uint8_t* listed_anew) {
  exit_pressure_.find_columns(particles_, nozzles_, first_jet());
  after_reorder(listed_anew);
}

// A limit of the step, and the particle that sets it, for those who do not have that.
template <int D, class P, class Traits>
struct ParticleRun<D, P, Traits>::ParticleStep {
  double dt;  // s
  Limit limit;
  std::uint32_t id = 0;
  std::uint16_t medium = 0;
  Position position{};
};

inline bool is_of_particle(const StepLimit& limit) {
  return limit.limit != Limit::end_of_run && limit.limit != Limit::maximum_step;
}

template <int D, class P, class Traits>
typename ParticleRun<D, P, Traits>::ParticleStep ParticleRun<D, P, Traits>::step_of(
    const StepLimit& limit) const {
  if (!is_of_particle(limit)) return {limit.dt, limit.limit};
  const Index i = limit.particle;
  return {limit.dt, limit.limit, particles_.id[i], particles_.source[i], particles_.position[i]};
}

// The same, where one of the ranks has the particle. If it has left, the first particle of all
// stands for it, if there is any.
template <int D, class P, class Traits>
typename ParticleRun<D, P, Traits>::ParticleStep ParticleRun<D, P, Traits>::step_at_any_rank(
    const StepLimit& limit) const {
  if (particles() == 0) return {limit.dt, limit.limit};
  if (!ranks::are_several() || !is_of_particle(limit)) return step_of(limit);
  struct Candidate {
    Index cell;  // none: at no rank
    ParticleStep step;
  };
  constexpr Index none = ~Index(0);
  const bool is_here = limit.particle < particles_.size();
  const bool has_left = !ranks::any(is_here);
  Candidate own{none, {limit.dt, limit.limit}};
  if (is_here || (has_left && particles_.owned() > 0)) {
    const Index i = is_here ? limit.particle : 0;
    const Index cell = particles_.sorted_cell[i];
    own = {has_left ? cell : Index(0), step_of({limit.dt, limit.limit, i})};
  }
  const auto first = [](const Candidate& a, const Candidate& b) {
    if (a.cell != b.cell) return a.cell < b.cell ? a : b;
    return a.step.id <= b.step.id ? a : b;
  };
  return ranks::combined(own, first).step;
}

template <int D, class P, class Traits>
double ParticleRun<D, P, Traits>::choose_step(StepRates rates, const StepLimit& other) {
  const auto timer = timers_.stage("time step");
  const double remaining = settings_.end_time - time_;
  const double longest =
      settings_.maximum_step > 0.0 ? std::min(settings_.maximum_step, remaining) : remaining;
  const ParticleStepLimit<D, P> limit{
      particles_.view(), settings_.courant, largest_compression(settings_.courant),
      runaway_speed_,    longest,           rates};
  ParticleStep own{longest, longest < remaining ? Limit::maximum_step : Limit::end_of_run};
  if (other.dt < longest) own = step_at_any_rank(other);
  const StepLimit least =
      reduce_unordered(particles_.size(), limit, StepLimit{own.dt, own.limit, 0},
                       SmallerStep{pointer(particles_.id)});
  if (least.dt < own.dt) own = step_of(least);
  const auto smaller = [](const ParticleStep& a, const ParticleStep& b) {
    return b.dt < a.dt || (b.dt == a.dt && b.id < a.id) ? b : a;
  };
  const ParticleStep chosen = ranks::combined(own, smaller);
  const bool collapsed = chosen.dt < shortest_step_ && chosen.limit != Limit::end_of_run;
  if (chosen.dt < 0.0 || collapsed) fail(chosen);
  last_step_ = {chosen.dt, limit_name(chosen.limit), chosen.id};
  return chosen.dt;
}

template <int D, class P, class Traits>
void ParticleRun<D, P, Traits>::fail(const ParticleStep& cause) const {
  RunFailure failure;
  failure.time = time_;
  failure.step = step_;
  failure.particle = cause.id;
  failure.owner = settings_.source_names[settings_.origins[cause.medium].source];
  for (int a = 0; a < D; ++a) failure.position[static_cast<std::size_t>(a)] = cause.position[a];
  failure.fault = cause.dt < 0.0;
  failure.dt = cause.dt;
  failure.cause = limit_name(cause.limit);
  failure.courant = settings_.courant;
  const auto& medium = media_[cause.medium];
  failure.never_breaks = medium.phase == Phase::solid && !medium.can_break();
  failure.repels = std::any_of(media_.begin(), media_.end(),
                               [](const auto& each) { return each.repulsion > 0; });
  report_run_failure(failure);
}

template <int D, class P, class Traits>
void ParticleRun<D, P, Traits>::load_prescribed_motions(double now, double end) {
  auto motions = settings_.motion.template between<D>(time_, now, end, nozzles_);
  std::vector<ColumnFlow> flows;
  for (std::size_t j = 0; j < nozzles_.size(); ++j) {
    const auto more = column_flows(nozzles_[j], media_[first_jet() + j], time_, now);
    flows.insert(flows.end(), more.begin(), more.end());
  }
  to_device(flows, column_flows_);
  const ColumnFlow* columns = pointer(column_flows_);
  for (std::size_t j = 0; j < nozzles_.size(); ++j) {
    motions[first_jet() + j].columns = columns;
    columns += nozzles_[j].columns();
  }
  to_device(motions, prescribed_motions_);
}

template <int D, class P, class Traits>
void ParticleRun<D, P, Traits>::respond_at_exits(double dt) {
  for (std::size_t j = 0; j < nozzles_.size(); ++j)
    if (nozzles_[j].holds_pressure())
      nozzles_[j].respond(time_ + dt, dt, exit_pressure_.of(j, particles_, nozzles_[j], gravity_));
}

template <int D, class P, class Traits>
template <class Before, class After>
void ParticleRun<D, P, Traits>::accumulate_step(double dt, const Before& before,
                                                const After& after) {
  list_.note(balance_.accumulate_step(particles_, gravity_, dt, before, after));
}

template <int D, class P, class Traits>
MarkOutflow<D, P> ParticleRun<D, P, Traits>::mark_outflow() {
  return {particles_.view(), pointer(prescribed_motions_), minimum_, maximum_};
}

template <int D, class P, class Traits>
void ParticleRun<D, P, Traits>::tick(double dt) {
  time_ = last_step_.limit == limit_name(Limit::end_of_run) ? settings_.end_time : time_ + dt;
  ++step_;
  fresh_ = false;
}

}  // namespace kerf
