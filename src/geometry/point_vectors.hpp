// SPDX-License-Identifier: Apache-2.0
// Points as vectors: their products and sums, and vectors of D components made of them.
#pragma once

#include <cmath>

#include "core/vector.hpp"
#include "model/point.hpp"

namespace kerf {

inline double dot(const Point& a, const Point& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// Returns a + factor b.
inline Point sum(const Point& a, double factor, const Point& b) {
  return {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]};
}

// Returns the first D coordinates of a point.
template <int D>
Vector<D, double> vector_of(const Point& point) {
  Vector<D, double> x;
  for (int a = 0; a < D; ++a) x[a] = point[static_cast<std::size_t>(a)];
  return x;
}

// Returns the point with these coordinates; in 2D its z is 0.
template <int D>
Point point_of(const Vector<D, double>& x) {
  Point point{};
  for (int a = 0; a < D; ++a) point[static_cast<std::size_t>(a)] = x[a];
  return point;
}

// Returns the distance of two points in the plane of x and y.
inline double plane_distance(const Point& a, const Point& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1]);
}

}  // namespace kerf
