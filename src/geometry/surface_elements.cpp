// SPDX-License-Identifier: Apache-2.0
#include "geometry/surface_elements.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/closed_surface.hpp"
#include "geometry/point_vectors.hpp"
#include "geometry/round_surface.hpp"
#include "geometry/shapes.hpp"
#include "geometry/surface_patch.hpp"

namespace kerf {
namespace {

double length_of(const Point& a) {
  return std::hypot(a[0], a[1], a[2]);
}

// A parallelogram from `corner`; in 2D `second` has no length and the element is a segment.
void add_face(const Point& corner, const Point& first, const Point& second, const Point& normal,
              PatchedSurface& surface) {
  const double length = length_of(first), width = length_of(second);
  const int n = surface.pieces(length), m = surface.pieces(width);
  const double area = (width > 0.0 ? length_of(cross(first, second)) : length) / n / m;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j)
      surface.add(area, [&](double u, double v) -> SurfacePoint {
        return {sum(sum(corner, (i + u) / n, first), (j + v) / m, second), normal};
      });
}

void add_box(const Box& box, int dimension, PatchedSurface& surface) {
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
      add_face(corner, edge(b), second, normal, surface);
    }
  }
}

// The flat ends of an extruded polygon.
void add_polygon_ends(const Shape& shape, PatchedSurface& surface) {
  const Box box = bounding_box(shape, 3);
  const double length = box.maximum[0] - box.minimum[0], width = box.maximum[1] - box.minimum[1];
  const int n = surface.pieces(length), m = surface.pieces(width);
  const auto place = [&](int k, double u, double v) -> Point {
    return {box.minimum[0] + length * (k % n + u) / n, box.minimum[1] + width * (k / n + v) / m,
            0.0};
  };
  std::vector<int> inside;
  for (int k = 0; k < n * m; ++k)
    if (contains(shape, place(k, 0.5, 0.5), 2)) inside.push_back(k);
  const double area = volume_estimate(shape, 2) / static_cast<double>(inside.size());
  for (const int k : inside)
    for (const bool upper : {false, true})
      surface.add(area, [&](double u, double v) -> SurfacePoint {
        const Point x = place(k, u, v);
        return {{x[0], x[1], upper ? shape.depth_maximum : shape.depth_minimum},
                {0.0, 0.0, upper ? 1.0 : -1.0}};
      });
}

void add_polygon(const Shape& shape, int dimension, PatchedSurface& surface) {
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
             {scale * first[1], -scale * first[0], 0.0}, surface);
  }
  if (dimension == 3) add_polygon_ends(shape, surface);
}

// Triangles are halved at their longest edge until it is no longer than the diagonal of a square of
// `size`: long thin ones give few elements.
void add_triangle(const std::array<Point, 3>& corners, const Point& normal, double area,
                  PatchedSurface& surface) {
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
    if (edge[longest] <= std::numbers::sqrt2 * surface.size()) {
      const auto map = [&](double u, double v) -> SurfacePoint {
        return {sum(sum(a, u, sum(b, -1.0, a)), v, sum(c, -1.0, a)), normal};
      };
      surface.add(share, map(1.0 / 3.0, 1.0 / 3.0), map, PatchedSurface::triangle);
      continue;
    }
    const Point middle = sum(a, 0.5, sum(b, -1.0, a));
    rest.push_back({{middle, b, c}, 0.5 * share});
    rest.push_back({{a, middle, c}, 0.5 * share});
  }
}

void add_mesh(const TriangleMesh& mesh, PatchedSurface& surface) {
  for (const auto& triangle : mesh.triangles) {
    const std::array<Point, 3> corners{mesh.corners[triangle[0]], mesh.corners[triangle[1]],
                                       mesh.corners[triangle[2]]};
    Point normal = cross(sum(corners[1], -1.0, corners[0]), sum(corners[2], -1.0, corners[0]));
    const double twice = length_of(normal);
    if (!(twice > 0.0)) continue;
    for (double& component : normal) component /= twice;
    add_triangle(corners, normal, 0.5 * twice, surface);
  }
}

void add_shape(const Shape& shape, int dimension, PatchedSurface& surface);

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
void add_parts(const Shape& shape, int dimension, PatchedSurface& surface) {
  const OnSurface on_surface{shape, dimension, 0.01 * surface.size()};
  for (auto part = shape.parts.begin(); part != shape.parts.end(); ++part) {
    PatchedSurface own = surface.empty();
    add_shape(*part, dimension, own);
    for (SurfaceElement element : own.elements()) {
      const bool counted = std::any_of(shape.parts.begin(), part, [&](const Shape& earlier) {
        return on_surface.separates(earlier, element);
      });
      if (!counted && on_surface(element)) surface.add(element);
    }
  }
}

void add_shape(const Shape& shape, int dimension, PatchedSurface& surface) {
  switch (shape.kind) {
    case Shape::Kind::box:
      return add_box(shape.box, dimension, surface);
    case Shape::Kind::disc:
    case Shape::Kind::ring:
      return add_round(shape, dimension, surface);
    case Shape::Kind::sphere:
      return add_sphere(shape, surface);
    case Shape::Kind::polygon:
      return add_polygon(shape, dimension, surface);
    case Shape::Kind::join:
    case Shape::Kind::difference:
      return add_parts(shape, dimension, surface);
    case Shape::Kind::mesh: {
      PatchedSurface own = surface.empty();
      add_mesh(shape.mesh.surface->mesh(), own);
      const OnSurface on_surface{shape, dimension, 0.01 * surface.size()};
      for (SurfaceElement element : own.elements())
        if (on_surface(element)) surface.add(element);
    }
  }
}

}  // namespace

std::vector<SurfaceElement> surface_elements(const Shape& shape, int dimension, double size,
                                             const SymmetryPlanes& symmetry) {
  PatchedSurface surface(symmetry, size);
  add_shape(shape, dimension, surface);
  return surface.elements();
}

std::vector<SurfaceElement> surface_elements_within(const Shape& region, const Shape& shape,
                                                    int dimension, double size,
                                                    const SymmetryPlanes& symmetry) {
  auto elements = surface_elements(shape, dimension, size, symmetry);
  std::erase_if(elements, [&](const SurfaceElement& element) {
    return !contains(region, element.position, dimension);
  });
  return elements;
}

}  // namespace kerf
