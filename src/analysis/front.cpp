// SPDX-License-Identifier: Apache-2.0
#include "analysis/front.hpp"

#include <algorithm>
#include <iterator>

#include "geometry/cell_grid.hpp"

namespace kerf {
namespace {

struct Drop {
  double depth;  // m, of its lower edge
  double mass;   // kg
};

bool is_water_of(WaterOf jets, const Workpiece& workpiece, const Frame& frame, std::size_t row) {
  return jets == WaterOf::all_jets ? workpiece.is_jet_water(frame, row)
                                   : workpiece.is_water_of_jet(frame, row);
}

// Returns the rows of the intact solid of the workpiece; without one, of all solid.
std::vector<std::uint32_t> intact_rows(const Frame& frame, const std::vector<std::uint32_t>& rows) {
  std::vector<std::uint32_t> intact;
  if (rows.empty()) {
    for (std::uint32_t row = 0; row < frame.position.size(); ++row)
      if (is_intact(frame, row)) intact.push_back(row);
    return intact;
  }
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(intact),
               [&](std::uint32_t row) { return is_intact(frame, row); });
  return intact;
}

// Returns the water within a jet width of the path of the axis, the deepest first, with depths
// below `face`, m. A slot must be about twice as wide as its jet for the water to flow back.
std::vector<Drop> drops_near_axis(const Workpiece& workpiece, const Frame& frame, double face,
                                  WaterOf jets) {
  std::vector<Drop> drops;
  for (std::size_t row = 0; row < frame.position.size(); ++row) {
    if (!is_water_of(jets, workpiece, frame, row)) continue;
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

double front_depth(const Workpiece& workpiece, const Frame& frame, double face, WaterOf jets) {
  if (!workpiece.jet) return 0.0;
  const JetAxis& jet = *workpiece.jet;
  const auto drops = drops_near_axis(workpiece, frame, face, jets);
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
                   const std::vector<std::uint32_t>& rows, WaterOf jets) {
  // Beside a flat face a drop is at most 1.12 of the larger spacing from the nearest particle.
  constexpr double contact = 1.2;
  using Place = CellGrid<3>::Position;
  std::vector<Place> drops;
  double spacing = 0.0;  // of the water
  for (std::size_t row = 0; row < frame.position.size(); ++row) {
    if (!is_water_of(jets, workpiece, frame, row)) continue;
    drops.push_back(Place::from(frame.position[row]));
    spacing = std::max(spacing, static_cast<double>(frame.spacing[row]));
  }
  if (drops.empty()) return false;
  const auto solid = intact_rows(frame, rows);
  double coarsest = spacing;
  for (const std::uint32_t row : solid)
    coarsest = std::max(coarsest, static_cast<double>(frame.spacing[row]));
  const CellGrid<3> near(drops, contact * coarsest);
  for (const std::uint32_t row : solid) {
    const double reach = contact * std::max(spacing, static_cast<double>(frame.spacing[row]));
    const Place place = Place::from(frame.position[row]);
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
