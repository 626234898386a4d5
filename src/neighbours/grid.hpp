// SPDX-License-Identifier: Apache-2.0
// Grid divides the domain into square (cubic) cells. They are numbered row by row along x, so that
// adjacent cells in x have consecutive numbers.
#pragma once

#include <cmath>
#include <cstdint>

#include "core/vector.hpp"
#include "parallel/loops.hpp"

namespace kerf {

template <int D>
struct Grid {
  Vector<D, double> origin;
  double cell = 0.0;      // m
  double per_cell = 0.0;  // 1/m
  int cells[D];

  // `cell` grows when the table would pass `most` cells.
  static Grid covering(const Vector<D, double>& minimum, const Vector<D, double>& maximum,
                       double cell, double most) {
    Grid grid;
    double total = most + 1.0;
    for (grid.cell = cell; total > most; grid.cell *= total > most ? 1.25 : 1.0) {
      total = 1.0;
      for (int a = 0; a < D; ++a) {
        grid.cells[a] = 1 + static_cast<int>(std::min((maximum[a] - minimum[a]) / grid.cell, 1e6));
        total *= grid.cells[a];
      }
    }
    grid.origin = minimum;
    grid.per_cell = 1.0 / grid.cell;
    return grid;
  }

  KERF_FUNCTION int coordinate(double x, int a) const {
    const double c = std::floor((x - origin[a]) * per_cell);
    if (!(c > 0.0)) return 0;  // what lies outside belongs to the edge
    return c < cells[a] - 1 ? static_cast<int>(c) : cells[a] - 1;
  }
  KERF_FUNCTION Index number(const int* coordinates) const {
    Index n = static_cast<Index>(coordinates[D - 1]);
    for (int a = D - 2; a >= 0; --a) n = n * static_cast<Index>(cells[a]) + coordinates[a];
    return n;
  }
  // Sets the box of the cell of x; returns false at the edge, where cells are unbounded.
  KERF_FUNCTION bool find_box(const Vector<D, double>& x, Vector<D, double>& minimum,
                              Vector<D, double>& maximum) const {
    for (int a = 0; a < D; ++a) {
      const int c = coordinate(x[a], a);
      if (c == 0 || c == cells[a] - 1) return false;
      minimum[a] = origin[a] + cell * c;
      maximum[a] = minimum[a] + cell;
    }
    return true;
  }
  KERF_FUNCTION Index number(const Vector<D, double>& x) const {
    int coordinates[D];
    for (int a = 0; a < D; ++a) coordinates[a] = coordinate(x[a], a);
    return number(coordinates);
  }
  // Calls take(first, last) with the numbers of the cells of each row of a block of cells.
  template <class Take>
  KERF_FUNCTION void for_each_row(const int* low, const int* high, const Take& take) const {
    int row[D];
    for (int a = 0; a < D; ++a) row[a] = low[a];
    while (true) {
      const Index first = number(row);
      take(first, first + static_cast<Index>(high[0] - low[0]));
      int a = 1;
      while (a < D && row[a] == high[a]) {
        row[a] = low[a];
        ++a;
      }
      if (a >= D) break;
      ++row[a];
    }
  }
  // The same for the cells that meet a box.
  template <class Take>
  KERF_FUNCTION void for_each_row(const Vector<D, double>& minimum,
                                  const Vector<D, double>& maximum, const Take& take) const {
    int low[D], high[D];
    for (int a = 0; a < D; ++a) {
      low[a] = coordinate(minimum[a], a);
      high[a] = coordinate(maximum[a], a);
    }
    for_each_row(low, high, take);
  }
  Index count() const {
    Index total = 1;
    for (int a = 0; a < D; ++a) total *= static_cast<Index>(cells[a]);
    return total;
  }
};

}  // namespace kerf
