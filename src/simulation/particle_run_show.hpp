// SPDX-License-Identifier: Apache-2.0
// The output of a run, which does not change its state.
#pragma once

#include "simulation/particle_run.hpp"
#include "simulation/particle_spans.hpp"
#include "simulation/snapshot.hpp"

namespace kerf {

// Rates, stresses and forces are those of the middle of the last step: evaluates them at its end.
template <int D, class P, class Traits>
void ParticleRun<D, P, Traits>::refresh() const {
  if (fresh_) return;
  update_ghosts();
  evaluate_current();
  fresh_ = true;
}

template <int D, class P, class Traits>
Frame ParticleRun<D, P, Traits>::frame() const {
  refresh();
  Frame frame = with_all_particles(
      [this](const auto& all) { return make_frame(all, media_, settings_.origins); });
  frame.time = time_;
  frame.step = step_;
  return frame;
}

template <int D, class P, class Traits>
std::vector<FieldSpan> ParticleRun<D, P, Traits>::fields() const {
  if (ranks::are_several()) return {};  // no rank has all of them
  refresh();
  return field_spans(particles_);
}

template <int D, class P, class Traits>
Balance ParticleRun<D, P, Traits>::balance() const {
  refresh();
  Balance balance = balance_.state(particles_, gravity_);
  for (const Nozzle& nozzle : nozzles_) {
    balance.jet_mass_due += nozzle.mass_due(time_);
    balance.jet_mass_carried += nozzle.mass_due(time_) - nozzle.mass_emitted();
    balance.jet_mass_held_back += nozzle.mass_held_back(time_);
  }
  return balance;
}

template <int D, class P, class Traits>
std::vector<double> ParticleRun<D, P, Traits>::probe_values() const {
  std::vector<double> values;
  for (const RunProbe& probe : settings_.probes) {
    refresh();
    if (!probe.is_plane) {
      probes_.sample_mean(particles_, probe.points, values);
    } else {
      update_ghosts();
      accelerate_across(
          AcrossPlane<D>{Position::from(probe.position), Position::from(probe.normal)});
      probes_.sum_force(particles_, values);
      fresh_ = false;  // the accelerations are those across the plane
    }
  }
  return values;
}

template <int D, class P, class Traits>
double ParticleRun<D, P, Traits>::neighbours_per_particle() const {
  const auto n = static_cast<double>(particles());
  return n > 0.0 ? static_cast<double>(ranks::total(list_.pairs())) / n : 0.0;
}

template <int D, class P, class Traits>
double ParticleRun<D, P, Traits>::bytes_per_particle() const {
  const double n = std::max<double>(1.0, static_cast<double>(particles()));
  return static_cast<double>(particles_.bytes_per_particle()) +
         static_cast<double>(
             ranks::total(list_.bytes() + particles_.sum_groups.bytes() + balance_.bytes())) /
             n;
}

template <int D, class P, class Traits>
template <class AddMore>
RankLoads ParticleRun<D, P, Traits>::planned([[maybe_unused]] int count,
                                             [[maybe_unused]] const AddMore& add_more) const {
  RankLoads loads;
  if constexpr (ranks::exist) {
    loads.of.resize(static_cast<std::size_t>(count));
    loads.waits = StepWaits::of_particles();
    PlannedMessages messages(loads.of);
    const PlannedParticles<D, P> particles(particles_, list_.grids(), count);
    particles.add_to(loads.of, messages, list_.view());
    add_more(particles.ranks(), loads, messages);
    messages.count_partners();
  }
  return loads;
}

}  // namespace kerf
