// SPDX-License-Identifier: Apache-2.0
#include "geometry/particle_estimate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/random.hpp"
#include "geometry/fill.hpp"
#include "geometry/graded_cells.hpp"
#include "geometry/shapes.hpp"

namespace kerf {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double most_looked_at = 1e5;  // nodes, where a lattice is not laid out

// Returns the part of space on the counted side of the planes.
Box counted_window(const CountedSide& side) {
  Box window{{-infinity, -infinity, -infinity}, {infinity, infinity, infinity}};
  for (std::size_t a = 0; a < 3; ++a) {
    if (side.planes.minimum[a]) window.minimum[a] = side.domain.minimum[a];
    if (side.planes.maximum[a]) window.maximum[a] = side.domain.maximum[a];
  }
  return window;
}

class GradedEstimate {
 public:
  GradedEstimate(const Body& body, int dimension, const CountedSide& side)
      : grid_(body, dimension),
        body_(grid_.straight()),
        dimension_(dimension),
        axes_(static_cast<std::size_t>(dimension)),
        side_(side),
        counts_(static_cast<std::size_t>(body.grading.levels) + 1) {}

  std::vector<double> count(double budget) {
    GradedCell whole;
    whole.low = grid_.first();
    whole.level = body_.grading.levels;
    for (std::size_t a = 0; a < axes_; ++a)
      while (whole.low[a] + whole.width() < grid_.count()[a]) ++whole.level;
    constexpr double usual_depth = 10.0;  // a look descends from the largest cell to the particle
    descend(whole, budget * std::min(1.0, usual_depth / whole.level), 1.0);
    return counts_;
  }

  // Returns the particle whose cell holds a finest cell.
  std::optional<GradedParticle> particle_of(const std::array<long, 3>& finest) const {
    for (int level = body_.grading.levels; level >= 0; --level) {
      const GradedCell cell = cell_at(finest, level);
      if (level > 0 ? is_one_particle(cell) : is_site(finest))
        return GradedParticle{grid_.turn()(grid_.centre(cell)), level};
    }
    return {};
  }

 private:
  bool is_site(const std::array<long, 3>& finest) const {
    GradedCell cell;
    cell.low = finest;
    if (grid_.is_beside_the_lattice(cell)) return false;
    return contains(body_.shape, grid_.centre(cell), dimension_);
  }

  int looks() const { return dimension_ == 2 ? 9 : 27; }

  // Returns how many of the corners of the cell, the middles of its edges and faces, and its middle
  // are in the body.
  int sites_inside(const GradedCell& cell) const {
    const long reach = cell.width() - 1;
    int inside = 0;
    for (int k = 0; k < looks(); ++k) {
      std::array<long, 3> site = cell.low;
      for (std::size_t a = 0, rest = static_cast<std::size_t>(k); a < axes_; ++a, rest /= 3)
        site[a] += static_cast<long>(rest % 3) * reach / 2;
      inside += is_site(site) ? 1 : 0;
    }
    return inside;
  }
  bool is_full(const GradedCell& cell) const { return sites_inside(cell) == looks(); }

  bool is_one_particle(const GradedCell& cell) const {
    return grid_.is_far_enough(cell, grid_.centre(cell)) && is_full(cell);
  }

  // Calls visit(site) for sites around a cell, at the middles of its faces and edges and at its
  // corners, until it returns true; returns whether it did.
  template <class Visit>
  bool any_beside(const GradedCell& cell, const Visit& visit) const {
    const std::array<long, 3> beside{-1, cell.width() / 2, cell.width()};
    for (int k = 0; k < looks(); ++k) {
      std::array<long, 3> site = cell.low;
      for (std::size_t a = 0, rest = static_cast<std::size_t>(k); a < axes_; ++a, rest /= 3)
        site[a] += beside[rest % 3];
      if (visit(site)) return true;
    }
    return false;
  }
  // Returns whether cells two levels finer touch a cell.
  bool is_beside_fine(const GradedCell& cell) const {
    return cell.level >= 2 && any_beside(cell, [&](const std::array<long, 3>& site) {
             const int level = level_of(site);
             return level >= 0 && level + 1 < cell.level;
           });
  }
  int level_of(const std::array<long, 3>& site) const {
    const auto particle = particle_of(site);
    return particle ? particle->level : -1;
  }
  // Returns the cell of a level that holds a finest cell.
  GradedCell cell_at(const std::array<long, 3>& finest, int level) const {
    const std::array<long, 3> first = grid_.first();
    GradedCell cell;
    cell.level = level;
    for (std::size_t a = 0; a < axes_; ++a)
      cell.low[a] = first[a] + (((finest[a] - first[a]) >> level) << level);
    return cell;
  }

