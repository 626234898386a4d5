// SPDX-License-Identifier: Apache-2.0
#include "geometry/nearest_face.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/closed_surface.hpp"
#include "geometry/point_vectors.hpp"
#include "geometry/shapes.hpp"

namespace kerf {

namespace {

// A point of a face, and the normal of the face, of either sign, for points that lie on it.
struct Foot {
  Point point{};
  Point normal{};
};

double length(const Point& a) {
  return std::sqrt(dot(a, a));
}

// The faces of a shape of one part: the foot on each that is nearest to a point.
class Feet {
 public:
  Feet(const Point& point, double reach, int dimension, std::vector<Foot>& feet)
      : point_(point), reach_(reach), dimension_(dimension), feet_(feet) {}

  void add(const Shape& shape) {
    switch (shape.kind) {
      case Shape::Kind::box:
        return add_box(shape.box);
      case Shape::Kind::disc:
      case Shape::Kind::ring:
      case Shape::Kind::sphere:
        return add_round(shape);
      case Shape::Kind::polygon:
        return add_polygon(shape);
      case Shape::Kind::join:
      case Shape::Kind::difference:
        for (const Shape& part : shape.parts) add(part);
        return;
      case Shape::Kind::mesh:
        for (const auto& foot : shape.mesh.surface->feet(point_, reach_))
          feet_.push_back({foot.point, foot.normal});
        return;
    }
  }

 private:
  void add_box(const Box& box) {
    Point nearest = point_;
    const auto axes = static_cast<std::size_t>(dimension_);
    for (std::size_t a = 0; a < axes; ++a)
      nearest[a] = std::clamp(point_[a], box.minimum[a], box.maximum[a]);
    for (std::size_t a = 0; a < axes; ++a)
      for (const double side : {box.minimum[a], box.maximum[a]}) {
        Foot foot{nearest, {}};
        foot.point[a] = side;
        foot.normal[a] = 1.0;
        feet_.push_back(foot);
      }
  }

  void add_round(const Shape& shape) {
    const bool has_ends = dimension_ == 3 && shape.kind != Shape::Kind::sphere;
    const Point arm = sum(point_, -1.0, shape.centre);
    const double along = has_ends ? dot(arm, shape.axis) : 0.0;
    Point radial = sum(arm, -along, shape.axis);
    if (!has_ends) radial = arm;
    if (dimension_ == 2) radial[2] = 0.0;
    const double distance = length(radial);
    if (!(distance > 0.0)) return;
    const Point out = sum({}, 1.0 / distance, radial);
    const double between = has_ends ? std::clamp(along, 0.0, shape.length) : 0.0;
    Point middle = has_ends ? sum(shape.centre, between, shape.axis) : shape.centre;
    if (dimension_ == 2) middle[2] = 0.0;
    feet_.push_back({sum(middle, shape.radius, out), out});
    const bool is_ring = shape.kind == Shape::Kind::ring;
    if (is_ring) feet_.push_back({sum(middle, shape.inner_radius, out), out});
    if (!has_ends) return;
    const double within = std::clamp(distance, is_ring ? shape.inner_radius : 0.0, shape.radius);
    for (const double end : {0.0, shape.length})
      feet_.push_back({sum(sum(shape.centre, end, shape.axis), within, out), shape.axis});
  }

  void add_polygon(const Shape& shape) {
    const double low = shape.depth_minimum, high = shape.depth_maximum;
    const double z = dimension_ == 3 ? std::clamp(point_[2], low, high) : 0.0;
    for (std::size_t i = 0; i < shape.vertices.size(); ++i) {
      const auto& a = shape.vertices[i];
      const auto& b = shape.vertices[(i + 1) % shape.vertices.size()];
      const Point start{a[0], a[1], z}, edge{b[0] - a[0], b[1] - a[1], 0.0};
      const double size = length(edge);
      if (!(size > 0.0)) continue;
      const Point way{point_[0] - a[0], point_[1] - a[1], 0.0};
      const double part = std::clamp(dot(way, edge) / (size * size), 0.0, 1.0);
      feet_.push_back({sum(start, part, edge), {edge[1] / size, -edge[0] / size, 0.0}});
    }
    if (dimension_ == 3)
      for (const double end : {low, high})
        feet_.push_back({{point_[0], point_[1], end}, {0.0, 0.0, 1.0}});
  }

  Point point_;
  double reach_;
  int dimension_;
  std::vector<Foot>& feet_;
};

}  // namespace

std::optional<NearestFace> nearest_face(const Shape& shape, const std::vector<Shape>& others,
                                        const Point& point, double reach, int dimension) {
  std::vector<Foot> feet;
  Feet(point, reach, dimension, feet).add(shape);
  const auto distance = [&](const Foot& foot) { return length(sum(foot.point, -1.0, point)); };
  std::stable_sort(feet.begin(), feet.end(),
                   [&](const Foot& a, const Foot& b) { return distance(a) < distance(b); });
  const double step = 1e-3 * reach;  // beyond the tolerance of contains()
  for (const Foot& foot : feet) {
    const double depth = distance(foot);
    if (depth > reach) break;
    // Where the foot is on an edge, the way to it is not along the normal of the face.
    Point normal = foot.normal;
    const Point way = sum(foot.point, -1.0, point);
    if (depth > step) normal = sum({}, 1.0 / depth, way);
    for (const double sign : {1.0, -1.0}) {
      const Point outside = sum(foot.point, sign * step, normal);
      if (sign < 0.0 && depth > step) break;
      if (contains(shape, outside, dimension)) continue;
      if (!contains(shape, sum(foot.point, -sign * step, normal), dimension)) continue;
      const bool covered = std::any_of(others.begin(), others.end(), [&](const Shape& other) {
        return contains(other, outside, dimension);
      });
      if (!covered) return NearestFace{sum({}, sign, normal), depth};
    }
  }
  return {};
}

bool is_near_face(const Shape& shape, const Point& point, double reach, int dimension) {
  std::vector<Foot> feet;
  Feet(point, reach, dimension, feet).add(shape);
  return std::any_of(feet.begin(), feet.end(), [&](const Foot& foot) {
    return length(sum(foot.point, -1.0, point)) <= reach;
  });
}

}  // namespace kerf
