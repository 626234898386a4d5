// SPDX-License-Identifier: Apache-2.0
#include "geometry/gauge_face.hpp"

#include <cmath>
#include <numbers>

#include "geometry/point_vectors.hpp"

namespace kerf {
namespace {

constexpr int strip_points = 16;
constexpr int rings = 4;

// Returns a unit vector at right angles to a unit vector; in the plane of x and y if that is.
Point tangent(const Point& normal) {
  Point t = cross(normal, {0.0, 0.0, 1.0});
  double length = std::hypot(t[0], t[1]);
  if (length < 0.1) {
    t = cross(normal, {1.0, 0.0, 0.0});
    length = std::hypot(t[1], t[2]);
  }
  for (double& component : t) component /= length;
  return t;
}

}  // namespace

std::vector<Point> gauge_face(const Point& centre, const Point& normal, double diameter,
                              int dimension) {
  const Point u = tangent(normal), w = cross(normal, u);
  std::vector<Point> points;
  const auto add = [&](double along_u, double along_w) {
    Point p = centre;
    for (std::size_t a = 0; a < 3; ++a) p[a] += along_u * u[a] + along_w * w[a];
    points.push_back(p);
  };
  if (dimension == 2) {
    for (int k = 0; k < strip_points; ++k) add(((k + 0.5) / strip_points - 0.5) * diameter, 0.0);
    return points;
  }
  // The ring m has an area in proportion to 2 m + 1.
  for (int m = 0; m < rings; ++m) {
    const int count = 4 * (2 * m + 1);
    const double radius = 0.5 * diameter * (m + 0.5) / rings;
    for (int k = 0; k < count; ++k) {
      const double angle = 2.0 * std::numbers::pi * (k + 0.5) / count;
      add(radius * std::cos(angle), radius * std::sin(angle));
    }
  }
  return points;
}

}  // namespace kerf
