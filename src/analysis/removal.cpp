// SPDX-License-Identifier: Apache-2.0
#include "analysis/removal.hpp"

#include <cmath>

namespace kerf {
namespace {

// The duration and energy of the jets, and of their mirror images, since contact.
struct JetWork {
  double duration = 0.0;  // s
  double energy = 0.0;    // J (2D: J/m), kinetic
};

JetWork find_work(const KerfScene& scene) {
  const KerfConditions& conditions = scene.conditions;
  const Workpiece& workpiece = scene.view.workpiece;
  JetWork work;
  if (std::isnan(conditions.contact_time)) return work;
  work.duration = scene.view.frame.time - conditions.contact_time;
  work.energy = 0.5 * workpiece.images.jets * workpiece.jet_density * workpiece.jet->section *
                    std::pow(conditions.jet_speed, 3) * work.duration * conditions.on_time_factor +
                conditions.energy_of_others;
  return work;
}

}  // namespace

double removed_volume(const Workpiece& workpiece, const std::vector<std::uint8_t>& standing,
                      int body) {
  double sum = 0.0;
  for (std::size_t slot = 0; slot < standing.size(); ++slot)
    if (!standing[slot] && (body < 0 || workpiece.body[slot] == body))
      sum += workpiece.volume[slot];
  return sum;
}

const MetricList<Removal>& Removal::metrics() {
  static const MetricList<Removal> list{
      {"removed_volume", extensive("m3"), "removed volume",
       "Initial volume of the solid that no longer stands.", &Removal::volume},
      {"removal_rate", extensive("m3/s"), "removal rate",
       "Removed volume over the time since contact.", &Removal::rate},
      {"specific_energy", "J/m3", "specific energy",
       "Kinetic energy of the jets since contact over the removed volume.",
       &Removal::specific_energy}};
  return list;
}

Removal Removal::measure(const KerfScene& scene) {
  const JetWork work = find_work(scene);
  const double volume = removed_volume(scene.view.workpiece, scene.view.standing);
  Removal removal;
  removal.volume = volume;
  if (work.duration > 0.0) removal.rate = volume / work.duration;
  if (volume > 0.0 && work.energy > 0.0) removal.specific_energy = work.energy / volume;
  return removal;
}

}  // namespace kerf
