// SPDX-License-Identifier: Apache-2.0
#include "geometry/surface_elements.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/closed_surface.hpp"
#include "geometry/point_vectors.hpp"
#include "geometry/shapes.hpp"

namespace kerf {
namespace {

using Elements = std::vector<SurfaceElement>;

double length_of(const Point& a) {
  return std::hypot(a[0], a[1], a[2]);
}
int pieces(double length, double size) {
  const double rounding = 1e-9;  // a length of n sizes is n elements
  return std::max(1, static_cast<int>(std::ceil(length / size - rounding)));
}

// A parallelogram from `corner`; in 2D `second` has no length and the element is a segment.
void add_face(const Point& corner, const Point& first, const Point& second, const Point& normal,
              double size, Elements& elements) {
  const double length = length_of(first), width = length_of(second);
  const int n = pieces(length, size), m = pieces(width, size);
  const double area = (width > 0.0 ? length_of(cross(first, second)) : length) / n / m;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j)
      elements.push_back(
          {sum(sum(corner, (i + 0.5) / n, first), (j + 0.5) / m, second), normal, area});
}

void add_box(const Box& box, int dimension, double size, Elements& elements) {
  const auto edge = [&](std::size_t axis) {
    Point e{};
    e[axis] = box.maximum[axis] - box.minimum[axis];
    return e;
  };
  for (std::size_t a = 0; a < static_cast<std::size_t>(dimension); ++a) {
    const std::size_t b = (a + 1) % static_cast<std::size_t>(dimension), c = (a + 2) % 3;
    const Point second = dimension == 3 ? edge(c) : Point{};
    for (const bool upper : {false, true}) {
      Point corner = box.minimum, normal{};
      if (dimension == 2) corner[2] = 0.0;
      if (upper) corner[a] = box.maximum[a];
      normal[a] = upper ? 1.0 : -1.0;
      add_face(corner, edge(b), second, normal, size, elements);
    }
  }
}

// Two unit vectors at right angles to `axis` and to each other.
std::array<Point, 2> across(const Point& axis) {
  const auto a = static_cast<std::size_t>(
      std::min_element(axis.begin(), axis.end(),
                       [](double p, double q) { return std::abs(p) < std::abs(q); }) -
      axis.begin());
  Point other{};
  other[a] = 1.0;
  Point first = cross(axis, other);
  const double length = length_of(first);
  for (double& component : first) component /= length;
  return {first, cross(axis, first)};
}

// The lateral face of a circle or cylinder, which faces outwards or towards its axis.
void add_lateral(const Shape& shape, int dimension, double radius, double sign, double size,
                 Elements& elements) {
  const double length = dimension == 3 ? shape.length : 1.0;
  const auto plane = dimension == 3 ? across(shape.axis)
                                    : std::array<Point, 2>{{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}}};
  const int n = pieces(2.0 * std::numbers::pi * radius, size);
  const int m = dimension == 3 ? pieces(length, size) : 1;
  const double area = 2.0 * std::numbers::pi * radius * length / n / m;
  for (int i = 0; i < n; ++i) {
    const double angle = 2.0 * std::numbers::pi * (i + 0.5) / n;
    const Point radial = sum(sum({}, std::cos(angle), plane[0]), std::sin(angle), plane[1]);
    const Point normal = sum({}, sign, radial), foot = sum(shape.centre, radius, radial);
    for (int j = 0; j < m; ++j)
      elements.push_back(
          {dimension == 3 ? sum(foot, (j + 0.5) / m * length, shape.axis) : foot, normal, area});
  }
}

// The flat ends of a cylinder or tube, in rings.
void add_ends(const Shape& shape, double inner, double size, Elements& elements) {
  const auto plane = across(shape.axis);
  const int rings = pieces(shape.radius - inner, size);
  for (int r = 0; r < rings; ++r) {
    const double low = inner + (shape.radius - inner) * r / rings;
    const double high = inner + (shape.radius - inner) * (r + 1) / rings;
    const double middle = 0.5 * (low + high);
    const int n = pieces(2.0 * std::numbers::pi * middle, size);
    const double area = std::numbers::pi * (high * high - low * low) / n;
    for (int i = 0; i < n; ++i) {
      const double angle = 2.0 * std::numbers::pi * (i + 0.5) / n;
      const Point foot = sum(sum(shape.centre, middle * std::cos(angle), plane[0]),
                             middle * std::sin(angle), plane[1]);
      elements.push_back({foot, sum({}, -1.0, shape.axis), area});
      elements.push_back({sum(foot, shape.length, shape.axis), shape.axis, area});
    }
  }
}

