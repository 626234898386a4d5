// SPDX-License-Identifier: Apache-2.0
#include "analysis/removal.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

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

// Returns the distance of a local position from the path of the axis, m.
double distance_to_path(const KerfPath& path, const std::array<double, 3>& x) {
  const double along[] = {path.end[0] - path.begin[0], path.end[1] - path.begin[1]};
  const double from[] = {x[0] - path.begin[0], x[1] - path.begin[1]};
  const double square = along[0] * along[0] + along[1] * along[1];
  const double way = from[0] * along[0] + from[1] * along[1];
  const double part = square > 0.0 ? std::clamp(way / square, 0.0, 1.0) : 0.0;
  return std::hypot(from[0] - part * along[0], from[1] - part * along[1]);
}

// Returns the depth of a local position below the face on its line along the jet, m; none beside
// the map.
std::optional<double> depth_below_face(const KerfMap& map, const std::array<double, 3>& x) {
  std::array<std::size_t, 2> index{};
  for (std::size_t a = 0; a < 2; ++a) {
    const double sample = std::round((x[a] - map.grid.low[a]) / map.grid.step);
    if (map.grid.count[a] == 1) continue;
    if (!(sample >= 0.0 && sample < static_cast<double>(map.grid.count[a]))) return std::nullopt;
    index[a] = static_cast<std::size_t>(sample);
  }
  const KerfColumn& column = map.column(index[0], index[1]);
  return column.exists ? std::optional(x[2] - column.top) : std::nullopt;
}

// Returns the removed share of the volume in the way of the jet below the depth of the kerf.
double share_below_kerf(const KerfScene& scene) {
  const Workpiece& workpiece = scene.view.workpiece;
  double all = 0.0, removed = 0.0;
  for (std::size_t slot = 0; slot < workpiece.position.size(); ++slot) {
    const auto x = scene.axes.local(workpiece.position[slot]);
    const double size = workpiece.size[slot];
    if (distance_to_path(scene.path, x) > in_way_reach(scene.axes.jet.width, size)) continue;
    const std::optional<double> below = depth_below_face(scene.map, x);
    if (!below || *below < scene.shape.depth) continue;
    all += workpiece.volume[slot];
    if (!scene.view.standing[slot]) removed += workpiece.volume[slot];
  }
  return all > 0.0 ? removed / all : std::numeric_limits<double>::quiet_NaN();
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
       &Removal::specific_energy},
      {"removed_below", share(), "removed share of the solid below the kerf",
       "Removed volume over the initial volume of the solid in the way of the jet below the depth "
       "of the kerf.",
       &Removal::share_below}};
  return list;
}

Removal Removal::measure(const KerfScene& scene) {
  const JetWork work = find_work(scene);
  const double volume = removed_volume(scene.view.workpiece, scene.view.standing);
  Removal removal;
  removal.volume = volume;
  removal.share_below = share_below_kerf(scene);
  if (work.duration > 0.0) removal.rate = volume / work.duration;
  if (volume > 0.0 && work.energy > 0.0) removal.specific_energy = work.energy / volume;
  return removal;
}

}  // namespace kerf
