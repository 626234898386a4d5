// SPDX-License-Identifier: Apache-2.0
// The stages of a step that formulations share.
#pragma once

#include "simulation/breakdown.hpp"
#include "simulation/particle_run.hpp"
#include "simulation/populate.hpp"

namespace kerf {

template <int D, class P, class Scheme>
void ParticleRun<D, P, Scheme>::renew_neighbours() {
  const auto timer = timers_.stage("neighbours");
  let_water_in();
  // What left the domain flies on until the list is made anew: spray leaves in every other step.
  if (case_.eraser) list_is_due_ |= any_has(flag::erased);
  // Half a step more than the last one took, so that the list holds to the end of this step.
  if (!list_is_due_) list_is_due_ = list_.is_outdated(particles_, 1.5 * last_step_.dt);
  if (list_is_due_) renew_list();
}

template <int D, class P, class Scheme>
void ParticleRun<D, P, Scheme>::renew_list() {
  remove_marked();
  rebuild_list();
  list_is_due_ = false;
}

template <int D, class P, class Scheme>
bool ParticleRun<D, P, Scheme>::any_has(std::uint8_t flags) const {
  return reduce_unordered(particles_.size(), HasFlag<D, P>{particles_.view(), flags}, false,
                          Either{});
}

template <int D, class P, class Scheme>
void ParticleRun<D, P, Scheme>::remove_marked() {
  if (!any_has(flag::outside | flag::erased)) return;
  book_.book_leavers(particles_);
  remove_leavers(particles_);
}

template <int D, class P, class Scheme>
void ParticleRun<D, P, Scheme>::let_water_in() {
  for (std::size_t j = 0; j < nozzles_.size(); ++j) {
    const std::vector<InletParticle> water = nozzles_[j].emit(time_);
    if (water.empty()) continue;
    const std::size_t source = case_.bodies.size() + j;
    const auto newcomers = inlet_particles(water, nozzles_[j], source, time_);
    for (const NewParticle& newcomer : newcomers) book_.book_entry(source, newcomer.velocity);
    append(newcomers);
    list_is_due_ = true;
  }
}

template <int D, class P, class Scheme>
void ParticleRun<D, P, Scheme>::rebuild_list() {
  particles_.build_position = particles_.position;
  sort_particles(particles_, list_.cell_numbers(particles_));
  list_.build(particles_);
  after_reorder();
}

template <int D, class P, class Scheme>
double ParticleRun<D, P, Scheme>::choose_step(StepRates rates, const StepLimit& other) {
  const auto timer = timers_.stage("time step");
  const double remaining = case_.time.end - time_;
  const double longest =
      case_.time.maximum_step > 0.0 ? std::min(case_.time.maximum_step, remaining) : remaining;
  const ParticleStepLimit<D, P> limit{particles_.view(), case_.time.courant, runaway_speed_,
                                      longest, rates};
  StepLimit chosen{longest, longest < remaining ? Limit::maximum_step : Limit::end_of_run, 0};
  if (other.dt < longest) chosen = other;
  const StepLimit least = reduce_unordered(particles_.size(), limit, chosen, SmallerStep{});
  if (least.dt < chosen.dt) chosen = least;
  const bool collapsed = chosen.dt < shortest_step_ && chosen.limit != Limit::end_of_run;
  if (chosen.dt < 0.0 || collapsed) fail(chosen);
  const std::uint32_t id = particles_.size() > 0 ? particles_.id[chosen.particle] : 0u;
  last_step_ = {chosen.dt, limit_name(chosen.limit), id};
  return chosen.dt;
}

template <int D, class P, class Scheme>
void ParticleRun<D, P, Scheme>::fail(const StepLimit& cause) const {
  Breakdown breakdown;
  breakdown.time = time_;
  breakdown.step = step_;
  breakdown.particle = particles_.id[cause.particle];
  breakdown.source = medium_origins(case_)[particles_.source[cause.particle]].source;
  const Place x = particles_.position[cause.particle];
  for (int a = 0; a < D; ++a) breakdown.position[static_cast<std::size_t>(a)] = x[a];
  breakdown.fault = cause.dt < 0.0;
  breakdown.dt = cause.dt;
  breakdown.cause = limit_name(cause.limit);
  report_breakdown(case_, breakdown);
}

template <int D, class P, class Scheme>
void ParticleRun<D, P, Scheme>::load_drives(double now) {
  to_device(motion_.drives<D>(time_, now), drives_);
}

template <int D, class P, class Scheme>
template <class Before, class After>
void ParticleRun<D, P, Scheme>::book_step(double dt, const Before& before, const After& after) {
  list_.note(book_.book_step(particles_, gravity_, dt, before, after));
}

template <int D, class P, class Scheme>
MarkLeavers<D, P> ParticleRun<D, P, Scheme>::mark_leavers() {
  return {particles_.view(), pointer(drives_), minimum_, maximum_};
}

template <int D, class P, class Scheme>
void ParticleRun<D, P, Scheme>::tick(double dt) {
  time_ = last_step_.limit == limit_name(Limit::end_of_run) ? case_.time.end : time_ + dt;
  ++step_;
  fresh_ = false;
}

}  // namespace kerf
