// SPDX-License-Identifier: Apache-2.0
#include "geometry/lattice_angle.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/plane_turn.hpp"
#include "geometry/shapes.hpp"

namespace kerf {

namespace {

constexpr double quarter = std::numbers::pi / 2.0;
constexpr double rounding = 1e-6;  // rad, and of a length

// The length of the edges in each direction, up to quarter turns.
class Directions {
 public:
  // Returns false if the shape holds a mesh.
  bool add(const Shape& shape) {
    switch (shape.kind) {
      case Shape::Kind::box:
        add_edges(corners_of(shape.box));
        return true;
      case Shape::Kind::polygon:
        add_edges(shape.vertices);
        return true;
      case Shape::Kind::join:
        return std::all_of(shape.parts.begin(), shape.parts.end(),
                           [&](const Shape& part) { return add(part); });
      case Shape::Kind::difference:
        for (std::size_t k = 1; k < shape.parts.size(); ++k)
          if (!Directions().add(shape.parts[k])) return false;
        return add(shape.parts.front());
      case Shape::Kind::mesh:
        return false;
      case Shape::Kind::disc:
      case Shape::Kind::ring:
        add_cylinder(shape);
        return true;
      default:
        return true;
    }
  }

  double longest() const {
    const Direction* best = nullptr;
    bool is_alone = true;
    for (const Direction& other : directions_) {
      if (best == nullptr || other.length > best->length * (1.0 + rounding)) {
        best = &other;
        is_alone = true;
      } else if (other.length > best->length * (1.0 - rounding)) {
        is_alone = false;
      }
    }
    return best != nullptr && is_alone && std::abs(best->angle) > 1e-9 ? best->angle : 0.0;
  }

 private:
  struct Direction {
    double angle;   // rad, in (-pi/4, pi/4]
    double length;  // m
  };

  void add_edges(const std::vector<std::array<double, 2>>& corners) {
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const auto& from = corners[k];
      const auto& to = corners[(k + 1) % corners.size()];
      const double x = to[0] - from[0], y = to[1] - from[1];
      const double length = std::hypot(x, y);
      if (length > 0.0) add_edge(std::remainder(std::atan2(y, x), quarter), length);
    }
  }
  // Seen along z, a cylinder whose axis is at right angles to z is a rectangle.
  void add_cylinder(const Shape& shape) {
    if (std::abs(shape.axis[2]) > rounding) return;
    const double angle = std::remainder(std::atan2(shape.axis[1], shape.axis[0]), quarter);
    add_edge(angle, 2.0 * shape.length + 4.0 * shape.radius);
  }
  void add_edge(double angle, double length) {
    if (angle < rounding - 0.5 * quarter) angle += quarter;
    for (Direction& other : directions_)
      if (std::abs(std::remainder(other.angle - angle, quarter)) < rounding) {
        other.length += length;
        return;
      }
    directions_.push_back({angle, length});
  }

  std::vector<Direction> directions_;
};

bool reaches(const Shape& shape, const SymmetryPlanes& symmetry, int dimension) {
  const Box box = bounding_box(shape, dimension);
  for (std::size_t a = 0; a < static_cast<std::size_t>(dimension); ++a) {
    const double slack = 1e-6 * (box.maximum[a] - box.minimum[a]);
    if (symmetry.planes.minimum[a] && box.minimum[a] < symmetry.domain.minimum[a] + slack)
      return true;
    if (symmetry.planes.maximum[a] && box.maximum[a] > symmetry.domain.maximum[a] - slack)
      return true;
  }
  return false;
}

// Returns the body whose faces the lattice of `body` follows.
const Body& whole_of(const std::vector<Body*>& bodies, const Body& body) {
  const Body* whole = &body;
  for (std::size_t steps = 0; steps < bodies.size(); ++steps) {
    const std::string& name = whole->joined_to;
    const auto next =
        std::find_if(bodies.begin(), bodies.end(), [&](const Body* b) { return b->name == name; });
    if (name.empty() || next == bodies.end()) break;
    whole = *next;
  }
  return *whole;
}

}  // namespace

double angle_of_faces(const Shape& shape) {
  Directions directions;
  return directions.add(shape) ? directions.longest() : 0.0;
}

void orient_lattices(const std::vector<Body*>& bodies, const SymmetryPlanes& symmetry,
                     int dimension) {
  for (Body* body : bodies) {
    if (!body->lattice_follows_faces) continue;
    const Body& whole = whole_of(bodies, *body);
    const bool is_mirrored = reaches(whole.shape, symmetry, dimension);
    body->lattice_angle = !whole.lattice_follows_faces ? whole.lattice_angle
                          : is_mirrored                ? 0.0
                                                       : angle_of_faces(whole.shape);
  }
}

Body along_lattice(const Body& body) {
  Body result = body;
  result.lattice_angle = 0.0;
  result.grading.around.reset();
  result.grading.lines.clear();
  if (body.lattice_angle != 0.0) result.shape = turned(body.shape, PlaneTurn(-body.lattice_angle));
  return result;
}

}  // namespace kerf
