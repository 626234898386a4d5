// SPDX-License-Identifier: Apache-2.0
#include "geometry/shapes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "geometry/closed_surface.hpp"

namespace kerf {

namespace {

constexpr double tolerance = 1e-9;  // of the size of a shape

bool between(double value, double low, double high, double slack) {
  return value >= low - slack && value <= high + slack;
}

bool in_box(const Box& box, const Point& point, int dimension) {
  for (std::size_t a = 0; a < static_cast<std::size_t>(dimension); ++a) {
    const double slack = tolerance * (box.maximum[a] - box.minimum[a]);
    if (!between(point[a], box.minimum[a], box.maximum[a], slack)) return false;
  }
  return true;
}

// For a disc, ring, cylinder, tube or sphere the distance from the centre or the axis is tested.
bool in_round(const Shape& shape, const Point& point, int dimension) {
  double along = 0.0, squared = 0.0;
  for (std::size_t a = 0; a < static_cast<std::size_t>(dimension); ++a) {
    const double difference = point[a] - shape.centre[a];
    along += difference * shape.axis[a];
    squared += difference * difference;
  }
  if (dimension == 3 && shape.kind != Shape::Kind::sphere) {
    if (!between(along, 0.0, shape.length, tolerance * shape.length)) return false;
    squared -= along * along;
  }
  const double slack = 2.0 * tolerance * shape.radius * shape.radius;
  if (squared > shape.radius * shape.radius + slack) return false;
  return shape.kind != Shape::Kind::ring ||
         squared >= shape.inner_radius * shape.inner_radius - slack;
}

double distance_to_segment(const std::array<double, 2>& a, const std::array<double, 2>& b,
                           const Point& point) {
  const double ex = b[0] - a[0], ey = b[1] - a[1];
  const double px = point[0] - a[0], py = point[1] - a[1];
  const double length_squared = ex * ex + ey * ey;
  const double along =
      length_squared > 0.0 ? std::clamp((px * ex + py * ey) / length_squared, 0.0, 1.0) : 0.0;
  return std::hypot(px - along * ex, py - along * ey);
}

// Applies the even-odd rule, including the boundary.
bool in_polygon(const Shape& shape, const Point& point, int dimension) {
  const double thickness = shape.depth_maximum - shape.depth_minimum;
  if (dimension == 3 &&
      !between(point[2], shape.depth_minimum, shape.depth_maximum, tolerance * thickness))
    return false;
  const Box box = bounding_box(shape, 2);
  const double slack =
      tolerance * std::max(box.maximum[0] - box.minimum[0], box.maximum[1] - box.minimum[1]);
  bool inside = false;
  for (std::size_t i = 0; i < shape.vertices.size(); ++i) {
    const auto& a = shape.vertices[i];
    const auto& b = shape.vertices[(i + 1) % shape.vertices.size()];
    if (distance_to_segment(a, b, point) <= slack) return true;
    if ((a[1] > point[1]) == (b[1] > point[1])) continue;
    if (point[0] < a[0] + (point[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0])) inside = !inside;
  }
  return inside;
}

// The reach of a disc of unit radius with that axis along coordinate a is sqrt(1 - axis_a^2).
Box box_of_round(const Shape& shape, int dimension) {
  Box box;
  for (std::size_t a = 0; a < static_cast<std::size_t>(dimension); ++a) {
    const bool tilted = dimension == 3 && shape.kind != Shape::Kind::sphere;
    const double share =
        tilted ? std::sqrt(std::max(0.0, 1.0 - shape.axis[a] * shape.axis[a])) : 1.0;
    const double end = tilted ? shape.centre[a] + shape.length * shape.axis[a] : shape.centre[a];
    box.minimum[a] = std::min(shape.centre[a], end) - share * shape.radius;
    box.maximum[a] = std::max(shape.centre[a], end) + share * shape.radius;
  }
  return box;
}

Box box_of_polygon(const Shape& shape, int dimension) {
  Box box;
  for (std::size_t a = 0; a < 2; ++a) {
    box.minimum[a] = std::numeric_limits<double>::infinity();
    box.maximum[a] = -std::numeric_limits<double>::infinity();
    for (const auto& vertex : shape.vertices) {
      box.minimum[a] = std::min(box.minimum[a], vertex[a]);
      box.maximum[a] = std::max(box.maximum[a], vertex[a]);
    }
  }
  if (dimension == 3) {
    box.minimum[2] = shape.depth_minimum;
    box.maximum[2] = shape.depth_maximum;
  }
  return box;
}

Box box_of_join(const Shape& shape, int dimension) {
  Box box = bounding_box(shape.parts.front(), dimension);
  for (const Shape& part : shape.parts) {
    const Box other = bounding_box(part, dimension);
    for (std::size_t a = 0; a < 3; ++a) {
      box.minimum[a] = std::min(box.minimum[a], other.minimum[a]);
      box.maximum[a] = std::max(box.maximum[a], other.maximum[a]);
    }
  }
  return box;
}

double polygon_area(const Shape& shape) {
  double twice = 0.0;
  for (std::size_t i = 0; i < shape.vertices.size(); ++i) {
    const auto& a = shape.vertices[i];
    const auto& b = shape.vertices[(i + 1) % shape.vertices.size()];
    twice += a[0] * b[1] - a[1] * b[0];
  }
  return std::abs(twice) / 2.0;
}

double box_volume(const Box& box, int dimension) {
  double volume = 1.0;
  for (std::size_t a = 0; a < static_cast<std::size_t>(dimension); ++a)
    volume *= box.maximum[a] - box.minimum[a];
  return volume;
}

double counted_volume(const Shape& shape, int dimension) {
  const Box box = bounding_box(shape, dimension);
  const int count = dimension == 2 ? 400 : 80;
  const int layers = dimension == 2 ? 1 : count;
  const auto at = [&](int index, std::size_t a) {
    return box.minimum[a] + (index + 0.5) / count * (box.maximum[a] - box.minimum[a]);
  };
  double inside = 0.0;
  // budget: nesting: three axes and a test
  for (int k = 0; k < layers; ++k)
    for (int j = 0; j < count; ++j)
      for (int i = 0; i < count; ++i)
        if (contains(shape, {at(i, 0), at(j, 1), dimension == 2 ? 0.0 : at(k, 2)}, dimension))
          inside += 1.0;
  return inside / (static_cast<double>(count) * count * layers) * box_volume(box, dimension);
}

}  // namespace

bool contains(const Shape& shape, const Point& point, int dimension) {
  const auto holds = [&](const Shape& part) { return contains(part, point, dimension); };
  switch (shape.kind) {
    case Shape::Kind::box:
      return in_box(shape.box, point, dimension);
    case Shape::Kind::disc:
    case Shape::Kind::ring:
    case Shape::Kind::sphere:
      return in_round(shape, point, dimension);
    case Shape::Kind::polygon:
      return in_polygon(shape, point, dimension);
    case Shape::Kind::join:
      return std::any_of(shape.parts.begin(), shape.parts.end(), holds);
    case Shape::Kind::difference:
      return holds(shape.parts.front()) &&
             std::none_of(shape.parts.begin() + 1, shape.parts.end(), holds);
    case Shape::Kind::mesh:
      return shape.mesh.surface->contains(point);
  }
  return false;
}

Box bounding_box(const Shape& shape, int dimension) {
  switch (shape.kind) {
    case Shape::Kind::box:
      return shape.box;
    case Shape::Kind::disc:
    case Shape::Kind::ring:
    case Shape::Kind::sphere:
      return box_of_round(shape, dimension);
    case Shape::Kind::polygon:
      return box_of_polygon(shape, dimension);
    case Shape::Kind::join:
      return box_of_join(shape, dimension);
    case Shape::Kind::difference:
      return bounding_box(shape.parts.front(), dimension);
    case Shape::Kind::mesh:
      // The surface of a mesh that could not be read is missing while other faults are looked for.
      return shape.mesh.surface ? shape.mesh.surface->box() : Box{};
  }
  return {};
}

bool is_beyond(const Faces& faces, const Box& box, const Point& point) {
  for (std::size_t a = 0; a < 3; ++a)
    if ((faces.minimum[a] && point[a] < box.minimum[a]) ||
        (faces.maximum[a] && point[a] > box.maximum[a]))
      return true;
  return false;
}

double volume_estimate(const Shape& shape, int dimension) {
  const double pi = std::numbers::pi;
  const double length = dimension == 2 ? 1.0 : shape.length;
  const double outer = shape.radius * shape.radius;
  switch (shape.kind) {
    case Shape::Kind::box:
      return box_volume(shape.box, dimension);
    case Shape::Kind::disc:
      return pi * outer * length;
    case Shape::Kind::ring:
      return pi * (outer - shape.inner_radius * shape.inner_radius) * length;
    case Shape::Kind::sphere:
      return dimension == 2 ? pi * outer : 4.0 / 3.0 * pi * outer * shape.radius;
    case Shape::Kind::polygon:
      return polygon_area(shape) *
             (dimension == 2 ? 1.0 : shape.depth_maximum - shape.depth_minimum);
    case Shape::Kind::join:
    case Shape::Kind::difference:
      return counted_volume(shape, dimension);
    case Shape::Kind::mesh:
      return shape.mesh.surface->volume();
  }
  return 0.0;
}

}  // namespace kerf
