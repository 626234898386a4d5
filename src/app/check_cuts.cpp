// SPDX-License-Identifier: Apache-2.0
// Warns of cuts in a shape whose plane faces lie on rows of particles: points of a face belong to
// the part that is cut out, so that the rows go and the cut is wider than drawn.
#include <fmt/format.h>

#include <algorithm>

#include "app/check_warnings.hpp"
#include "geometry/fill.hpp"
#include "geometry/nearest_face.hpp"
#include "geometry/shapes.hpp"
#include "model/case.hpp"
#include "output/readable.hpp"

namespace kerf {

namespace {

constexpr double on_face = 1e-6;  // of a spacing

// Returns whether a point of the shape is on one of its plane faces.
bool is_on_plane_face(const Shape& shape, const Point& point, double slack, int dimension) {
  const bool is_plane = shape.kind == Shape::Kind::polygon || shape.kind == Shape::Kind::box;
  return is_plane && is_near_face(shape, point, slack, dimension);
}

// A place inside another body is filled by it, as that of an inclusion.
bool is_filled(const Case& description, const Body& body, const Point& point) {
  return std::any_of(description.bodies.begin(), description.bodies.end(), [&](const Body& other) {
    return &other != &body && contains(other.shape, point, description.dimension);
  });
}

// Returns how many nodes of the lattice of `whole` lie on plane faces of a part that is cut out of
// it, and are left out.
double nodes_on_faces(const Case& description, const Body& body, const Body& whole,
                      const Shape& part) {
  const int dimension = description.dimension;
  const double slack = on_face * body.spacing;
  double count = 0.0;
  LatticeVisit request;
  request.window = bounding_box(part, dimension);
  for (std::size_t a = 0; a < 3; ++a) {
    request.window.minimum[a] -= slack;
    request.window.maximum[a] += slack;
  }
  request.visit = [&](const Point& node) {
    if (contains(part, node, dimension) && is_on_plane_face(part, node, slack, dimension) &&
        !is_filled(description, body, node))
      count += 1.0;
    return true;
  };
  const double times = visit_sample(whole, dimension, request, most_tested);
  return times * count;
}

// Returns the nodes on faces of all cuts of a body; a difference may be cut out of another one.
double lost_nodes(const Case& description, const Body& body) {
  double count = 0.0;
  Body whole = body;
  whole.grading = {};
  while (whole.shape.kind == Shape::Kind::difference) {
    const Shape shape = whole.shape;
    whole.shape = shape.parts.front();
    for (auto part = shape.parts.begin() + 1; part != shape.parts.end(); ++part)
      count += nodes_on_faces(description, body, whole, *part);
  }
  return count;
}

}  // namespace

std::vector<std::string> cut_warnings(const Case& description) {
  constexpr double row = 5.0;  // particles; fewer are those of a corner or a tip
  std::vector<std::string> warnings;
  for (const Body& body : description.bodies) {
    if (body.shape.kind != Shape::Kind::difference) continue;
    const double count = lost_nodes(description, body);
    if (count < row) continue;
    // A plane face halves the cells of the particles that lie on it.
    const double share = 0.5 * count * particle_volume(body, description.dimension) /
                         volume_estimate(body.shape, description.dimension);
    warnings.push_back(fmt::format(
        "about {:.0f} particles of \"{}\" would lie on faces of what its shape cuts out, and are "
        "left out: the cut is wider by half a spacing at each such face, and the particles fill "
        "{:.2g}% less than the shape. Put the faces between the rows: move them by half a spacing, "
        "or choose body.{}.spacing = {}",
        count, body.name, 100.0 * share, body.name, readable(0.5 * body.spacing, "m")));
  }
  return warnings;
}

}  // namespace kerf