void add_round(const Shape& shape, int dimension, double size, Elements& elements) {
  const bool ring = shape.kind == Shape::Kind::ring && shape.inner_radius > 0.0;
  add_lateral(shape, dimension, shape.radius, 1.0, size, elements);
  if (ring) add_lateral(shape, dimension, shape.inner_radius, -1.0, size, elements);
  if (dimension == 3) add_ends(shape, ring ? shape.inner_radius : 0.0, size, elements);
}

// In bands of latitude.
void add_sphere(const Shape& shape, double size, Elements& elements) {
  const double pi = std::numbers::pi;
  const int bands = pieces(pi * shape.radius, size);
  for (int b = 0; b < bands; ++b) {
    const double low = std::cos(pi * (b + 1) / bands), high = std::cos(pi * b / bands);
    const double height = 0.5 * (low + high);
    const double reach = std::sqrt(std::max(0.0, 1.0 - height * height));
    const int n = pieces(2.0 * pi * shape.radius * reach, size);
    for (int i = 0; i < n; ++i) {
      const double angle = 2.0 * pi * (i + 0.5) / n;
      const Point normal{reach * std::cos(angle), reach * std::sin(angle), height};
      elements.push_back({sum(shape.centre, shape.radius, normal), normal,
                          2.0 * pi * shape.radius * shape.radius * (high - low) / n});
    }
  }
}

// The flat ends of an extruded polygon.
void add_polygon_ends(const Shape& shape, double size, Elements& elements) {
  const Box box = bounding_box(shape, 3);
  const int n = pieces(box.maximum[0] - box.minimum[0], size);
  const int m = pieces(box.maximum[1] - box.minimum[1], size);
  std::vector<Point> inside;
  for (int k = 0; k < n * m; ++k) {
    const Point x{box.minimum[0] + (box.maximum[0] - box.minimum[0]) * (k % n + 0.5) / n,
                  box.minimum[1] + (box.maximum[1] - box.minimum[1]) * (k / n + 0.5) / m, 0.0};
    if (contains(shape, x, 2)) inside.push_back(x);
  }
  const double area = volume_estimate(shape, 2) / static_cast<double>(inside.size());
  for (const Point& x : inside) {
    elements.push_back({{x[0], x[1], shape.depth_minimum}, {0.0, 0.0, -1.0}, area});
    elements.push_back({{x[0], x[1], shape.depth_maximum}, {0.0, 0.0, 1.0}, area});
  }
}

void add_polygon(const Shape& shape, int dimension, double size, Elements& elements) {
  double twice = 0.0;  // the area, positive where the corners run counter-clockwise
  const auto corner = [&](std::size_t i) { return shape.vertices[i % shape.vertices.size()]; };
  for (std::size_t i = 0; i < shape.vertices.size(); ++i)
    twice += corner(i)[0] * corner(i + 1)[1] - corner(i + 1)[0] * corner(i)[1];
  const double sign = twice > 0.0 ? 1.0 : -1.0, depth = dimension == 3 ? 1.0 : 0.0;
  const Point second{0.0, 0.0, depth * (shape.depth_maximum - shape.depth_minimum)};
  for (std::size_t i = 0; i < shape.vertices.size(); ++i) {
    const Point first{corner(i + 1)[0] - corner(i)[0], corner(i + 1)[1] - corner(i)[1], 0.0};
    const double scale = sign / length_of(first);
    add_face({corner(i)[0], corner(i)[1], depth * shape.depth_minimum}, first, second,
             {scale * first[1], -scale * first[0], 0.0}, size, elements);
  }
  if (dimension == 3) add_polygon_ends(shape, size, elements);
}

