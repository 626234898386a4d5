// SPDX-License-Identifier: Apache-2.0
// Turns lattices along the faces of their bodies, and applies `inclusion_of`: it cuts the shape of
// the inclusion out of the body that contains it, continues the lattice across the interface, and
// adds bonds. In the finished case these are ordinary shapes, offsets and joined_to.
#include <fmt/format.h>

#include <cmath>

#include "geometry/fill.hpp"
#include "geometry/lattice_angle.hpp"
#include "input/draft.hpp"
#include "model/case.hpp"

namespace kerf {

namespace {

BodyDraft* body_around(Draft& draft, const BodyDraft& inclusion) {
  for (BodyDraft& entry : draft.bodies)
    if (entry.body.name == inclusion.inclusion_of) return &entry;
  return nullptr;
}

// Returns the number of bodies that contain this one, directly or through others; a number above
// that of all bodies means a cycle.
std::size_t depth_of(Draft& draft, const BodyDraft& entry) {
  std::size_t depth = 0;
  const BodyDraft* outer = &entry;
  while (!outer->inclusion_of.empty() && depth <= draft.bodies.size()) {
    outer = body_around(draft, *outer);
    ++depth;
  }
  return depth;
}

void cut_out(Shape& around, const Shape& room) {
  if (around.kind != Shape::Kind::difference) {
    Shape whole;
    std::swap(whole, around);
    around.kind = Shape::Kind::difference;
    around.parts.push_back(std::move(whole));
  }
  around.parts.push_back(room);
}

// Shifts the lattice of `body` onto that of `around`, where both can have one: each of its nodes
// then has a particle of one of the two bodies, also at the interface. These bodies keep to it.
void align(Body& body, Body& around, int dimension) {
  constexpr double rounding = 1e-9;  // of a spacing
  const double d = body.spacing;
  if (std::abs(around.spacing - d) > rounding * d || body.lattice != Lattice::square ||
      around.lattice != Lattice::square || body.grading.levels > 0 ||
      body.lattice_angle != around.lattice_angle)
    return;
  const Box own = lattice_box(body, dimension), other = lattice_box(around, dimension);
  for (std::size_t a = 0; a < static_cast<std::size_t>(dimension); ++a) {
    const double shift = std::remainder(other.minimum[a] + around.offset[a] - own.minimum[a], d);
    body.offset[a] = std::abs(shift) > rounding * d ? shift : 0.0;
  }
  body.body_fitted = around.body_fitted = false;
}

// Turns the lattices of the bodies that have no angle of their own; those of the paper's
// formulation are along the axes.
void orient(Draft& draft) {
  if (draft.result.formulation != Formulation::standard) return;
  std::vector<Body*> bodies;
  for (BodyDraft& entry : draft.bodies) {
    entry.body.lattice_follows_faces = !entry.has_lattice_angle;
    bodies.push_back(&entry.body);
  }
  orient_lattices(bodies, {draft.result.symmetry, draft.result.domain}, draft.reading.dimension);
}

}  // namespace

void place_inclusions(Draft& draft) {
  std::vector<Shape> written;
  for (const BodyDraft& entry : draft.bodies) {
    written.push_back(entry.body.shape);
    if (depth_of(draft, entry) <= draft.bodies.size()) continue;
    draft.reading.problems.add(
        {entry.path + ".inclusion_of", "the bodies contain one another in a cycle",
         "bodies of which one contains the other", "Remove the key from the outermost body"});
    return;
  }
  for (BodyDraft& entry : draft.bodies)
    if (!entry.inclusion_of.empty() && entry.body.role == Role::elastic)
      entry.body.joined_to = entry.inclusion_of;
  orient(draft);
  // The outer bodies come first, since each inclusion takes its lattice from the body around it.
  for (std::size_t depth = 1; depth < draft.bodies.size(); ++depth)
    for (std::size_t b = 0; b < draft.bodies.size(); ++b) {
      BodyDraft& entry = draft.bodies[b];
      if (entry.inclusion_of.empty() || depth_of(draft, entry) != depth) continue;
      BodyDraft& around = *body_around(draft, entry);
      cut_out(around.body.shape, written[b]);
      if (entry.body.role == Role::water && entry.body.lattice_follows_faces) {
        entry.body.lattice_follows_faces = false;
        entry.body.lattice_angle = around.body.lattice_angle;
      }
      if (!entry.has_offset) align(entry.body, around.body, draft.reading.dimension);
    }
}

}  // namespace kerf
