// SPDX-License-Identifier: Apache-2.0
#include "geometry/closed_surface.hpp"

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <cmath>

#include "core/error.hpp"
#include "geometry/point_vectors.hpp"

namespace kerf {

namespace {

namespace geometry = boost::geometry;
using Position = geometry::model::point<double, 3, geometry::cs::cartesian>;
using Bounds = geometry::model::box<Position>;
using Entry = std::pair<Bounds, std::uint32_t>;  // of a triangle
using Corners = std::array<Point, 3>;

constexpr double tolerance = 1e-6;  // of the longest edge of the box

Point difference(const Point& a, const Point& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Bounds bounds_of(const Point& low, const Point& high) {
  return {{low[0], low[1], low[2]}, {high[0], high[1], high[2]}};
}

Bounds bounds_of(const Corners& corners) {
  Point low = corners[0], high = corners[0];
  for (const Point& corner : corners)
    for (std::size_t a = 0; a < 3; ++a) {
      low[a] = std::min(low[a], corner[a]);
      high[a] = std::max(high[a], corner[a]);
    }
  return bounds_of(low, high);
}

Corners corners_of(const TriangleMesh& mesh, std::uint32_t number) {
  const auto& triangle = mesh.triangles[number];
  return {mesh.corners[triangle[0]], mesh.corners[triangle[1]], mesh.corners[triangle[2]]};
}

double distance_to_edge(const Point& a, const Point& b, const Point& point) {
  const Point edge = difference(b, a), way = difference(point, a);
  const double part = std::clamp(dot(way, edge) / dot(edge, edge), 0.0, 1.0);
  const Point rest = difference(way, {part * edge[0], part * edge[1], part * edge[2]});
  return std::sqrt(dot(rest, rest));
}

Point along(const Point& start, double part, const Point& edge) {
  return {start[0] + part * edge[0], start[1] + part * edge[1], start[2] + part * edge[2]};
}

// Returns the point of a triangle, whose unit normal is given, that is nearest to `point`.
Point nearest_on_triangle(const Corners& corners, const Point& normal, const Point& point) {
  bool above = true;
  double nearest = std::numeric_limits<double>::infinity();
  Point result{};
  for (std::size_t k = 0; k < 3; ++k) {
    const Point &a = corners[k], &b = corners[(k + 1) % 3];
    const Point edge = difference(b, a), way = difference(point, a);
    above = above && dot(cross(edge, way), normal) >= 0.0;
    const Point foot = along(a, std::clamp(dot(way, edge) / dot(edge, edge), 0.0, 1.0), edge);
    const Point rest = difference(point, foot);
    if (dot(rest, rest) >= nearest) continue;
    nearest = dot(rest, rest);
    result = foot;
  }
  return above ? along(point, -dot(difference(point, corners[0]), normal), normal) : result;
}

double distance_to_triangle(const Corners& corners, const Point& point) {
  const Point normal =
      cross(difference(corners[1], corners[0]), difference(corners[2], corners[0]));
  const double twice_area = std::sqrt(dot(normal, normal));
  bool above = twice_area > 0.0;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < 3; ++k) {
    const Point &a = corners[k], &b = corners[(k + 1) % 3];
    above = above && dot(cross(difference(b, a), difference(point, a)), normal) >= 0.0;
    nearest = std::min(nearest, distance_to_edge(a, b, point));
  }
  return above ? std::abs(dot(difference(point, corners[0]), normal)) / twice_area : nearest;
}

// Returns the winding number of the triangle, projected along z, about the point: -1, 0 or 1. The
// edges that cross the half line to greater x are counted. The crossing depends on the two ends of
// the edge alone, so that both triangles of the edge give the same one, and lies between the ends,
// so that no triangle is counted beyond its bounds.
int turns_around(const Corners& corners, const Point& point) {
  int turns = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Point &a = corners[k], &b = corners[(k + 1) % 3];
    const bool upward = a[1] <= point[1];
    if (upward == (b[1] <= point[1])) continue;
    const Point &low = upward ? a : b, &high = upward ? b : a;
    const double x = low[0] + (point[1] - low[1]) / (high[1] - low[1]) * (high[0] - low[0]);
    if (std::clamp(x, std::min(low[0], high[0]), std::max(low[0], high[0])) > point[0])
      turns += upward ? 1 : -1;
  }
  return turns;
}

// Returns the z at which the line through the point along z meets the triangle.
double crossing(const Corners& corners, const Point& point) {
  const Point normal =
      cross(difference(corners[1], corners[0]), difference(corners[2], corners[0]));
  const auto [low, high] = std::minmax({corners[0][2], corners[1][2], corners[2][2]});
  const Point way = difference(point, corners[0]);
  const double z = corners[0][2] - (normal[0] * way[0] + normal[1] * way[1]) / normal[2];
  return std::isfinite(z) ? std::clamp(z, low, high) : low;
}

// Rows of the matrix that turns about x, then y, then z.
std::array<Point, 3> turn_matrix(const Point& angle) {
  // The cosine of a quarter turn is 0, not 6e-17, so that faces along the axes stay along the axes.
  const auto exact = [](double value) { return std::abs(value) < 1e-15 ? 0.0 : value; };
  Point c{}, s{};
  for (std::size_t a = 0; a < 3; ++a) {
    c[a] = exact(std::cos(angle[a]));
    s[a] = exact(std::sin(angle[a]));
  }
  return {{{c[2] * c[1], c[2] * s[1] * s[0] - s[2] * c[0], c[2] * s[1] * c[0] + s[2] * s[0]},
           {s[2] * c[1], s[2] * s[1] * s[0] + c[2] * c[0], s[2] * s[1] * c[0] - c[2] * s[0]},
           {-s[1], c[1] * s[0], c[1] * c[0]}}};
}

}  // namespace

