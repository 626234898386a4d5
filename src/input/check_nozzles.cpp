// SPDX-License-Identifier: Apache-2.0
// Refuses nozzles that overlap: the water of both would be in one place. The water of a nozzle
// stays inside it while it does not flow, so jets that flow in turn may not share one either.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "geometry/jet_direction.hpp"
#include "geometry/nozzle.hpp"
#include "geometry/point_vectors.hpp"
#include "input/draft.hpp"
#include "input/units.hpp"
#include "model/case.hpp"

namespace kerf {

namespace {

// The region inside the nozzle of a jet, and its water at t = 0.
struct NozzleRegion {
  const Jet& jet;
  Nozzle nozzle;
  std::vector<InletParticle> water;
};

// Returns whether a place, relative to the exit, is inside the nozzle by more than `margin`.
bool is_inside(const NozzleRegion& region, const Point& place, double margin, int dimension) {
  const Jet& jet = region.jet;
  const JetAxes axes = axes_of(jet);
  const double along = dot(place, axes.along);
  if (along > 0.0 || along < -Nozzle::layers_inside * jet.spacing) return false;
  const double u = std::abs(dot(place, axes.across)), w = std::abs(dot(place, axes.sideways));
  const double half = 0.5 * jet.width - margin;
  if (dimension == 2) return u < half;
  return jet.length > 0.0 ? u < half && w < 0.5 * jet.length - margin : std::hypot(u, w) < half;
}

// Returns whether water of one nozzle is inside the other at a time, s.
bool reaches_into(const NozzleRegion& one, const NozzleRegion& other, double time, int dimension) {
  constexpr double touching = 0.25;  // spacings
  const double margin = touching * std::min(one.jet.spacing, other.jet.spacing);
  const Point from = one.nozzle.exit(), to = one.nozzle.exit(time), exit = other.nozzle.exit(time);
  return std::any_of(one.water.begin(), one.water.end(), [&](const InletParticle& particle) {
    const Point moved = sum(sum(particle.position, 1.0, to), -1.0, from);
    return is_inside(other, sum(moved, -1.0, exit), margin, dimension);
  });
}

// Returns the first time at which two nozzles overlap, s; nozzles that move apart or together are
// looked at so often that none passes through the other unseen.
std::optional<double> time_of_overlap(const NozzleRegion& one, const NozzleRegion& other,
                                      const Case& result) {
  constexpr double most = 1000.0;
  double way = 0.0;
  for (std::size_t a = 0; a < 3; ++a)
    way += (std::abs(one.jet.traverse[a]) + std::abs(other.jet.traverse[a])) * result.time.end;
  const bool together = one.jet.traverse == other.jet.traverse &&
                        one.jet.start + one.jet.dwell == other.jet.start + other.jet.dwell;
  const double narrow = 0.25 * std::min(one.jet.width, other.jet.width);
  const double steps = together ? 0.0 : std::min(most, std::ceil(way / narrow));
  for (double step = 0.0; step <= steps; step += 1.0) {
    const double time = steps > 0.0 ? result.time.end * step / steps : 0.0;
    if (reaches_into(one, other, time, result.dimension) ||
        reaches_into(other, one, time, result.dimension))
      return time;
  }
  return {};
}

}  // namespace

void check_nozzles(Draft& draft) {
  const Case& result = draft.result;
  std::vector<NozzleRegion> regions;
  if (result.jets.size() < 2) return;
  for (const Jet& jet : result.jets) {
    const auto& water = result.materials[static_cast<std::size_t>(jet.material)];
    constexpr double most_columns = 2000.0;
    regions.push_back(
        {jet,
         {coarsened(jet, result.dimension, most_columns), water.density, result.dimension},
         {}});
    regions.back().water = regions.back().nozzle.standing_water();
  }
  for (std::size_t j = 1; j < regions.size(); ++j)
    for (std::size_t i = 0; i < j; ++i) {
      const auto time = time_of_overlap(regions[i], regions[j], result);
      if (!time) continue;
      draft.reading.problems.add(
          {draft.jets[j].path + ".position",
           fmt::format("the nozzle of \"{}\" overlaps that of \"{}\"{}", result.jets[j].name,
                       result.jets[i].name,
                       *time > 0.0 ? " after " + show_quantity(*time, "s") : std::string()),
           fmt::format(
               "nozzles that are beside one another with their last {} spacings, also where "
               "they flow in turn",
               Nozzle::layers_inside),
           "Move one of the jets; for more water in one place make one jet wider or faster, for "
           "pauses give it pulses"});
    }
}

}  // namespace kerf
