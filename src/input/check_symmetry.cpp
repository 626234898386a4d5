// SPDX-License-Identifier: Apache-2.0
// Checks for symmetry planes. Refused are gravity across a plane, particles on it, graded bodies of
// which it cuts coarsest cells, jets that it cuts outside their axis, and opposite planes so near
// that particles interact with images of images.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geometry/fill.hpp"
#include "geometry/graded_cells.hpp"
#include "geometry/jet_direction.hpp"
#include "geometry/nozzle.hpp"
#include "geometry/shapes.hpp"
#include "input/draft.hpp"
#include "input/refine.hpp"
#include "kernels/wendland_c2.hpp"
#include "model/case.hpp"

namespace kerf {

namespace {

// One plane: a face of the domain.
struct Plane {
  std::size_t axis;
  double at;         // m
  double inward;     // 1 or -1
  const char* name;  // as in the case file

  double depth(const Point& point) const { return inward * (point[axis] - at); }
};

std::vector<Plane> planes_of(const Case& description) {
  static constexpr const char* names[] = {"x-", "x+", "y-", "y+", "z-", "z+"};
  std::vector<Plane> planes;
  for (std::size_t a = 0; a < 3; ++a) {
    if (description.symmetry.minimum[a])
      planes.push_back({a, description.domain.minimum[a], 1.0, names[2 * a]});
    if (description.symmetry.maximum[a])
      planes.push_back({a, description.domain.maximum[a], -1.0, names[2 * a + 1]});
  }
  return planes;
}

// Least distance of particles from a plane, in spacings: nearer particles and their images would
// overlap.
constexpr double nearest = 0.25;

void check_gravity(Draft& draft, const Plane& plane) {
  if (draft.result.gravity[plane.axis] == 0.0) return;
  draft.reading.problems.add(
      {"domain.symmetry",
       fmt::format("gravity acts across the plane \"{}\", and would be reversed beyond it",
                   plane.name),
       "planes parallel to gravity", "Use a rigid body as a floor, or remove gravity"});
}

void check_width(Draft& draft, const Plane& plane) {
  const Case& result = draft.result;
  if (plane.inward < 0.0 || !result.symmetry.maximum[plane.axis]) return;
  double widest = 0.0;
  for (const Body& body : result.bodies) widest = std::max(widest, body.spacing);
  for (const Jet& jet : result.jets) widest = std::max(widest, jet.spacing);
  const double least = (WendlandC2<2>::support * result.smoothing_ratio + 0.5) * widest;
  if (result.domain.maximum[plane.axis] - result.domain.minimum[plane.axis] >= least) return;
  draft.reading.problems.add({"domain.symmetry",
                              fmt::format("the plane \"{}\" and the opposite one are so near that "
                                          "particles would interact with images of images",
                                          plane.name),
                              fmt::format("planes at least {:.6g} m apart", least),
                              "Choose a smaller spacing or a wider domain"});
}

// Refuses graded bodies with coarsest cells that a plane cuts: the layout on both sides of it would
// not be one of mirror images.
void check_grading(Draft& draft, const Plane& plane, std::size_t number) {
  const Body& body = draft.result.bodies[number];
  if (body.grading.levels == 0) return;
  const Box box = bounding_box(body.shape, draft.result.dimension);
  const GradedCells cells(body, draft.result.dimension);
  GradedCell corner;
  corner.low = cells.first();
  corner.level = body.grading.levels;
  const double width = cells.edge(corner);
  if (plane.at < box.minimum[plane.axis] - width || plane.at > box.maximum[plane.axis] + width)
    return;
  const double first = cells.centre(corner)[plane.axis] - 0.5 * width;
  if (is_whole(plane.at - first, width) && body.lattice_angle == 0.0) return;
  draft.reading.problems.add(
      {body_key(draft, number, "grading"),
       fmt::format("the symmetry plane \"{}\" cuts cells of the coarsest spacing, {:.6g} m",
                   plane.name, width),
       "bodies with a straight lattice of which whole coarsest cells lie on either side of a plane",
       fmt::format("Let the body end in the plane and be a multiple of {:.6g} m wide, or reach as "
                   "far beyond the plane as on this side with a multiple of {:.6g} m on each",
                   width, width)});
}

void check_body(Draft& draft, const Plane& plane, std::size_t number) {
  const Body& body = draft.result.bodies[number];
  LatticeVisit request;
  request.window = bounding_box(body.shape, draft.result.dimension);
  Box& window = request.window;
  const auto& absorbing = plane.inward > 0.0 ? body.absorbing.minimum : body.absorbing.maximum;
  if (absorbing[plane.axis] && (plane.inward > 0.0 ? window.minimum[plane.axis] <= plane.at
                                                   : window.maximum[plane.axis] >= plane.at))
    draft.reading.problems.add(
        {body_key(draft, number, "absorbing"),
         fmt::format("that side of the body lies in the symmetry plane \"{}\"", plane.name),
         "sides that are not mirrored", "Take it out of one of the two lists"});
  const double reach = nearest * body.spacing;
  window.minimum[plane.axis] = std::max(window.minimum[plane.axis], plane.at - reach);
  window.maximum[plane.axis] = std::min(window.maximum[plane.axis], plane.at + reach);
  if (window.minimum[plane.axis] > window.maximum[plane.axis]) return;
  bool found = false;
  request.visit = [&](const Point& point) {
    found = std::abs(plane.depth(point)) < reach * (1.0 - 1e-9);
    return !found;
  };
  visit_sample(body, draft.result.dimension, request, draft.effort.most_tested);
  if (!found) return;
  draft.reading.problems.add(
      {body_key(draft, number, "spacing"),
       fmt::format("particles of the body \"{}\" would lie on the symmetry plane \"{}\"", body.name,
                   plane.name),
       fmt::format(
           "lattices whose particles are at least {:.6g} m from the plane; half a spacing is best",
           reach),
       "Choose a spacing of which a whole number fits between the plane and the far side of the "
       "body, or shift the lattice by an offset"});
}

// Returns whether an odd number of columns lies across the axis of a jet: of all its columns, which
// are not tested one by one where they are many.
bool has_middle_column(const Jet& jet, std::size_t axis) {
  const bool is_along = jet.length > 0.0 && std::abs(axes_of(jet).sideways[axis]) > 0.5;
  const double size = is_along ? jet.length : jet.width;
  return std::max(1L, std::lround(size / jet.spacing)) % 2 != 0;
}

void check_jet_on(Draft& draft, const Plane& plane, std::size_t number) {
  const Case& result = draft.result;
  const Jet& jet = result.jets[number];
  const auto& water = result.materials[static_cast<std::size_t>(jet.material)];
  const Nozzle nozzle(coarsened(jet, result.dimension, draft.effort.most_tested), water.density,
                      result.dimension);
  const double reach = nearest * jet.spacing;
  const bool centred = std::abs(plane.depth(nozzle.exit())) < 1e-6 * jet.spacing &&
                       std::abs(nozzle.direction()[plane.axis]) < 1e-9 &&
                       jet.traverse[plane.axis] == 0.0 && !is_turned_slot(jet, plane.axis);
  bool beyond = false, on_plane = false, inside = false;
  for (const InletParticle& particle : nozzle.standing_water()) {
    const double depth = plane.depth(particle.position);
    on_plane = on_plane || std::abs(depth) < reach;
    beyond = beyond || depth <= -reach;
    inside = inside || depth >= reach;
  }
  if (centred) on_plane = has_middle_column(jet, plane.axis);
  if (!on_plane && !(beyond && inside)) return;
  const std::string& path = draft.jets[number].path;
  if (!centred)
    draft.reading.problems.add(
        {path + ".position",
         fmt::format(
             "the symmetry plane \"{}\" cuts the jet beside its axis, or a slot at an angle",
             plane.name),
         "jets whose axis stays in the plane, slots along it or across, or jets that do not touch "
         "it",
         "Move the jet or turn its angle"});
  else if (on_plane)
    draft.reading.problems.add(
        {path + ".spacing",
         fmt::format("the middle column of the jet would lie on the symmetry plane \"{}\"",
                     plane.name),
         "spacings of which an even number fits across the jet",
         fmt::format("Choose such a spacing, for example {:.6g} m",
                     jet.width / (2.0 * std::ceil(0.5 * jet.width / jet.spacing)))});
}

}  // namespace

namespace {

void look_at_planes(Draft& draft) {
  const auto planes = planes_of(draft.result);
  for (const Plane& plane : planes) {
    check_gravity(draft, plane);
    check_width(draft, plane);
    for (std::size_t i = 0; i < draft.result.bodies.size(); ++i) {
      check_grading(draft, plane, i);
      check_body(draft, plane, i);
    }
    for (std::size_t i = 0; i < draft.result.jets.size(); ++i) check_jet_on(draft, plane, i);
  }
}

}  // namespace

void check_symmetry(Draft& draft) {
  look_at_planes(draft);
  draft.reading.problems.throw_if_any();
}

bool suits_its_planes(const Case& description) {
  Draft draft{Reading{Problems(""), {}}, description, {}, {}, {}, {}};
  draft.effort = quick_look;
  for (const Body& body : description.bodies) {
    draft.bodies.emplace_back();
    draft.bodies.back().body = body;
  }
  for (const Jet& jet : description.jets) {
    draft.jets.emplace_back();
    draft.jets.back().jet = jet;
  }
  look_at_planes(draft);
  return !draft.reading.problems.any();
}

}  // namespace kerf