struct ClosedSurface::Tree {
  geometry::index::rtree<Entry, geometry::index::quadratic<16>> index;

  template <class Visit>
  void visit(const Bounds& bounds, const Visit& visitor) const {
    for (auto entry = index.qbegin(geometry::index::intersects(bounds)); entry != index.qend();
         ++entry)
      if (!visitor(entry->second)) return;
  }
};

ClosedSurface::ClosedSurface(TriangleMesh mesh) : mesh_(std::move(mesh)) {
  require(!mesh_.triangles.empty(), "a closed surface has triangles");
  std::vector<Entry> entries;
  entries.reserve(mesh_.triangles.size());
  for (std::uint32_t n = 0; n < mesh_.triangles.size(); ++n)
    entries.emplace_back(bounds_of(corners_of(mesh_, n)), n);
  box_ = {mesh_.corners[mesh_.triangles[0][0]], mesh_.corners[mesh_.triangles[0][0]]};
  for (const auto& triangle : mesh_.triangles)
    for (const std::uint32_t corner : triangle)
      for (std::size_t a = 0; a < 3; ++a) {
        box_.minimum[a] = std::min(box_.minimum[a], mesh_.corners[corner][a]);
        box_.maximum[a] = std::max(box_.maximum[a], mesh_.corners[corner][a]);
      }
  const Point size = difference(box_.maximum, box_.minimum);
  slack_ = tolerance * std::max({size[0], size[1], size[2]});
  tree_ = std::make_unique<const Tree>(Tree{{entries.begin(), entries.end()}});
}

ClosedSurface::~ClosedSurface() = default;

bool ClosedSurface::is_on_surface(const Point& point) const {
  Point low = point, high = point;
  for (std::size_t a = 0; a < 3; ++a) low[a] -= slack_, high[a] += slack_;
  bool found = false;
  tree_->visit(bounds_of(low, high), [&](std::uint32_t number) {
    found = distance_to_triangle(corners_of(mesh_, number), point) <= slack_;
    return !found;
  });
  return found;
}

int ClosedSurface::winding(const Point& point) const {
  int sum = 0;
  const Point end{point[0], point[1], std::max(point[2], box_.maximum[2])};
  tree_->visit(bounds_of(point, end), [&](std::uint32_t number) {
    const Corners corners = corners_of(mesh_, number);
    const int turns = turns_around(corners, point);
    if (turns != 0 && crossing(corners, point) > point[2]) sum += turns;
    return true;
  });
  return sum;
}

bool ClosedSurface::contains(const Point& point) const {
  for (std::size_t a = 0; a < 3; ++a)
    if (!(point[a] >= box_.minimum[a] - slack_ && point[a] <= box_.maximum[a] + slack_))
      return false;
  return is_on_surface(point) || winding(point) != 0;
}

std::vector<ClosedSurface::Foot> ClosedSurface::feet(const Point& point, double reach) const {
  std::vector<Foot> feet;
  tree_->visit(
      bounds_of(along(point, -reach, {1.0, 1.0, 1.0}), along(point, reach, {1.0, 1.0, 1.0})),
      [&](std::uint32_t number) {
        const Corners corners = corners_of(mesh_, number);
        const Point area =
            cross(difference(corners[1], corners[0]), difference(corners[2], corners[0]));
        const double size = std::sqrt(dot(area, area));
        if (!(size > 0.0)) return true;
        const Point normal = along({}, 1.0 / size, area);
        feet.push_back({nearest_on_triangle(corners, normal, point), normal});
        return true;
      });
  return feet;
}

double ClosedSurface::volume() const {
  double six_volumes = 0.0;
  for (std::uint32_t n = 0; n < mesh_.triangles.size(); ++n) {
    Corners corners = corners_of(mesh_, n);
    for (Point& corner : corners) corner = difference(corner, box_.minimum);
    six_volumes += dot(corners[0], cross(corners[1], corners[2]));
  }
  return std::abs(six_volumes) / 6.0;
}

void place_mesh(TriangleMesh& mesh, const MeshShape& shape) {
  const auto rows = turn_matrix(shape.rotation);
  for (Point& corner : mesh.corners) {
    const Point turned{dot(rows[0], corner), dot(rows[1], corner), dot(rows[2], corner)};
    for (std::size_t a = 0; a < 3; ++a) corner[a] = shape.scale * turned[a] + shape.position[a];
  }
}

}  // namespace kerf
