// SPDX-License-Identifier: Apache-2.0
#include "geometry/graded_cells.hpp"

#include <cmath>

#include "geometry/fill.hpp"
#include "geometry/graded_fill.hpp"
#include "geometry/lattice_angle.hpp"

namespace kerf {

bool is_whole(double length, double cell) {
  return std::abs(length / cell - std::round(length / cell)) < 1e-6;
}

GradedCells::GradedCells(const Body& body, int dimension)
    : straight_(along_lattice(body)),
      grading_(body.grading),
      turn_(body.lattice_angle),
      box_(lattice_box(body, dimension)),
      dimension_(dimension),
      axes_(static_cast<std::size_t>(dimension)) {
  for (std::size_t a = 0; a < axes_; ++a)
    count_[a] = std::lround((box_.maximum[a] - box_.minimum[a]) / body.spacing);
}

std::array<long, 3> GradedCells::first() const {
  const long width = 1L << grading_.levels;
  std::array<long, 3> first{};
  for (std::size_t a = 0; a < axes_; ++a) first[a] = count_[a] % width / 2;
  for (std::size_t a = 0; a < axes_; ++a) first[a] -= first[a] > 0 ? width : 0;
  return first;
}

GradedCell GradedCells::part_of(const GradedCell& cell, int k) const {
  GradedCell part = cell;
  --part.level;
  for (std::size_t a = 0; a < axes_; ++a) part.low[a] += (k >> a & 1) * part.width();
  return part;
}

double GradedCells::edge(const GradedCell& cell) const {
  return straight_.spacing * static_cast<double>(cell.width());
}

Point GradedCells::centre(const GradedCell& cell) const {
  Point point{};
  for (std::size_t a = 0; a < axes_; ++a) {
    const double from_middle = static_cast<double>(cell.low[a]) +
                               0.5 * static_cast<double>(cell.width()) -
                               0.5 * static_cast<double>(count_[a]);
    point[a] = 0.5 * (box_.minimum[a] + box_.maximum[a]) + from_middle * straight_.spacing;
  }
  return point;
}

bool GradedCells::is_beside_the_lattice(const GradedCell& cell) const {
  for (std::size_t a = 0; a < axes_; ++a)
    if (cell.low[a] + cell.width() <= 0 || cell.low[a] >= count_[a]) return true;
  return false;
}

double GradedCells::distance(const Point& position) const {
  return distance_from_finest(grading_, turn_(position), dimension_);
}

bool GradedCells::is_far_enough(const GradedCell& cell, const Point& middle) const {
  const double half_diagonal = 0.5 * edge(cell) * std::sqrt(static_cast<double>(dimension_));
  return distance(middle) - half_diagonal >= grading_.width * cell.level;
}

}  // namespace kerf
