// SPDX-License-Identifier: Apache-2.0
// The cells of a graded body (geometry/graded_fill.hpp): a quadtree (3D: octree) over the lattice
// of its finest spacing. A cell of level L is 2^L spacings wide.
#pragma once

#include <array>

#include "geometry/plane_turn.hpp"
#include "model/body.hpp"

namespace kerf {

// Returns whether a length is a whole number of cells of this edge, to a millionth of a cell.
bool is_whole(double length, double cell);

// A cell: its lowest corner in cells of the finest lattice, and the position of its particle in the
// axes of the lattice, m.
struct GradedCell {
  std::array<long, 3> low{};
  int level = 0;
  Point position{};
  long width() const { return 1L << level; }
};

// The positions of cells are in the axes of the lattice (geometry/lattice_angle.hpp).
class GradedCells {
 public:
  // The body must outlive the cells.
  GradedCells(const Body& body, int dimension);

  // Returns the body in the axes of the lattice.
  const Body& straight() const { return straight_; }
  // Turns a position of a cell into the axes of the case.
  const PlaneTurn& turn() const { return turn_; }

  // Returns the number of finest cells along each axis; 0 along z in 2D.
  const std::array<long, 3>& count() const { return count_; }
  int parts() const { return 1 << dimension_; }

  // Returns the lowest corner of the coarsest cells. The remainder of the division into them is
  // split between both ends, so that a symmetric body has a symmetric layout if possible.
  std::array<long, 3> first() const;
  GradedCell part_of(const GradedCell& cell, int k) const;
  double edge(const GradedCell& cell) const;  // m
  Point centre(const GradedCell& cell) const;
  bool is_beside_the_lattice(const GradedCell& cell) const;
  // Returns the distance of a position from the region of finest resolution, m; 0 inside it.
  double distance(const Point& position) const;
  // Returns whether a cell is far enough from the region of finest resolution for its level. The
  // nearest point of the cell is decisive, so that neighbours differ by one level at most.
  bool is_far_enough(const GradedCell& cell, const Point& middle) const;

 private:
  Body straight_;
  const Grading& grading_;  // in the axes of the case
  PlaneTurn turn_;
  Box box_;
  int dimension_;
  std::size_t axes_;
  std::array<long, 3> count_{};
};

}  // namespace kerf
