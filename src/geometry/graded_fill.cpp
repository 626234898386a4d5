// SPDX-License-Identifier: Apache-2.0
#include "geometry/graded_fill.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "geometry/fill.hpp"
#include "geometry/graded_cells.hpp"
#include "geometry/shapes.hpp"

namespace kerf {

namespace {

double distance_from_box(const Box& box, const Point& position, int dimension) {
  double square = 0.0;
  for (std::size_t a = 0; a < static_cast<std::size_t>(dimension); ++a) {
    const double outside =
        std::max({box.minimum[a] - position[a], position[a] - box.maximum[a], 0.0});
    square += outside * outside;
  }
  return std::sqrt(square);
}

double distance_from_shape(const Shape& shape, const Point& position, int dimension) {
  if (shape.kind != Shape::Kind::join)
    return distance_from_box(bounding_box(shape, dimension), position, dimension);
  double least = std::numeric_limits<double>::infinity();
  for (const Shape& part : shape.parts)
    least = std::min(least, distance_from_shape(part, position, dimension));
  return least;
}

double dot(const Point& a, const Point& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// Returns the distance from the plane that a line sweeps.
double distance_from_sweep(const Grading::Line& line, const Point& position) {
  const Point &d = line.direction, &s = line.sweep;
  const Point normal{d[1] * s[2] - d[2] * s[1], d[2] * s[0] - d[0] * s[2],
                     d[0] * s[1] - d[1] * s[0]};
  Point apart{};
  for (std::size_t a = 0; a < 3; ++a) apart[a] = position[a] - line.origin[a];
  return std::max(0.0, std::abs(dot(apart, normal)) / std::sqrt(dot(normal, normal)) - line.radius);
}

double distance_from_line(const Grading::Line& line, const Point& position) {
  if (line.sweep != Point{}) return distance_from_sweep(line, position);
  double along = 0.0, square = 0.0;
  for (std::size_t a = 0; a < 3; ++a) along += (position[a] - line.origin[a]) * line.direction[a];
  for (std::size_t a = 0; a < 3; ++a) {
    const double aside = position[a] - line.origin[a] - along * line.direction[a];
    square += aside * aside;
  }
  return std::max(0.0, std::sqrt(square) - line.radius);
}

class Tree {
 public:
  Tree(const Body& body, int dimension, const Box& window)
      : grid_(body, dimension),
        dimension_(dimension),
        axes_(static_cast<std::size_t>(dimension)),
        last_(grid_.count()) {
    const Box box = lattice_box(body, dimension);
    for (std::size_t a = 0; a < axes_; ++a) {
      const auto cells = static_cast<double>(last_[a]);
      const auto cell = [&](double x) {
        return std::lround(std::clamp((x - box.minimum[a]) / body.spacing, 0.0, cells));
      };
      first_[a] = cell(window.minimum[a]);
      last_[a] = cell(window.maximum[a]);
    }
    if (dimension == 2) last_[2] = 1;
  }

  std::vector<GradedParticle> fill() {
    Cell root;
    root.level = grid_.straight().grading.levels;
    const long width = root.width();
    std::array<long, 3> first = grid_.first();
    for (std::size_t a = 0; a < axes_; ++a)
      while (first[a] + width <= first_[a]) first[a] += width;
    for (long z = first[2]; z < last_[2]; z += width)
      for (long y = first[1]; y < last_[1]; y += width)
        for (long x = first[0]; x < last_[0]; x += width) {
          root.low = {x, y, z};
          add(root);
        }
    while (split_steep_cells()) {
    }
    std::vector<GradedParticle> particles;
    for (const Cell& cell : cells_) particles.push_back({grid_.turn()(cell.position), cell.level});
    return particles;
  }

 private:
  using Cell = GradedCell;

  // Calls `visit` for the particles that the uniform body has in the cell.
  template <class Visit>
  void visit_finest(const Cell& cell, const Point& middle, const Visit& visit) const {
    LatticeVisit request;
    for (std::size_t a = 0; a < axes_; ++a) {
      request.window.minimum[a] = middle[a] - 0.5 * grid_.edge(cell);
      request.window.maximum[a] = middle[a] + 0.5 * grid_.edge(cell);
    }
    request.visit = [&](const Point& point) {
      visit(point);
      return true;
    };
    visit_particles(grid_.straight(), dimension_, request);
  }

  void add(const Cell& cell) {
    if (grid_.is_beside_the_lattice(cell)) return;
    const Point middle = grid_.centre(cell);
    if (cell.level == 0) {
      visit_finest(cell, middle, [&](const Point& point) { keep(cell, point); });
      return;
    }
    if (grid_.is_far_enough(cell, middle)) {
      long sites = 0;
      visit_finest(cell, middle, [&](const Point&) { ++sites; });
      if (sites == 0) return;
      if (sites == 1L << (cell.level * dimension_)) {
        keep(cell, middle);
        return;
      }
    }
    for (int k = 0; k < 1 << dimension_; ++k) add(grid_.part_of(cell, k));
  }

  void keep(const Cell& cell, const Point& position) {
    cells_.push_back(cell);
    cells_.back().position = position;
  }

  // Coarse cells beside fine ones, which the shape requires, are split until neighbours differ by
  // one level at most.
  bool split_steep_cells() {
    mark_levels();
    std::vector<Cell> before;
    before.swap(cells_);
    for (const Cell& cell : before) {
      if (!is_steep(cell)) {
        cells_.push_back(cell);
        continue;
      }
      for (int k = 0; k < 1 << dimension_; ++k) {  // all full
        const Cell part = grid_.part_of(cell, k);
        const Point middle = grid_.centre(part);
        if (part.level > 0)
          keep(part, middle);
        else
          visit_finest(part, middle, [&](const Point& point) { keep(part, point); });
      }
    }
    return cells_.size() > before.size();
  }

  std::size_t number(const std::array<long, 3>& x) const {
    std::size_t cell = 0;
    for (const std::size_t a : {std::size_t{2}, std::size_t{1}, std::size_t{0}})
      cell = cell * static_cast<std::size_t>(last_[a] - first_[a]) +
             static_cast<std::size_t>(x[a] - first_[a]);
    return cell;
  }
  // Calls visit(x) for the finest cells of a cell and of `margin` around it, inside the lattice.
  template <class Visit>
  void visit_room(const Cell& cell, long margin, const Visit& visit) const {
    std::array<long, 3> low{}, high{};
    for (std::size_t a = 0; a < axes_; ++a) {
      low[a] = std::max(first_[a], cell.low[a] - margin);
      high[a] = std::min(last_[a] - 1, cell.low[a] + cell.width() - 1 + margin);
    }
    std::array<long, 3> x = low;
    for (x[2] = low[2]; x[2] <= high[2]; ++x[2])
      for (x[1] = low[1]; x[1] <= high[1]; ++x[1])
        for (x[0] = low[0]; x[0] <= high[0]; ++x[0]) visit(x);
  }
  void mark_levels() {
    constexpr std::uint8_t empty = 255;
    std::size_t cells = 1;
    for (std::size_t a = 0; a < 3; ++a) cells *= static_cast<std::size_t>(last_[a] - first_[a]);
    level_at_.assign(cells, empty);
    for (const Cell& cell : cells_)
      visit_room(cell, 0, [&](const std::array<long, 3>& x) {
        level_at_[number(x)] = static_cast<std::uint8_t>(cell.level);
      });
  }
  bool is_steep(const Cell& cell) const {
    if (cell.level < 2) return false;
    bool steep = false;
    visit_room(cell, 1, [&](const std::array<long, 3>& x) {
      steep = steep || level_at_[number(x)] + 1 < cell.level;
    });
    return steep;
  }

  GradedCells grid_;
  int dimension_;
  std::size_t axes_;
  // Finest cells of the window: first_ .. last_ - 1.
  std::array<long, 3> first_{}, last_;
  std::vector<Cell> cells_;
  std::vector<std::uint8_t> level_at_;  // of each of them
};

}  // namespace

double distance_from_finest(const Grading& grading, const Point& position, int dimension) {
  if (grading.around) return distance_from_shape(*grading.around, position, dimension);
  double least = std::numeric_limits<double>::infinity();
  for (const Grading::Line& line : grading.lines)
    least = std::min(least, distance_from_line(line, position));
  return least;
}

std::vector<GradedParticle> fill_levels(const Body& body, int dimension, const Box& window) {
  if (body.grading.levels > 0) return Tree(body, dimension, window).fill();
  std::vector<GradedParticle> particles;
  LatticeVisit request;
  request.window = window;
  request.visit = [&](const Point& point) {
    particles.push_back({point, 0});
    return true;
  };
  visit_particles(body, dimension, request);
  return particles;
}

std::vector<GradedParticle> fill_levels(const Body& body, int dimension) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (body.grading.levels > 0)
    return fill_levels(body, dimension,
                       {{-infinity, -infinity, -infinity}, {infinity, infinity, infinity}});
  std::vector<GradedParticle> particles;
  for (const Point& point : fill(body, dimension)) particles.push_back({point, 0});
  return particles;
}

std::vector<std::size_t> count_levels(const Body& body, int dimension) {
  std::vector<std::size_t> counts(static_cast<std::size_t>(body.grading.levels) + 1);
  for (const GradedParticle& particle : fill_levels(body, dimension))
    ++counts[static_cast<std::size_t>(particle.level)];
  return counts;
}

double level_spacing(const Body& body, int level) {
  return std::ldexp(body.spacing, level);
}

Body at_level(const Body& body, int level) {
  Body result = body;
  result.spacing = level_spacing(body, level);
  return result;
}

}  // namespace kerf
