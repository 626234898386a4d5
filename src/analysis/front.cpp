// SPDX-License-Identifier: Apache-2.0
#include "analysis/front.hpp"

#include <algorithm>

namespace kerf {
namespace {

struct Drop {
  double depth;  // m, of its lower edge
  double mass;   // kg
};

// Returns the water of the first jet within a jet width of the path of the axis, the deepest first.
// A slot must be about twice as wide as its jet for the water to flow back.
std::vector<Drop> drops_near_axis(const Workpiece& workpiece, const Frame& frame) {
  std::vector<Drop> drops;
  for (std::size_t row = 0; row < frame.position.size(); ++row) {
    if (frame.source[row] != workpiece.jet_source || frame.upstream[row] != 0) continue;
    const auto x = workpiece.jet->swept(frame.position[row], frame.time);
    const double depth = workpiece.jet->depth(x);
    if (depth < -workpiece.jet->width || workpiece.jet->distance(x) > workpiece.jet->width)
      continue;
    drops.push_back({depth + frame.spacing[row] / 2.0, frame.mass[row]});
  }
  std::sort(drops.begin(), drops.end(),
            [](const Drop& a, const Drop& b) { return a.depth > b.depth; });
  return drops;
}

}  // namespace

double front_depth(const Workpiece& workpiece, const Frame& frame) {
  if (!workpiece.jet) return 0.0;
  const JetAxis& jet = *workpiece.jet;
  const auto drops = drops_near_axis(workpiece, frame);
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
