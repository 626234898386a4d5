// SPDX-License-Identifier: Apache-2.0
// MotionBounds are bounds of the displacements of some particles since a list was built.
#pragma once

#include <cmath>
#include <limits>

#include "core/host_device.hpp"
#include "core/vector.hpp"

namespace kerf {

template <int D>
struct MotionBounds {
  Vector<D, double> least, most;  // m, of each component of a displacement
  double farthest = 0.0;          // m, of its length

  KERF_FUNCTION static MotionBounds none() {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return {Vector<D, double>::filled(infinity), Vector<D, double>::filled(-infinity), 0.0};
  }
  KERF_FUNCTION static MotionBounds at_rest() {
    return {Vector<D, double>::zero(), Vector<D, double>::zero(), 0.0};
  }

  KERF_FUNCTION void include(const MotionBounds& other) {
    for (int a = 0; a < D; ++a) {
      least[a] = other.least[a] < least[a] ? other.least[a] : least[a];
      most[a] = larger(most[a], other.most[a]);
    }
    farthest = larger(farthest, other.farthest);
  }
  // Includes the mirror images in a plane across an axis.
  KERF_FUNCTION void include_mirrored(int axis) {
    const double largest = larger(-least[axis], most[axis]);
    least[axis] = -largest;
    most[axis] = largest;
  }

  // Returns a bound of the relative displacement of a particle of the one and a particle of the
  // other, m; 0 where one of them has no particles.
  KERF_FUNCTION double relative(const MotionBounds& other) const {
    double square = 0.0;
    for (int a = 0; a < D; ++a) {
      const double widest = larger(most[a] - other.least[a], other.most[a] - least[a]);
      if (!(widest > 0.0)) continue;
      square += widest * widest;
    }
    const double both = farthest + other.farthest;
    return square < both * both ? std::sqrt(square) : both;
  }

 private:
  KERF_FUNCTION static double larger(double a, double b) { return a < b ? b : a; }
};

// For reductions in any order.
struct UniteBounds {
  template <int D>
  KERF_FUNCTION MotionBounds<D> operator()(MotionBounds<D> a, const MotionBounds<D>& b) const {
    a.include(b);
    return a;
  }
};

}  // namespace kerf
