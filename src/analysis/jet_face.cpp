// SPDX-License-Identifier: Apache-2.0
#include "analysis/jet_face.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include "analysis/kerf_sections.hpp"

namespace kerf {
namespace {

// A step is higher than what the slope makes of this many columns, and the roughness of a lattice.
constexpr double least_step = 1.0;

// Calls visit(offset, ends) for the columns within a distance of a place; `offset` in columns.
template <class Visit>
void visit_disc(const std::map<FaceColumn, ColumnEnds>& columns, const FaceColumn& place,
                double distance, const Visit& visit) {
  const long most = static_cast<long>(std::floor(distance));
  for (auto at = columns.lower_bound({place.first - most, std::numeric_limits<long>::min()});
       at != columns.end() && at->first.first <= place.first + most; ++at) {
    const std::array<long, 2> offset{at->first.first - place.first,
                                     at->first.second - place.second};
    if (std::hypot(static_cast<double>(offset[0]), static_cast<double>(offset[1])) <= distance)
      visit(offset, at->second);
  }
}

}  // namespace

FaceColumn face_column(const std::array<double, 2>& place, double breadth) {
  return {static_cast<long>(std::floor(place[0] / breadth)),
          static_cast<long>(std::floor(place[1] / breadth))};
}

JetFace::JetFace(std::map<FaceColumn, ColumnEnds> columns, double breadth, double reach,
                 double core)
    : columns_(std::move(columns)), breadth_(breadth), reach_(reach), core_(core) {}

// Returns the median of the slopes between all pairs of rows of columns (Theil and Sen): steps of
// the face, up and down again or of less than a third of the rows, do not change it.
double JetFace::find_slope(const FaceColumn& path, std::size_t direction) const {
  std::map<long, std::vector<double>> rows;
  visit_disc(columns_, path, reach_ / breadth_,
             [&](const std::array<long, 2>& offset, const ColumnEnds& ends) {
               rows[offset[direction]].push_back(ends.top);
             });
  std::vector<std::pair<double, double>> tops;
  for (const auto& [row, values] : rows)
    tops.push_back({static_cast<double>(row) * breadth_, median(values)});
  std::vector<double> slopes;
  for (std::size_t a = 0; a < tops.size(); ++a)
    for (std::size_t b = a + 1; b < tops.size(); ++b)
      slopes.push_back((tops[b].second - tops[a].second) / (tops[b].first - tops[a].first));
  return median(std::move(slopes));
}

std::optional<JetFace::Plane> JetFace::find_plane(const FaceColumn& path) const {
  std::vector<double> tops;
  visit_disc(columns_, path, core_ / breadth_,
             [&](const std::array<long, 2>&, const ColumnEnds& ends) { tops.push_back(ends.top); });
  if (tops.empty()) return std::nullopt;
  return Plane{median(std::move(tops)), {find_slope(path, 0), find_slope(path, 1)}};
}

double JetFace::depth_at(const std::array<double, 2>& path, const std::array<double, 2>& offset,
                         double top) const {
  const FaceColumn place = face_column(path, breadth_);
  auto known = planes_.find(place);
  if (known == planes_.end()) known = planes_.emplace(place, find_plane(place)).first;
  if (!known->second) return top;
  const auto& [depth, slope] = *known->second;
  const double face = depth + slope[0] * offset[0] + slope[1] * offset[1];
  const double step = least_step * breadth_ * (1.0 + std::abs(slope[0]) + std::abs(slope[1]));
  return face - top > step ? face : top;
}

}  // namespace kerf
