// SPDX-License-Identifier: Apache-2.0
#include "geometry/solid_region.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/shapes.hpp"
#include "model/case.hpp"

namespace kerf {
namespace {

// A convex polygon turns to one side only, and once around.
bool is_convex_polygon(const std::vector<std::array<double, 2>>& vertices) {
  const std::size_t n = vertices.size();
  double left = 0.0, right = 0.0, around = 0.0;
  for (std::size_t k = 0; k < n; ++k) {
    const auto &a = vertices[k], &b = vertices[(k + 1) % n], &c = vertices[(k + 2) % n];
    const double ux = b[0] - a[0], uy = b[1] - a[1], vx = c[0] - b[0], vy = c[1] - b[1];
    const double turn = std::atan2(ux * vy - uy * vx, ux * vx + uy * vy);
    left = std::max(left, turn);
    right = std::max(right, -turn);
    around += turn;
  }
  constexpr double rounding = 1e-9, full_turn = 6.3;  // just above 2 pi
  return std::min(left, right) < rounding && std::abs(around) < full_turn;
}

}  // namespace

bool is_convex(const Shape& shape, int dimension) {
  switch (shape.kind) {
    case Shape::Kind::box:
    case Shape::Kind::disc:
    case Shape::Kind::sphere:
      return true;
    case Shape::Kind::polygon:
      return is_convex_polygon(shape.vertices);
    case Shape::Kind::join:
    case Shape::Kind::difference:
      return shape.parts.size() == 1 && is_convex(shape.parts.front(), dimension);
    case Shape::Kind::ring:
    case Shape::Kind::mesh:
      break;
  }
  return false;
}

std::vector<SolidRegion> regions_of(const std::vector<Body>& bodies,
                                    const std::vector<std::uint16_t>& pieces, int dimension) {
  std::vector<SolidRegion> regions(bodies.size());
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    if (bodies[b].role != Role::elastic || regions[b]) continue;
    std::vector<Shape> shapes;
    for (std::size_t other = 0; other < bodies.size(); ++other)
      if (bodies[other].role == Role::elastic && pieces[other] == pieces[b])
        shapes.push_back(bodies[other].shape);
    if (shapes.size() == 1 && is_convex(shapes.front(), dimension)) continue;
    const auto region = std::make_shared<const std::vector<Shape>>(std::move(shapes));
    for (std::size_t other = b; other < bodies.size(); ++other)
      if (bodies[other].role == Role::elastic && pieces[other] == pieces[b] &&
          !is_convex(bodies[other].shape, dimension))
        regions[other] = region;
  }
  return regions;
}

bool is_within(const std::vector<Shape>& shapes, const Point& point, int dimension) {
  return std::any_of(shapes.begin(), shapes.end(),
                     [&](const Shape& shape) { return contains(shape, point, dimension); });
}

}  // namespace kerf
