// SPDX-License-Identifier: Apache-2.0
#include "geometry/round_surface.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "geometry/point_vectors.hpp"

namespace kerf {
namespace {

// Two unit vectors at right angles to `axis` and to each other.
std::array<Point, 2> across(const Point& axis) {
  const auto a = static_cast<std::size_t>(
      std::min_element(axis.begin(), axis.end(),
                       [](double p, double q) { return std::abs(p) < std::abs(q); }) -
      axis.begin());
  Point other{};
  other[a] = 1.0;
  Point first = cross(axis, other);
  const double length = std::sqrt(dot(first, first));
  for (double& component : first) component /= length;
  return {first, cross(axis, first)};
}

// The lateral face of a circle or cylinder, which faces outwards or towards its axis.
void add_lateral(const Shape& shape, int dimension, double radius, double sign,
                 PatchedSurface& surface) {
  const double length = dimension == 3 ? shape.length : 1.0;
  const auto plane = dimension == 3 ? across(shape.axis)
                                    : std::array<Point, 2>{{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}}};
  const int n = surface.pieces(2.0 * std::numbers::pi * radius);
  const int m = dimension == 3 ? surface.pieces(length) : 1;
  const double area = 2.0 * std::numbers::pi * radius * length / n / m;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j)
      surface.add(area, [&](double u, double v) -> SurfacePoint {
        const double angle = 2.0 * std::numbers::pi * (i + u) / n;
        const Point radial = sum(sum({}, std::cos(angle), plane[0]), std::sin(angle), plane[1]);
        const Point foot = sum(shape.centre, radius, radial);
        return {dimension == 3 ? sum(foot, (j + v) / m * length, shape.axis) : foot,
                sum({}, sign, radial)};
      });
}

// A ring of both flat ends of a cylinder or tube. At the axis, where sectors meet, a ring ends just
// before it: so the corners of its patches have a side of each plane through the axis.
void add_ring(const Shape& shape, double low, double high, PatchedSurface& surface) {
  const auto plane = across(shape.axis);
  const double middle = 0.5 * (low + high);
  const int n = surface.pieces(2.0 * std::numbers::pi * middle);
  const double area = std::numbers::pi * (high * high - low * low) / n;
  for (int i = 0; i < n; ++i)
    for (const bool upper : {false, true}) {
      const auto at = [&](double radius, double v) -> SurfacePoint {
        const double angle = 2.0 * std::numbers::pi * (i + v) / n;
        const Point foot = sum(sum(shape.centre, radius * std::cos(angle), plane[0]),
                               radius * std::sin(angle), plane[1]);
        return {upper ? sum(foot, shape.length, shape.axis) : foot,
                sum({}, upper ? 1.0 : -1.0, shape.axis)};
      };
      const auto map = [&](double u, double v) {
        const double square = low * low + u * (high * high - low * low);
        return at(std::sqrt(std::max(square, 1e-12 * high * high)), v);
      };
      surface.add(area, at(middle, 0.5), map);
    }
}

}  // namespace

void add_round(const Shape& shape, int dimension, PatchedSurface& surface) {
  const bool ring = shape.kind == Shape::Kind::ring && shape.inner_radius > 0.0;
  const double inner = ring ? shape.inner_radius : 0.0;
  add_lateral(shape, dimension, shape.radius, 1.0, surface);
  if (ring) add_lateral(shape, dimension, inner, -1.0, surface);
  if (dimension == 2) return;
  const int rings = surface.pieces(shape.radius - inner);
  for (int r = 0; r < rings; ++r)
    add_ring(shape, inner + (shape.radius - inner) * r / rings,
             inner + (shape.radius - inner) * (r + 1) / rings, surface);
}

// At a pole, where meridians meet, a band ends just before it, likewise.
void add_sphere(const Shape& shape, PatchedSurface& surface) {
  const double pi = std::numbers::pi, last = 1.0 - 1e-12;
  const int bands = surface.pieces(pi * shape.radius);
  for (int b = 0; b < bands; ++b) {
    const double low = std::cos(pi * (b + 1) / bands), high = std::cos(pi * b / bands);
    const double middle = 0.5 * (low + high);
    const int n =
        surface.pieces(2.0 * pi * shape.radius * std::sqrt(std::max(0.0, 1.0 - middle * middle)));
    for (int i = 0; i < n; ++i)
      surface.add(2.0 * pi * shape.radius * shape.radius * (high - low) / n,
                  [&](double u, double v) -> SurfacePoint {
                    const double height = std::clamp(low + u * (high - low), -last, last);
                    const double reach = std::sqrt(1.0 - height * height);
                    const double angle = 2.0 * pi * (i + v) / n;
                    const Point normal{reach * std::cos(angle), reach * std::sin(angle), height};
                    return {sum(shape.centre, shape.radius, normal), normal};
                  });
  }
}

}  // namespace kerf
