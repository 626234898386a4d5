// SPDX-License-Identifier: Apache-2.0
#include "analysis/void_places.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

#include "geometry/cell_grid.hpp"

namespace kerf {
namespace {

// Spacings from a place that is empty to all solid. In a full lattice no place is farther than 0.87
// from a particle.
constexpr double least_clearance = 0.9;

using SolidColumn = std::pair<long, long>;

std::map<SolidColumn, std::vector<std::size_t>> solid_columns(
    const std::vector<std::array<double, 3>>& solids, double spacing) {
  std::map<SolidColumn, std::vector<std::size_t>> columns;
  for (std::size_t n = 0; n < solids.size(); ++n)
    columns[{static_cast<long>(std::floor(solids[n][0] / spacing)),
             static_cast<long>(std::floor(solids[n][1] / spacing))}]
        .push_back(n);
  for (auto& [column, members] : columns)
    std::sort(members.begin(), members.end(),
              [&](std::size_t a, std::size_t b) { return solids[a][2] < solids[b][2]; });
  return columns;
}

// Returns places between a solid and the next one below it in its column.
std::vector<VoidPlace> places_between(const std::vector<std::array<double, 3>>& solids,
                                      const std::vector<double>& sizes, std::size_t above,
                                      std::size_t below) {
  std::vector<VoidPlace> places;
  const double size = std::max(sizes[above], sizes[below]);
  const double length = solids[below][2] - solids[above][2];
  const double steps = std::ceil(length / size * (1.0 - 1e-6));
  for (double n = 1.0; n < steps; n += 1.0) {
    VoidPlace place{solids[above], size, above};
    for (std::size_t a = 0; a < 3; ++a)
      place.position[a] += n / steps * (solids[below][a] - solids[above][a]);
    places.push_back(place);
  }
  return places;
}

}  // namespace

std::vector<VoidPlace> find_void_places(const std::vector<std::array<double, 3>>& solids,
                                        const std::vector<double>& sizes, double spacing) {
  using Place = CellGrid<3>::Position;
  std::vector<VoidPlace> places;
  if (solids.empty()) return places;
  std::vector<Place> points;
  for (const auto& x : solids) points.push_back(Place::from(x));
  const CellGrid<3> near(points, *std::max_element(sizes.begin(), sizes.end()));
  const auto is_clear = [&](const VoidPlace& place) {
    bool clear = true;
    const Place x = Place::from(place.position);
    near.visit_near(x, [&](std::size_t n) {
      clear = clear && norm(points[n] - x) >= least_clearance * sizes[n];
    });
    return clear;
  };
  for (const auto& [column, members] : solid_columns(solids, spacing))
    for (std::size_t k = 1; k < members.size(); ++k)
      std::ranges::copy_if(places_between(solids, sizes, members[k - 1], members[k]),
                           std::back_inserter(places), is_clear);
  return places;
}

}  // namespace kerf
