// SPDX-License-Identifier: Apache-2.0
// What a run shows of itself. Nothing here changes how the run goes on.
#pragma once

#include "simulation/particle_run.hpp"
#include "simulation/snapshot.hpp"

namespace kerf {

// Rates, stresses and forces belong to the middle of the last step: work them out for now.
template <int D, class P, class Scheme>
void ParticleRun<D, P, Scheme>::refresh() const {
  if (fresh_) return;
  evaluate_now();
  fresh_ = true;
}

template <int D, class P, class Scheme>
Frame ParticleRun<D, P, Scheme>::frame() const {
  refresh();
  Frame frame = make_frame(particles_, media_, medium_origins(case_));
  frame.time = time_;
  frame.step = step_;
  return frame;
}

template <int D, class P, class Scheme>
Ledger ParticleRun<D, P, Scheme>::ledger() const {
  refresh();
  Ledger ledger = book_.state(particles_, gravity_);
  for (const Nozzle& nozzle : nozzles_) {
    ledger.jet_mass_due += nozzle.mass_due(time_);
    ledger.jet_mass_carried += nozzle.mass_due(time_) - nozzle.mass_emitted();
  }
  return ledger;
}

template <int D, class P, class Scheme>
std::vector<double> ParticleRun<D, P, Scheme>::probe_values() const {
  std::vector<double> values;
  for (const Probe& probe : case_.probes) {
    refresh();
    if (probe.kind == Probe::Kind::point) {
      probes_.sample_point(particles_, probe, values);
    } else {
      accelerate_across(AcrossPlane<D>{Place::from(probe.position), Place::from(probe.normal)});
      probes_.sum_force(particles_, values);
      fresh_ = false;  // the accelerations are those across the plane now
    }
  }
  return values;
}

template <int D, class P, class Scheme>
double ParticleRun<D, P, Scheme>::neighbours_per_particle() const {
  return particles_.size() > 0 ? static_cast<double>(list_.pairs()) / particles_.size() : 0.0;
}

template <int D, class P, class Scheme>
double ParticleRun<D, P, Scheme>::bytes_per_particle() const {
  const double n = std::max<double>(1.0, particles_.size());
  return static_cast<double>(particles_.bytes_per_particle()) +
         static_cast<double>(list_.bytes()) / n;
}

}  // namespace kerf
