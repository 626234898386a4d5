// SPDX-License-Identifier: Apache-2.0
// Paths among the places of a workpiece that a cut has opened.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "analysis/cut_depth.hpp"
#include "geometry/cell_grid.hpp"

namespace kerf {

// A place of the layout, m local, and the spacing there, m.
struct OpenPlace {
  std::array<double, 3> position{};
  double size = 0.0;
};

class OpenPaths {
 public:
  explicit OpenPaths(std::vector<OpenPlace> open)
      : open_(std::move(open)),
        seen_(open_.size(), 0),
        near_(places_of(open_), longest_step(open_)) {}

  // Calls visit(n) for each place to which a path leads from the place `start`, and which was not
  // visited before. A step of a path is shorter than `open_reach` spacings.
  template <class Visit>
  void follow(std::size_t start, const Visit& visit) {
    std::vector<std::size_t> next;
    if (seen_[start] == 0) next.push_back(start);
    seen_[start] = 1;
    while (!next.empty()) {
      const std::size_t n = next.back();
      next.pop_back();
      visit(n);
      near_.visit_near(place_of(open_[n]), [&](std::size_t other) {
        if (seen_[other] != 0 || !are_close(open_[n], open_[other])) return;
        seen_[other] = 1;
        next.push_back(other);
      });
    }
  }

 private:
  using Place = CellGrid<3>::Position;

  static Place place_of(const OpenPlace& point) { return Place::from(point.position); }
  static std::vector<Place> places_of(const std::vector<OpenPlace>& open) {
    std::vector<Place> places;
    for (const OpenPlace& point : open) places.push_back(place_of(point));
    return places;
  }
  static double longest_step(const std::vector<OpenPlace>& open) {
    double longest = 0.0;
    for (const OpenPlace& point : open) longest = std::max(longest, open_reach * point.size);
    return longest;
  }
  static bool are_close(const OpenPlace& a, const OpenPlace& b) {
    return norm(place_of(a) - place_of(b)) < open_reach * std::max(a.size, b.size);
  }

  std::vector<OpenPlace> open_;
  std::vector<std::uint8_t> seen_;
  CellGrid<3> near_;
};

}  // namespace kerf
