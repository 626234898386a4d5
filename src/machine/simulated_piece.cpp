// SPDX-License-Identifier: Apache-2.0
#include "machine/simulated_piece.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "geometry/graded_cells.hpp"
#include "geometry/jet_direction.hpp"
#include "geometry/particle_estimate.hpp"
#include "geometry/point_vectors.hpp"
#include "machine/travelling_frame.hpp"
#include "model/body.hpp"
#include "model/case.hpp"

namespace kerf {

namespace {

constexpr int graded_levels = 2;
constexpr double graded_width = 2.0;  // jet widths
constexpr double nozzle_rows = 5.0;   // spacings: the 4 rows of water at the nozzle, and one more

// Returns the shift of the axis of the jet along x and z per depth.
Point lean_of(const Jet& jet) {
  const double slope = std::tan(jet.angle);
  return {slope * std::cos(jet.azimuth), 0.0, slope * std::sin(jet.azimuth)};
}

bool travels(const PieceRequest& request) {
  return request.frame == WorkpieceFrame::travelling;
}

// In the plane of a cut no distance across the path of the nozzle exists.
int levels_of(const PieceRequest& request) {
  return request.levels.value_or(travels(request) && request.dimension == 2 ? 0 : graded_levels);
}

// Returns the width of the finest part, m: at least the least one for the coarsest cells.
double grading_width_of(const PieceRequest& request, int levels) {
  const double cell = request.spacing > request.jet.width ? 0.0 : request.spacing * (1 << levels);
  return std::max(graded_width * request.jet.width,
                  least_level_width * request.smoothing_ratio * cell);
}

// Returns the room between nozzle and edge of the domain, m, which holds the rows of its water.
double margin_of(const Jet& jet) {
  return std::max(domain_margin * jet.width, nozzle_rows * jet.spacing);
}

// Returns how far the nozzle moves in the run, m; 0 where the frame travels with it.
double way_of(const PieceRequest& request) {
  const Jet& jet = request.jet;
  const double speed = std::hypot(jet.traverse[0], jet.traverse[2]);
  if (travels(request) || !(speed > 0.0)) return 0.0;
  return std::max(traverse_widths * jet.width,
                  speed * (jet.dwell + passage_time(jet, request.depth)));
}

// The part around the jet and its path; whole coarsest cells from the middle of the jet on.
Box part_around(const PieceRequest& request) {
  const Jet& jet = request.jet;
  const Point extent = jet_extent(jet, request.dimension), lean = lean_of(jet);
  const double speed = std::hypot(jet.traverse[0], jet.traverse[2]);
  const double way = way_of(request);
  const double unit = request.spacing * (1 << levels_of(request));
  Box part;
  part.minimum[1] = -request.depth;
  for (const std::size_t a : {std::size_t{0}, std::size_t{2}}) {
    if (a == 2 && request.dimension == 2) continue;
    const double half = 0.5 * extent[a] + window_reach(request.dimension) * jet.width;
    const double path = speed > 0.0 ? way * jet.traverse[a] / speed : 0.0;
    const double shift = lean[a] * request.depth;
    const auto whole = [&](double length) { return unit * std::ceil(length / unit - 1e-9); };
    const double edge = 0.5 * request.size[a];
    const double low = jet.position[a] - whole(half - std::min(0.0, path) - std::min(0.0, shift));
    const double high = jet.position[a] + whole(half + std::max(0.0, path) + std::max(0.0, shift));
    part.minimum[a] = std::max(-edge, low);
    part.maximum[a] = std::min(edge, high);
    // A part that ends at one edge of the workpiece has whole cells from there on, at either edge:
    // a lattice begins at the lowest corner, and parts at both edges are to be mirror images.
    if (travels(request) || (low < -edge) == (high > edge)) continue;
    const double length = whole(part.maximum[a] - part.minimum[a]);
    if (high > edge)
      part.minimum[a] = std::max(-edge, edge - length);
    else
      part.maximum[a] = std::min(edge, length - edge);
  }
  return part;
}

// Whether the water of a nozzle is symmetric about the plane through its axis that is normal to an
// axis of the case: it has no middle column there, and a slot is along or across it.
bool is_symmetric(const Jet& jet, std::size_t axis, double extent) {
  return !is_turned_slot(jet, axis) && std::lround(extent / jet.spacing) % 2 == 0;
}

// Returns the planes through the axis of the jet about which the part and the jet are symmetric,
// and cuts the part there.
Faces cut_at_planes(const PieceRequest& request, Box& part) {
  Faces planes;
  const Point lean = lean_of(request.jet), extent = jet_extent(request.jet, request.dimension);
  for (const std::size_t a : {std::size_t{0}, std::size_t{2}}) {
    if (a == 2 && request.dimension == 2) continue;
    if (!is_symmetric(request.jet, a, extent[a])) continue;
    const double at = request.jet.position[a];
    const bool is_middle = std::abs(part.minimum[a] + part.maximum[a] - 2.0 * at) <
                           1e-9 * (part.maximum[a] - part.minimum[a]);
    if (!is_middle || std::abs(lean[a]) > 1e-12 || request.jet.traverse[a] != 0.0) continue;
    planes.minimum[a] = true;
    part.minimum[a] = at;
  }
  return planes;
}

// Adds room for a shift ahead of the nozzle to a travelling window, which has whole coarsest cells.
void make_travelling(const PieceRequest& request, WorkpieceSetting& workpiece) {
  const TravellingFrame frame = travelling_frame(workpiece, request.jet);
  const double cell = coarsest_cell(workpiece);
  const bool forwards = frame.sign > 0.0;
  double& front = (forwards ? workpiece.part.maximum : workpiece.part.minimum)[frame.axis];
  const double rear = (forwards ? workpiece.part.minimum : workpiece.part.maximum)[frame.axis];
  const double around = frame.sign * (front - rear);
  const double length = around + cell * std::ceil(around / (shifts_per_window - 1.0) / cell);
  const double room =
      frame.sign * (forwards ? frame.path.maximum : frame.path.minimum)[frame.axis] -
      frame.sign * rear;
  front = rear + frame.sign * cell * std::floor(std::min(length, room) / cell + 1e-6);
  workpiece.shift = usual_shift(workpiece, frame.axis);
}

// Extends the domain to the nozzle and its path, which may lead past the edges of the workpiece.
void hold_nozzle(const PieceRequest& request, const Faces& planes, Box& domain) {
  const Jet& jet = request.jet;
  const Point lean = lean_of(jet), extent = jet_extent(jet, request.dimension);
  const double speed = std::hypot(jet.traverse[0], jet.traverse[2]);
  for (const std::size_t a : {std::size_t{0}, std::size_t{2}}) {
    if (a == 2 && request.dimension == 2) continue;
    const double start = jet.position[a] - lean[a] * jet.standoff * std::cos(jet.angle);
    const double end = speed > 0.0 ? start + way_of(request) * jet.traverse[a] / speed : start;
    const double room = extent[a] + margin_of(jet);
    if (!planes.minimum[a])
      domain.minimum[a] = std::min(domain.minimum[a], std::min(start, end) - room);
    domain.maximum[a] = std::max(domain.maximum[a], std::max(start, end) + room);
  }
}

double particles_of(const PieceRequest& request, const Box& part, int levels) {
  Body body;
  body.shape.kind = Shape::Kind::box;
  body.shape.box = part;
  body.spacing = request.spacing;
  if (levels > 0) {
    body.grading.levels = levels;
    body.grading.width = grading_width_of(request, levels);
    const double way = travels(request) ? std::numeric_limits<double>::infinity() : way_of(request);
    body.grading.lines = lines_along(request.jet, way);
  }
  return estimate_particles(body, request.dimension).total();
}

// Whether whole coarsest cells lie beside each plane, as symmetry planes demand of graded bodies.
bool holds_whole_cells(const Box& part, const Faces& planes, double cell) {
  for (const std::size_t a : {std::size_t{0}, std::size_t{2}})
    if (planes.minimum[a] && !is_whole(part.maximum[a] - part.minimum[a], cell)) return false;
  return true;
}

// Returns the levels to choose from.
std::vector<int> possible_levels(const PieceRequest& request) {
  const int usual = levels_of(request);
  return request.levels || usual == 0 ? std::vector{usual} : std::vector{usual, 0};
}

// Sets the part, its planes and its levels to the choice with the fewest particles.
void choose_layout(const PieceRequest& request, SimulatedPiece& piece) {
  const Box whole = piece.workpiece.part;
  double fewest = std::numeric_limits<double>::infinity();
  for (const bool mirrored : {true, false}) {
    if (mirrored && !request.may_mirror) continue;
    for (const int levels : possible_levels(request)) {
      Box part = whole;
      const Faces planes = mirrored ? cut_at_planes(request, part) : Faces{};
      if (levels > 0 && !holds_whole_cells(part, planes, request.spacing * (1 << levels))) continue;
      const double particles = particles_of(request, part, levels);
      if (particles >= fewest) continue;
      fewest = particles;
      piece.workpiece.part = part;
      piece.workpiece.levels = levels;
      piece.symmetry = planes;
    }
  }
}

}  // namespace

double depth_of_draft(const Jet& jet, double thickness) {
  const double width = jet.width * std::cos(jet.angle);  // of the depth along the jet
  return thickness > whole_depth * width ? draft_depth * width : thickness;
}

double thickness_below(const WorkpieceSetting& workpiece) {
  const double below = workpiece.part.minimum[1] + workpiece.size[1];
  return below > 1e-9 * workpiece.size[1] ? below : 0.0;
}

double last_front_depth(const Case& description) {
  if (!description.workpiece || !(thickness_below(*description.workpiece) > 0.0))
    return std::numeric_limits<double>::infinity();
  const Jet& jet = description.jets.back();
  return -description.workpiece->part.minimum[1] / std::cos(jet.angle) - bottom_margin * jet.width;
}

Point jet_extent(const Jet& jet, int dimension) {
  const JetAxes axes = axes_of(jet);
  // Returns a vector of the section, of a length, carried along the water into the surface.
  const auto on_surface = [&](const Point& unit, double length) {
    Point vector = sum(unit, -unit[1] / axes.along[1], axes.along);
    for (double& component : vector) component *= length;
    return vector;
  };
  const bool is_slot = jet.length > 0.0;
  const Point wide = on_surface(axes.across, jet.width);
  if (dimension == 2) return {std::abs(wide[0]), 0.0, 0.0};
  const Point aside = on_surface(axes.sideways, is_slot ? jet.length : jet.width);
  Point extent{};
  for (const std::size_t a : {std::size_t{0}, std::size_t{2}})
    extent[a] = is_slot ? std::abs(wide[a]) + std::abs(aside[a]) : std::hypot(wide[a], aside[a]);
  return extent;
}

Box domain_around(const PieceRequest& request, const Box& part, const Faces& planes) {
  const double margin = margin_of(request.jet);
  Box domain = part;
  for (std::size_t a = 0; a < static_cast<std::size_t>(request.dimension); ++a) {
    if (!planes.minimum[a]) domain.minimum[a] -= margin;
    domain.maximum[a] += margin;
  }
  domain.maximum[1] += request.jet.standoff * std::cos(request.jet.angle) +
                       0.5 * request.jet.length * std::abs(request.jet.slot[1]);
  domain.minimum[1] -= margin;
  const bool is_whole = !(request.depth < request.size[1] * (1.0 - 1e-9));
  if (is_whole) domain.minimum[1] -= room_below * request.depth;
  hold_nozzle(request, planes, domain);
  return domain;
}

SimulatedPiece simulated_piece(const PieceRequest& request) {
  SimulatedPiece piece;
  WorkpieceSetting& workpiece = piece.workpiece;
  workpiece.size = request.size;
  workpiece.depth = request.depth;
  workpiece.spacing = request.spacing;
  workpiece.grading_width = grading_width_of(request, levels_of(request));
  workpiece.frame = request.frame;
  workpiece.part = part_around(request);
  if (travels(request)) {
    workpiece.levels = levels_of(request);
    make_travelling(request, workpiece);
  }
  choose_layout(request, piece);
  piece.domain = domain_around(request, workpiece.part, piece.symmetry);
  return piece;
}

Faces continued_faces(const WorkpieceSetting& workpiece, const Faces& symmetry, int dimension) {
  Faces faces;
  faces.minimum[1] = thickness_below(workpiece) > 0.0;
  for (const std::size_t a : {std::size_t{0}, std::size_t{2}}) {
    if (a == 2 && dimension == 2) continue;
    const double edge = 0.5 * workpiece.size[a], slack = 1e-9 * edge;
    faces.minimum[a] = !symmetry.minimum[a] && workpiece.part.minimum[a] > -edge + slack;
    faces.maximum[a] = !symmetry.maximum[a] && workpiece.part.maximum[a] < edge - slack;
  }
  return faces;
}

}  // namespace kerf
