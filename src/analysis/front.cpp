// SPDX-License-Identifier: Apache-2.0
#include "analysis/front.hpp"

#include <algorithm>

#include "geometry/cell_grid.hpp"

namespace kerf {
namespace {

struct Drop {
  double depth;  // m, of its lower edge
  double mass;   // kg
};

// Returns the water within a jet width of the path of the axis, the deepest first, with depths
// below `face`, m. A slot must be about twice as wide as its jet for the water to flow back.
std::vector<Drop> drops_near_axis(const Workpiece& workpiece, const Frame& frame, double face) {
  std::vector<Drop> drops;
  for (std::size_t row = 0; row < frame.position.size(); ++row) {
    if (!workpiece.is_jet_water(frame, row)) continue;
    const auto x = workpiece.jet->swept(frame.position[row], frame.time);
    const double depth = workpiece.jet->depth(x) - face;
    if (depth < -workpiece.jet->width || workpiece.jet->distance(x) > workpiece.jet->width)
      continue;
    drops.push_back({depth + frame.spacing[row] / 2.0, frame.mass[row]});
  }
  std::sort(drops.begin(), drops.end(),
            [](const Drop& a, const Drop& b) { return a.depth > b.depth; });
  return drops;
}

}  // namespace

double front_depth(const Workpiece& workpiece, const Frame& frame, double face) {
  if (!workpiece.jet) return 0.0;
  const JetAxis& jet = *workpiece.jet;
  const auto drops = drops_near_axis(workpiece, frame, face);
  if (drops.empty()) return 0.0;
  const double plug = workpiece.jet_density * jet.section * jet.width;
  // The bound is slightly lower, so that the result does not depend on rounding if a lattice has
  // exactly this mass.
  const double enough = (1.0 - 1e-6) * std::max(front_plug_fraction * plug,
                                                front_least_particles * drops.front().mass);
  // The window [first, next) moves upwards; it is never longer than a jet width.
  double mass = 0.0;
  std::size_t first = 0;
  for (const Drop& drop : drops) {
    mass += drop.mass;
    for (; drops[first].depth - drop.depth > jet.width; ++first) mass -= drops[first].mass;
    if (mass >= enough) return std::max(0.0, drop.depth);
  }
  return 0.0;
}

double face_depth(const Workpiece& workpiece, const Frame& frame,
                  const std::vector<std::uint32_t>& rows) {
  constexpr double share = 0.9;  // of the particles; parts that fly off are fewer
  if (!workpiece.jet) return 0.0;
  std::vector<double> moved;
  for (std::size_t slot = 0; slot < rows.size(); ++slot)
    if (is_intact(frame, rows[slot]))
      moved.push_back(workpiece.jet->depth(frame.position[rows[slot]]) -
                      workpiece.jet->depth(workpiece.position[slot]));
  if (moved.empty()) return 0.0;
  const auto last = static_cast<std::ptrdiff_t>(share * static_cast<double>(moved.size() - 1));
  std::nth_element(moved.begin(), moved.begin() + last, moved.end());
  return std::min(0.0, moved[static_cast<std::size_t>(last)]);
}

bool touches_water(const Workpiece& workpiece, const Frame& frame,
                   const std::vector<std::uint32_t>& rows) {
  // Beside a flat face a drop is at most 1.12 of the larger spacing from the nearest particle.
  constexpr double contact = 1.2;
  using Place = CellGrid<3>::Position;
  std::vector<Place> drops;
  double spacing = 0.0;  // of the water
  for (std::size_t row = 0; row < frame.position.size(); ++row) {
    if (!workpiece.is_jet_water(frame, row)) continue;
    drops.push_back(Place::from(frame.position[row]));
    spacing = std::max(spacing, static_cast<double>(frame.spacing[row]));
  }
  if (drops.empty()) return false;
  const CellGrid<3> near(drops, contact * std::max(spacing, workpiece.spacing));
  for (std::size_t slot = 0; slot < rows.size(); ++slot) {
    if (!is_intact(frame, rows[slot])) continue;
    const double reach = contact * std::max(spacing, workpiece.size[slot]);
    const Place place = Place::from(frame.position[rows[slot]]);
    bool touches = false;
    near.visit_near(place, [&](std::size_t drop) { touches |= norm(drops[drop] - place) < reach; });
    if (touches) return true;
  }
  return false;
}

double bottom_depth(const Workpiece& workpiece, const WorkpieceBody& body, const Frame& frame,
                    const std::vector<std::uint32_t>& rows) {
  std::vector<double> moved;
  for (const std::uint32_t slot : body.exit_region)
    if (is_intact(frame, rows[slot]))
      moved.push_back(workpiece.jet->depth(frame.position[rows[slot]]) -
                      workpiece.jet->depth(workpiece.position[slot]));
  if (moved.empty()) return body.bottom;
  const auto middle = moved.begin() + static_cast<std::ptrdiff_t>(moved.size() / 2);
  std::nth_element(moved.begin(), middle, moved.end());
  return body.bottom + *middle;
}

}  // namespace kerf
