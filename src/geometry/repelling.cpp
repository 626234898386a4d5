// SPDX-License-Identifier: Apache-2.0
// The repelling particles of a rigid body, eq. (43) of Shinohara et al. (2004).
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "geometry/fill.hpp"

namespace kerf {

namespace {

using Cell = std::array<long, 3>;

struct Side {
  std::size_t axis;
  double sign;
};

std::vector<Side> sides_of(RepellingLayer layer, int dimension) {
  switch (layer) {
    case RepellingLayer::left:
      return {{0, -1.0}};
    case RepellingLayer::right:
      return {{0, 1.0}};
    case RepellingLayer::bottom:
      return {{1, -1.0}};
    case RepellingLayer::top:
      return {{1, 1.0}};
    case RepellingLayer::back:
      return {{2, -1.0}};
    case RepellingLayer::front:
      return {{2, 1.0}};
    case RepellingLayer::all:
      break;
  }
  std::vector<Side> sides{{0, -1.0}, {0, 1.0}, {1, -1.0}, {1, 1.0}};
  if (dimension == 3) sides.insert(sides.end(), {{2, -1.0}, {2, 1.0}});
  return sides;
}

// Particles sorted into cells of two spacings, so that neighbours are in adjacent cells.
class CellList {
 public:
  CellList(const std::vector<Point>& particles, double size) : particles_(particles), size_(size) {
    for (std::size_t i = 0; i < particles.size(); ++i) members_[cell(particles[i])].push_back(i);
  }

  // Returns whether a near particle satisfies `matches`.
  template <class Matches>
  bool any_near(const Point& point, const Matches& matches) const {
    const Cell centre = cell(point);
    for (long index = 0; index < 27; ++index) {
      const auto found = members_.find(
          {centre[0] + index % 3 - 1, centre[1] + index / 3 % 3 - 1, centre[2] + index / 9 - 1});
      if (found == members_.end()) continue;
      const auto& list = found->second;
      if (std::any_of(list.begin(), list.end(),
                      [&](std::size_t j) { return matches(particles_[j]); }))
        return true;
    }
    return false;
  }

 private:
  Cell cell(const Point& point) const {
    return {static_cast<long>(std::floor(point[0] / size_)),
            static_cast<long>(std::floor(point[1] / size_)),
            static_cast<long>(std::floor(point[2] / size_))};
  }

  const std::vector<Point>& particles_;
  double size_;
  std::map<Cell, std::vector<std::size_t>> members_;
};

}  // namespace

std::vector<std::uint8_t> repelling_flags(const Body& body, const std::vector<Point>& particles,
                                          int dimension) {
  // A neighbour is a particle at one spacing, not across the diagonal of a square cell (1.41). It
  // is on a side if most of its distance is along that axis. Rows of a hexagonal lattice are 0.82
  // to 0.87 spacings apart, and the neighbours of the end of a row are only 0.5 to the side.
  constexpr double reach = 1.3, most = 0.6;
  const double d = body.spacing;
  const CellList cells(particles, 2.0 * d);
  const std::vector<Side> sides = sides_of(body.repelling_layer, dimension);
  std::vector<std::uint8_t> flags(particles.size(), 0);
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const Point& here = particles[i];
    const auto covered = [&](const Side& side) {
      return cells.any_near(here, [&](const Point& other) {
        double squared = 0.0;
        for (std::size_t a = 0; a < 3; ++a) squared += (other[a] - here[a]) * (other[a] - here[a]);
        return squared < reach * reach * d * d &&
               side.sign * (other[side.axis] - here[side.axis]) > most * d;
      });
    };
    if (!std::all_of(sides.begin(), sides.end(), covered)) flags[i] = 1;
  }
  return flags;
}

}  // namespace kerf