  // Returns about how many particles a cell may have. Where the surface passes through it, that is
  // finer than the distance says.
  double possible_particles(const GradedCell& cell) const {
    if (grid_.is_beside_the_lattice(cell)) return 0.0;
    double finest = 1.0;
    for (std::size_t a = 0; a < axes_; ++a)
      finest *= static_cast<double>(std::min(cell.low[a] + cell.width(), grid_.count()[a]) -
                                    std::max(cell.low[a], 0L));
    GradedCell coarser = cell;
    coarser.level = std::min(cell.level, body_.grading.levels);
    const Point middle = grid_.centre(cell);
    const double nearest = grid_.distance(middle) -
                           0.5 * grid_.edge(cell) * std::sqrt(static_cast<double>(dimension_));
    while (coarser.level > 0 && nearest < body_.grading.width * coarser.level) --coarser.level;
    double particles = std::max(1.0, std::ldexp(finest, -coarser.level * dimension_));
    const bool is_box = body_.shape.kind == Shape::Kind::box;
    if (is_box && finest == std::ldexp(1.0, cell.level * dimension_)) return particles;
    const int inside = sites_inside(cell);
    if (inside > 0 && inside < looks()) particles += 2.0 * std::pow(finest, 1.0 - 1.0 / dimension_);
    return particles;
  }

  void keep(const GradedCell& cell, double weight) {
    if (is_beyond(side_.planes, side_.domain, grid_.turn()(grid_.centre(cell)))) return;
    counts_[static_cast<std::size_t>(cell.level)] += weight;
  }

  // Counts the particles in a cell that stands for `weight` cells, by about `budget` looks.
  void descend(const GradedCell& cell, double budget, double weight) {
    if (grid_.is_beside_the_lattice(cell)) return;
    if (cell.level == 0) {
      if (is_site(cell.low)) keep(cell, weight);
      return;
    }
    if (cell.level <= body_.grading.levels && is_one_particle(cell) && !is_beside_fine(cell))
      return keep(cell, weight);
    std::array<double, 8> possible{};
    const auto parts = static_cast<std::size_t>(grid_.parts());
    for (std::size_t k = 0; k < parts; ++k)
      possible[k] = possible_particles(grid_.part_of(cell, static_cast<int>(k)));
    const double all = std::accumulate(possible.begin(), possible.end(), 0.0);
    if (!(all > 0.0)) return;
    if (budget >= static_cast<double>(parts)) {
      for (std::size_t k = 0; k < parts; ++k)
        if (possible[k] > 0.0)
          descend(grid_.part_of(cell, static_cast<int>(k)), budget * possible[k] / all, weight);
      return;
    }
    double place = all * random_number(1, looks_++);
    std::size_t chosen = 0;
    while (chosen + 1 < parts && place >= possible[chosen]) place -= possible[chosen++];
    descend(grid_.part_of(cell, static_cast<int>(chosen)), budget, weight * all / possible[chosen]);
  }

  GradedCells grid_;
  const Body& body_;  // in the axes of its lattice
  int dimension_;
  std::size_t axes_;
  const CountedSide& side_;
  std::vector<double> counts_;
  std::uint64_t looks_ = 0;
};

double count_uniform(const Body& body, int dimension, const CountedSide& side, double most) {
  double count = 0.0;
  LatticeVisit request;
  request.window = counted_window(side);
  request.visit = [&](const Point&) {
    count += 1.0;
    return true;
  };
  const double nodes = visit_sample(body, dimension, request, most);
  return nodes * count;
}

}  // namespace

double ParticleEstimate::total() const {
  return std::accumulate(levels.begin(), levels.end(), 0.0);
}

double ParticleEstimate::uniform(int dimension) const {
  double sum = 0.0;
  for (std::size_t level = 0; level < levels.size(); ++level)
    sum += std::ldexp(levels[level], static_cast<int>(level) * dimension);
  return sum;
}

ParticleEstimate estimate_particles(const Body& body, int dimension, const CountedSide& side,
                                    double most) {
  ParticleEstimate estimate;
  estimate.is_exact = lattice_nodes(body, dimension) <= most;
  if (!estimate.is_exact) most = std::min(most, most_looked_at);
  if (body.grading.levels == 0) {
    estimate.levels = {count_uniform(body, dimension, side, most)};
  } else if (estimate.is_exact) {
    estimate.levels.resize(static_cast<std::size_t>(body.grading.levels) + 1);
    for (const GradedParticle& particle : fill_levels(body, dimension))
      if (!is_beyond(side.planes, side.domain, particle.position))
        estimate.levels[static_cast<std::size_t>(particle.level)] += 1.0;
  } else {
    constexpr double tests_of_a_look = 8.0;
    estimate.levels = GradedEstimate(body, dimension, side).count(most / tests_of_a_look);
  }
  return estimate;
}

std::optional<GradedParticle> particle_at(const Body& body, int dimension, const Point& position) {
  const Box box = lattice_box(body, dimension);
  const Point node = PlaneTurn(body.lattice_angle).back(position);
  std::array<long, 3> finest{};
  for (std::size_t a = 0; a < static_cast<std::size_t>(dimension); ++a)
    finest[a] = static_cast<long>(std::floor((node[a] - box.minimum[a]) / body.spacing));
  const CountedSide everywhere;
  return GradedEstimate(body, dimension, everywhere).particle_of(finest);
}

}  // namespace kerf
