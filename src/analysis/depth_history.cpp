// SPDX-License-Identifier: Apache-2.0
#include "analysis/depth_history.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/hydrodynamic_front.hpp"
#include "machine/simulated_piece.hpp"
#include "model/case.hpp"

namespace kerf {
namespace {

// Returns a length along the traverse over that at right angles to the jet in the plane of both,
// in which the opening is measured: 1 / cos of an angle at which the jet leans in that plane.
double stretch_along_traverse(const Case& description) {
  const JetAxis jet(description.jets.back(), description.dimension);
  double along = 0.0;
  for (std::size_t a = 0; a < 3; ++a)
    along += description.machine->traverse_direction[a] * jet.along[a];
  return 1.0 / std::sqrt(std::max(1e-12, 1.0 - along * along));
}

}  // namespace

WaterEntry entry_of(const Case& description) {
  const Jet& jet = description.jets.back();
  const auto piece = std::find_if(description.bodies.begin(), description.bodies.end(),
                                  [](const Body& body) { return body.name == workpiece_name; });
  if (piece == description.bodies.end()) return {jet.speed, jet.speed, jet.spacing};
  const auto density = [&](int material) {
    return description.materials[static_cast<std::size_t>(material)].density;
  };
  return {jet.speed,
          hydrodynamic_front_speed(jet.speed, density(piece->material), density(jet.material)),
          jet.spacing};
}

DepthHistory depth_history(const Case& description, const std::vector<CutState>& history,
                           const CutSummary& summary, double thickness) {
  const WaterEntry entry = entry_of(description);
  const double stretch = stretch_along_traverse(description);
  const double contact = summary.contact_time;
  DepthHistory since;
  double deepest = 0.0, exposure = 0.0;
  for (const CutState& state : history) {
    if (state.time <= contact) continue;
    const double cut = state.cut_through ? thickness : state.cut_depth;
    deepest = std::max(deepest, std::min(state.front_depth, cut));
    exposure = std::max(exposure, entry.exposure(state.time - contact, deepest));
    if (exposure == 0.0) continue;
    since.times.push_back(exposure);
    since.depths.push_back(deepest);
    since.contacts.push_back(state.time - contact);
    since.widths.push_back(summary.cracked_ahead() ? 0.0 : stretch * state.kerf_width);
  }
  return since;
}

}  // namespace kerf