// Triangles are halved at their longest edge until it is no longer than the diagonal of a square of
// `size`: long thin ones give few elements.
void add_triangle(const std::array<Point, 3>& corners, const Point& normal, double area,
                  double size, Elements& elements) {
  struct Part {
    std::array<Point, 3> corners;
    double area;
  };
  std::vector<Part> rest{{corners, area}};
  while (!rest.empty()) {
    const auto [at, share] = rest.back();
    rest.pop_back();
    std::size_t longest = 0;
    std::array<double, 3> edge;
    for (std::size_t k = 0; k < 3; ++k) {
      edge[k] = length_of(sum(at[(k + 1) % 3], -1.0, at[k]));
      if (edge[k] > edge[longest]) longest = k;
    }
    const Point &a = at[longest], &b = at[(longest + 1) % 3], &c = at[(longest + 2) % 3];
    if (edge[longest] <= std::numbers::sqrt2 * size) {
      elements.push_back(
          {sum(sum(a, 1.0 / 3.0, sum(b, -1.0, a)), 1.0 / 3.0, sum(c, -1.0, a)), normal, share});
      continue;
    }
    const Point middle = sum(a, 0.5, sum(b, -1.0, a));
    rest.push_back({{middle, b, c}, 0.5 * share});
    rest.push_back({{a, middle, c}, 0.5 * share});
  }
}

void add_mesh(const TriangleMesh& mesh, double size, Elements& elements) {
  for (const auto& triangle : mesh.triangles) {
    const std::array<Point, 3> corners{mesh.corners[triangle[0]], mesh.corners[triangle[1]],
                                       mesh.corners[triangle[2]]};
    Point normal = cross(sum(corners[1], -1.0, corners[0]), sum(corners[2], -1.0, corners[0]));
    const double twice = length_of(normal);
    if (!(twice > 0.0)) continue;
    for (double& component : normal) component /= twice;
    add_triangle(corners, normal, 0.5 * twice, size, elements);
  }
}

void add_shape(const Shape& shape, int dimension, double size, Elements& elements);

// Keeps those elements at which the surface of the shape is, with its outward normal there.
struct OnSurface {
  const Shape& shape;
  int dimension;
  double step;  // m, to points on both sides

  bool separates(const Shape& part, const SurfaceElement& element) const {
    return contains(part, sum(element.position, step, element.normal), dimension) !=
           contains(part, sum(element.position, -step, element.normal), dimension);
  }
  bool operator()(SurfaceElement& element) const {
    if (!separates(shape, element)) return false;
    if (contains(shape, sum(element.position, step, element.normal), dimension))
      element.normal = sum({}, -1.0, element.normal);
    return true;
  }
};

// Where faces of two parts coincide, those of the first one count.
void add_parts(const Shape& shape, int dimension, double size, Elements& elements) {
  const OnSurface on_surface{shape, dimension, 0.01 * size};
  for (auto part = shape.parts.begin(); part != shape.parts.end(); ++part) {
    Elements own;
    add_shape(*part, dimension, size, own);
    for (SurfaceElement& element : own) {
      const bool counted = std::any_of(shape.parts.begin(), part, [&](const Shape& earlier) {
        return on_surface.separates(earlier, element);
      });
      if (!counted && on_surface(element)) elements.push_back(element);
    }
  }
}

void add_shape(const Shape& shape, int dimension, double size, Elements& elements) {
  switch (shape.kind) {
    case Shape::Kind::box:
      return add_box(shape.box, dimension, size, elements);
    case Shape::Kind::disc:
    case Shape::Kind::ring:
      return add_round(shape, dimension, size, elements);
    case Shape::Kind::sphere:
      return add_sphere(shape, size, elements);
    case Shape::Kind::polygon:
      return add_polygon(shape, dimension, size, elements);
    case Shape::Kind::join:
    case Shape::Kind::difference:
      return add_parts(shape, dimension, size, elements);
    case Shape::Kind::mesh: {
      Elements own;
      add_mesh(shape.mesh.surface->mesh(), size, own);
      const OnSurface on_surface{shape, dimension, 0.01 * size};
      for (SurfaceElement& element : own)
        if (on_surface(element)) elements.push_back(element);
    }
  }
}

}  // namespace

std::vector<SurfaceElement> surface_elements(const Shape& shape, int dimension, double size) {
  Elements elements;
  add_shape(shape, dimension, size, elements);
  return elements;
}

std::vector<SurfaceElement> surface_elements_within(const Shape& region, const Shape& shape,
                                                    int dimension, double size) {
  Elements elements = surface_elements(shape, dimension, size);
  std::erase_if(elements, [&](const SurfaceElement& element) {
    return !contains(region, element.position, dimension);
  });
  return elements;
}

}  // namespace kerf
