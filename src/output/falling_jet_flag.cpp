// SPDX-License-Identifier: Apache-2.0
#include "output/falling_jet_flag.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geometry/jet_direction.hpp"
#include "geometry/point_vectors.hpp"
#include "geometry/water_line.hpp"
#include "model/case.hpp"
#include "output/readable.hpp"

namespace kerf {
namespace {

constexpr double little = 0.02;  // of the section, as other errors of a jet

// Returns the length of the axis up to the first body that it or the edge of the jet meets, m; else
// up to the end of the domain.
double way_of(const Case& description, const Jet& jet) {
  const WaterLine axis = axis_line(jet, jet.time_beside);
  double way = way_within(description.domain, axis, description.dimension).end;
  for (const Body& body : description.bodies) {
    way = std::min(way, way_into(body, axis, description.dimension));
    for (const WaterLine& line : lines_at_edge(jet, description.dimension))
      way = std::min(way, way_into(body, line, description.dimension));
  }
  return std::max(0.0, way);
}

const Jet* most_narrowed(const Case& description) {
  const Jet* most = nullptr;
  for (const Jet& jet : description.jets) {
    const double share = narrowing_by_gravity(description, jet);
    if (share > little && (most == nullptr || share > narrowing_by_gravity(description, *most)))
      most = &jet;
  }
  return most;
}

}  // namespace

double narrowing_by_gravity(const Case& description, const Jet& jet) {
  const double along = dot(description.gravity, jet_direction(jet));
  if (description.formulation != Formulation::standard || !(along > 0.0)) return 0.0;
  const double square = jet.speed * jet.speed;
  return 1.0 - jet.speed / std::sqrt(square + 2.0 * along * way_of(description, jet));
}

std::optional<std::string> falling_jet(const Case& description) {
  const Jet* jet = most_narrowed(description);
  if (jet == nullptr) return {};
  const double share = narrowing_by_gravity(description, *jet);
  return fmt::format(
      "gravity speeds the water of \"{}\" up from {} to {} on its way of {}, by which its section "
      "would narrow by {:.2g}%; more than {:g}% is not represented: the water keeps its width and "
      "loses density instead, and where it strikes its force holds, but its pressure is too low. "
      "Shorten the standoff or choose a faster jet, or leave out the gravity",
      jet->name, readable(jet->speed, "m/s"), readable(jet->speed / (1.0 - share), "m/s"),
      readable(way_of(description, *jet), "m"), 100.0 * share, 100.0 * little);
}

std::optional<ValidityFlag> falling_jet_flag(const Case& description) {
  const auto text = falling_jet(description);
  if (!text) return {};
  std::string sentence = *text + ".";
  sentence.front() = 'G';
  return ValidityFlag{"falling_jet", ValidityFlag::State::warning,
                      narrowing_by_gravity(description, *most_narrowed(description)), little,
                      std::move(sentence)};
}

}  // namespace kerf
