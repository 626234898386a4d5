// SPDX-License-Identifier: Apache-2.0
#include "analysis/kerf.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/left_whole.hpp"
#include "analysis/pieces.hpp"
#include "analysis/unbroken.hpp"
#include "geometry/nozzle.hpp"
#include "model/case.hpp"

namespace kerf {
namespace {

// Returns the way (m) of the axis of the jet from a place of the path until cutting has ended
// there: half of the jet passes it too, and its last water goes down to the far face at half of its
// speed, as in a solid of its density without strength.
double unsettled_way(const KerfAxes& axes, double jet_speed, double bottom) {
  const double speed = std::hypot(axes.travel[0], axes.travel[1]);
  if (!(speed > 0.0 && jet_speed > 0.0)) return 0.0;
  return 0.5 * axes.jet.width + speed * 2.0 * bottom / jet_speed;
}

// Returns the time of the contact, or of the frame before it, s.
double begin_of_cutting(const KerfConditions& conditions, double now) {
  return std::isnan(conditions.contact_time) ? now : conditions.contact_time;
}

KerfPath find_path(const KerfAxes& axes, const KerfConditions& conditions, double now,
                   double bottom) {
  const double contact = begin_of_cutting(conditions, now);
  KerfPath path;
  for (std::size_t a = 0; a < 3; ++a) {
    path.begin[a] = axes.travel[a] * std::max(0.0, contact - conditions.moves_from);
    path.end[a] = axes.travel[a] * std::max(0.0, now - conditions.moves_from);
  }
  path.unsettled = unsettled_way(axes, conditions.jet_speed, bottom);
  return path;
}

// Returns the path in the layout of a workpiece that drifts.
KerfPath path_in_layout(KerfPath path, const KerfAxes& axes, const Workpiece& workpiece,
                        const KerfConditions& conditions, double now) {
  const KerfAxes::Vector3 drift = axes.turned(workpiece.drift);
  const double contact = begin_of_cutting(conditions, now);
  for (const std::size_t a : {KerfAxes::crosswise, KerfAxes::lengthwise}) {
    path.begin[a] -= drift[a] * contact;
    path.end[a] -= drift[a] * now;
  }
  return path;
}

// Returns the mean top of the columns within half a jet width of the axis, m; infinite without any.
double depth_of_top(const KerfMap& map, const KerfAxes& axes, const KerfPath& path) {
  double sum = 0.0, count = 0.0;
  for (std::size_t i = 0; i < map.grid.count[0]; ++i)
    for (std::size_t j = 0; j < map.grid.count[1]; ++j) {
      const double distance =
          std::hypot(map.grid.at(0, i) - path.end[0], map.grid.at(1, j) - path.end[1]);
      if (!map.column(i, j).exists || distance > axes.jet.width / 2.0) continue;
      sum += map.column(i, j).top;
      count += 1.0;
    }
  return count > 0.0 ? sum / count : std::numeric_limits<double>::infinity();
}

// Finds the edges of a layer as laid out in the section at the axis.
void find_edges(const KerfView& view, const KerfAxes& axes, const KerfPath& path,
                KerfLayer& layer) {
  const Workpiece& workpiece = view.workpiece;
  for (std::size_t slot = 0; slot < workpiece.position.size(); ++slot) {
    if (!view.holds(slot)) continue;
    const KerfAxes::Vector3 x = axes.local(workpiece.position[slot]);
    const double size = workpiece.size[slot], across = x[0] - path.end[0];
    if (workpiece.dimension == 3 && std::abs(x[1] - path.end[1]) > size) continue;
    layer.left = std::min(layer.left, across - size / 2.0);
    layer.right = std::max(layer.right, across + size / 2.0);
  }
}

void deny(KerfShape& shape) {
  shape.through = false;
  shape.through_share = 0.0;
}

// A kerf that ends on a flap which hangs in the way of the jet, and below which material is gone,
// has no widths: 0 would say that nothing is gone.
void deny_widths_on_flap(Kerf& kerf, double spacing) {
  if (kerf.shape.depth >= spacing || !kerf.of<Removal>().loses_below()) return;
  for (KerfLevel* level : {&kerf.shape.top, &kerf.shape.middle, &kerf.shape.bottom})
    level->width = std::numeric_limits<double>::quiet_NaN();
}

// Adds the verdict on a body and how far it is from being cut through.
void add_verdict(const KerfView& view, const KerfAxes& axes, const KerfPath& path,
                 const KerfConditions& conditions, KerfLayer& layer) {
  layer.verdict.body = layer.body;
  const BodyVerdict* verdict = conditions.verdict_on(layer.body);
  if (verdict == nullptr) return;
  layer.verdict = *verdict;
  if (!verdict->cut.through) deny(layer.shape);
  if (!verdict->is_in_way) return;
  if (verdict->cut.through) {
    layer.margin = conditions.share_after(verdict->time, view.frame.time);
    return;
  }
  const UnbrokenThickness thickness = measure_unbroken(view, axes, path);
  layer.unbroken = thickness.least;
  if (thickness.laid_out > 0.0) layer.margin = -thickness.unbroken / thickness.laid_out;
}

std::vector<KerfLayer> measure_layers(KerfView view, const KerfAxes& axes, const KerfPath& path,
                                      const KerfConditions& conditions) {
  const Workpiece& workpiece = view.workpiece;
  std::vector<KerfLayer> layers;
  if (workpiece.bodies.size() < 2) return layers;
  for (const WorkpieceBody& body : workpiece.bodies) {
    KerfLayer layer;
    layer.body = view.body = body.body;
    const KerfMap map = make_kerf_map(view, axes, path);
    layer.top = depth_of_top(map, axes, path);
    find_edges(view, axes, path, layer);
    layer.shape = measure_shape(map, axes, path, workpiece.axis_spacing);
    layer.shape.thickness += workpiece.below(body.body);
    for (std::size_t slot = 0; slot < workpiece.body.size(); ++slot) {
      if (!view.holds(slot)) continue;
      layer.volume += workpiece.volume[slot];
      const std::uint32_t row = view.rows[slot];
      if (row != Workpiece::none && !is_intact(view.frame, row))
        layer.fractured_mass += workpiece.mass[slot];
    }
    layer.removed_volume = removed_volume(workpiece, view.standing, body.body);
    add_verdict(view, axes, path, conditions, layer);
    layers.push_back(layer);
  }
  std::stable_sort(layers.begin(), layers.end(),
                   [](const KerfLayer& a, const KerfLayer& b) { return a.top < b.top; });
  const double apart = workpiece.axis_spacing / 2.0;  // bodies side by side do not cover each other
  for (KerfLayer& layer : layers)
    layer.is_covered = std::any_of(layers.begin(), layers.end(), [&](const KerfLayer& above) {
      return above.verdict.is_in_way && !above.verdict.cut.through && above.top + apart < layer.top;
    });
  return layers;
}

// Bodies that were pushed out of the domain stand as they were laid out.
void keep_what_left(const Workpiece& workpiece, const std::vector<BodyVerdict>& bodies,
                    std::vector<std::uint8_t>& standing) {
  for (const BodyVerdict& verdict : bodies)
    for (std::size_t slot = 0; verdict.cut.left && slot < standing.size(); ++slot)
      if (workpiece.body[slot] == verdict.body) standing[slot] = stands_as_laid_out;
}

double density_of_water(const Case& description, const Jet& jet) {
  return description.materials.at(static_cast<std::size_t>(jet.material)).density;
}

// Returns the time since contact in which the water of a jet flowed, s.
double open_time_since_contact(const Case& description, const Jet& jet, const CutSummary& summary) {
  const Nozzle nozzle(jet, density_of_water(description, jet), description.dimension);
  return nozzle.open_time(summary.last.time) - nozzle.open_time(summary.contact_time);
}

// Returns the kinetic energy of a jet and its images since contact, J (2D: J/m).
double energy_since_contact(const Case& description, const Jet& jet, const CutSummary& summary) {
  const JetAxis axis(jet, description.dimension);
  return 0.5 * images_of(axis, symmetry_images(description)) * density_of_water(description, jet) *
         axis.section * std::pow(jet.speed, 3) * open_time_since_contact(description, jet, summary);
}

}  // namespace

KerfConditions kerf_conditions(const Case& description, const CutSummary& summary) {
  KerfConditions conditions;
  conditions.contact_time = summary.contact_time;
  conditions.cut_through_time = summary.cut_through_time;
  if (description.time.end > 0.0) conditions.stated_end = description.time.end;
  conditions.front_depth = summary.last.front_depth;
  conditions.bodies = summary.bodies;
  conditions.traces = summary.traces;
  if (description.jets.empty()) return conditions;
  const Jet& jet = description.jets.front();
  conditions.traverse = jet.traverse;
  conditions.moves_from = JetAxis(jet, description.dimension).moves_from;
  conditions.jet_speed = jet.speed;
  const double since = summary.last.time - summary.contact_time;
  if (!(since > 0.0)) return conditions;
  conditions.on_time_factor = open_time_since_contact(description, jet, summary) / since;
  for (std::size_t n = 1; n < description.jets.size(); ++n)
    conditions.energy_of_others += energy_since_contact(description, description.jets[n], summary);
  return conditions;
}

Kerf measure_kerf(const Workpiece& workpiece, const Frame& part, const KerfConditions& conditions) {
  Kerf kerf;
  if (workpiece.empty()) return kerf;
  const WholeFrame whole(part, workpiece.images);
  const Frame& frame = whole.get();
  const std::vector<std::uint32_t> rows = locate(workpiece, frame);
  const Pieces pieces = find_pieces(workpiece, frame, rows);
  if (!workpiece.jet) return kerf;
  auto standing = closed_where_left(
      workpiece, find_standing(workpiece, frame, rows, pieces.in_piece), conditions.traces);
  keep_what_left(workpiece, conditions.bodies, standing);
  const KerfAxes axes(*workpiece.jet, conditions.traverse, frame.dimension);
  const KerfPath path_now = find_path(axes, conditions, frame.time, workpiece.bottom);
  const KerfPath path = path_in_layout(path_now, axes, workpiece, conditions, frame.time);
  const KerfView view{workpiece, frame, rows, standing};
  const KerfMap map = make_kerf_map(view, axes, path);
  kerf.shape = measure_shape(map, axes, path, workpiece.axis_spacing);
  const KerfView now{workpiece, frame, rows, standing, KerfPositions::current};
  kerf.opening =
      measure_shape(make_kerf_map(now, axes, path_now), axes, path_now, workpiece.axis_spacing);
  kerf.layers = measure_layers(view, axes, path, conditions);
  if (!conditions.bodies.empty() && std::isnan(conditions.cut_through_time)) {
    deny(kerf.shape);
    deny(kerf.opening);
  }
  for (KerfShape* shape : {&kerf.shape, &kerf.opening}) shape->thickness += workpiece.below(-1);
  const KerfScene scene{view, map, axes, path, kerf.shape, pieces.fragments, conditions};
  std::apply(
      [&](auto&... values) { ((values = std::decay_t<decltype(values)>::measure(scene)), ...); },
      kerf.measurements);
  deny_widths_on_flap(kerf, workpiece.axis_spacing);
  return kerf;
}

}  // namespace kerf
