// SPDX-License-Identifier: Apache-2.0
#include "geometry/beside_jet.hpp"

#include <algorithm>
#include <cmath>

#include "core/boundary_between.hpp"
#include "geometry/fill.hpp"
#include "geometry/jet_direction.hpp"
#include "geometry/shapes.hpp"

namespace kerf {

namespace {

Point moved(const Point& from, const Point& direction, double distance) {
  Point point = from;
  for (std::size_t a = 0; a < 3; ++a) point[a] += distance * direction[a];
  return point;
}

double product(const Point& a, const Point& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// The straight water of a jet: a strip in 2D; in 3D a cylinder, or a slab with round edges out of a
// slot.
class StraightWater {
 public:
  StraightWater(const Jet& jet, int dimension)
      : along_(jet_direction(jet)),
        exit_(moved(jet.position, along_, -jet.standoff)),
        radius_(0.5 * jet.width) {
    if (dimension == 2 || jet.length == 0.0) return;
    half_length_ = std::max(0.0, 0.5 * jet.length - radius_);
    side_ = axes_of(jet).sideways;
  }

  bool is_beyond_exit(const Point& point) const {
    return product(moved(point, exit_, -1.0), along_) >= 0.0;
  }
  // Returns the vector from the middle line or plane of the water to the point.
  Point aside(const Point& point) const {
    const Point from = moved(point, exit_, -1.0);
    Point vector = moved(from, along_, -product(from, along_));
    const double side = product(vector, side_);
    return moved(vector, side_, -std::clamp(side, -half_length_, half_length_));
  }
  double radius() const { return radius_; }

 private:
  Point along_, exit_;
  double radius_;             // m
  double half_length_ = 0.0;  // m, of the middle plane of a slab; 0 for a line
  Point side_{};
};

// Returns the distance from the water to the surface of a shape that holds the point, towards it.
double distance_of_surface(const StraightWater& water, const Shape& shape, const Point& point,
                           int dimension) {
  const Point aside = water.aside(point);
  const double length = std::sqrt(product(aside, aside));
  const double inside =  // as a share of `aside`
      boundary_between(std::min(1.0, water.radius() / length), 1.0, [&](double share) {
        return contains(shape, moved(point, aside, share - 1.0), dimension);
      });
  return std::max(0.0, inside * length - water.radius());
}

}  // namespace

BesideJet beside_jet(const Jet& jet, const std::vector<const Body*>& bodies, int dimension,
                     double most) {
  const StraightWater water(jet, dimension);
  BesideJet nearest;
  for (const Body* body : bodies) {
    LatticeVisit request;
    request.window = bounding_box(body->shape, dimension);
    request.visit = [&](const Point& point) {
      if (!water.is_beyond_exit(point)) return true;
      const Point aside = water.aside(point);
      // A particle nearer than the surface that is known, or one beside it.
      const double apart = std::sqrt(product(aside, aside)) - water.radius() - body->spacing;
      if (apart >= nearest.distance) return true;
      const double distance = distance_of_surface(water, body->shape, point, dimension);
      if (distance < nearest.distance) nearest = {body, distance};
      return true;
    };
    visit_sample(*body, dimension, request, most);
  }
  return nearest;
}

}  // namespace kerf
