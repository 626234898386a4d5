// SPDX-License-Identifier: Apache-2.0
#include "analysis/workpiece.hpp"

#include <algorithm>
#include <boost/pending/disjoint_sets.hpp>
#include <cmath>
#include <set>
#include <utility>

#include "analysis/pieces.hpp"
#include "analysis/united_bodies.hpp"
#include "analysis/workpiece_motion.hpp"
#include "core/boundary_between.hpp"
#include "geometry/shapes.hpp"
#include "machine/simulated_piece.hpp"
#include "model/case.hpp"

namespace kerf {
namespace {

// Returns for each body a number that bodies joined to each other share.
std::vector<std::uint16_t> join_bodies(const std::vector<Body>& bodies) {
  boost::disjoint_sets_with_storage<> sets(bodies.size());
  for (std::size_t b = 0; b < bodies.size(); ++b) sets.make_set(b);
  for (std::size_t b = 0; b < bodies.size(); ++b)
    for (std::size_t other = 0; other < bodies.size(); ++other)
      if (!bodies[b].joined_to.empty() && bodies[b].joined_to == bodies[other].name)
        sets.union_set(b, other);
  std::vector<std::uint16_t> group(bodies.size());
  for (std::size_t b = 0; b < bodies.size(); ++b)
    group[b] = static_cast<std::uint16_t>(sets.find_set(b));
  return group;
}

bool can_be_cut(const Body& body) {
  return body.role == Role::elastic && !body.fixed;
}

// Whether a particle is beside the axis, in the way of the jet.
bool is_beside_axis(const JetAxis& jet, const std::array<double, 3>& x, double size) {
  return jet.distance(x) <= in_way_reach(jet.width, size);
}

// Returns the groups of joined bodies that the jet hits, by group number.
std::vector<std::uint8_t> find_targets(const Case& description, const Frame& initial,
                                       const std::vector<std::uint16_t>& group) {
  const auto& bodies = description.bodies;
  std::vector<std::uint8_t> hit(bodies.size(), description.jets.empty() ? 1 : 0);
  if (description.jets.empty()) return hit;
  const JetAxis jet(description.jets.front(), description.dimension);
  for (std::size_t row = 0; row < initial.position.size(); ++row) {
    const std::size_t source = initial.source[row];
    if (source >= bodies.size() || !can_be_cut(bodies[source])) continue;
    const auto& x = initial.position[row];
    if (is_beside_axis(jet, x, initial.spacing[row]) && jet.depth(x) >= -jet.standoff)
      hit[group[source]] = 1;
  }
  return hit;
}

// Returns the depth at which the axis leaves a body: that of its deepest particle within a spacing
// of it.
double find_bottom(const Workpiece& workpiece, std::uint16_t body) {
  double bottom = 0.0;
  for (std::size_t slot = 0; slot < workpiece.position.size(); ++slot)
    if (workpiece.body[slot] == body &&
        workpiece.jet->distance(workpiece.position[slot]) <= workpiece.size[slot])
      bottom = std::max(
          bottom, workpiece.jet->depth(workpiece.position[slot]) + workpiece.size[slot] / 2.0);
  return bottom;
}

// Returns the depth at which the axis meets the first particle of the workpiece, m, or its stream,
// where none is on the axis; infinite where it meets none.
double first_particle(const Workpiece& workpiece) {
  const JetAxis& jet = *workpiece.jet;
  double on_axis = std::numeric_limits<double>::infinity(), in_stream = on_axis;
  for (std::size_t slot = 0; slot < workpiece.position.size(); ++slot) {
    const auto& x = workpiece.position[slot];
    const double size = workpiece.size[slot], depth = jet.depth(x);
    if (depth < -jet.standoff || !is_beside_axis(jet, x, size)) continue;
    in_stream = std::min(in_stream, depth - size / 2.0);
    if (jet.distance(x) <= size) on_axis = std::min(on_axis, depth - size / 2.0);
  }
  return std::isinf(on_axis) ? in_stream : on_axis;
}

// Returns the depth at which the axis enters the shapes of the bodies near the depth of its first
// particle, m, as no layout of particles tells it; that depth where it enters none there.
double find_face(const Workpiece& workpiece, const Case& description, double first) {
  const std::set<std::uint16_t> bodies(workpiece.body.begin(), workpiece.body.end());
  const auto is_inside = [&](double depth) {
    // The shapes are those of the part; an inclined axis may enter in an image of it.
    const Point x = point_of_part(workpiece.jet->point_at(depth, 0.0), workpiece.images);
    return std::any_of(bodies.begin(), bodies.end(), [&](std::uint16_t body) {
      return contains(description.bodies[body].shape, x, description.dimension);
    });
  };
  // Particles beside an inclined axis are nearer to the nozzle than those on it.
  const double reach = 3.0 * workpiece.axis_spacing, step = workpiece.axis_spacing / 8.0;
  double outside = first - reach;
  if (is_inside(outside)) return first;
  while (!is_inside(outside + step))
    if ((outside += step) > first + reach) return first;
  return boundary_between(outside, outside + step, is_inside);
}

// Measures depths from where the axis enters the workpiece, wherever on it the jet aims: moves the
// aim along the axis to that face.
void aim_at_face(Workpiece& workpiece, const Case& description) {
  const double first = first_particle(workpiece);
  if (std::isinf(first)) return;
  JetAxis& jet = *workpiece.jet;
  const double face = find_face(workpiece, description, first);
  constexpr double rounding = 1e-6;  // of a spacing: the sizes of particles have single precision
  if (std::abs(face) < rounding * workpiece.axis_spacing) return;
  for (std::size_t a = 0; a < 3; ++a) jet.aim[a] += face * jet.along[a];
  jet.standoff += face;
}

// Returns the largest spacing beside the axis; a graded body is finer there.
double find_axis_spacing(const Workpiece& workpiece) {
  double largest = 0.0;
  for (std::size_t slot = 0; slot < workpiece.position.size(); ++slot) {
    if (is_beside_axis(*workpiece.jet, workpiece.position[slot], workpiece.size[slot]))
      largest = std::max(largest, workpiece.size[slot]);
  }
  return largest > 0.0 ? largest : workpiece.spacing;
}

std::vector<std::uint32_t> find_exit_region(const Workpiece& workpiece, const WorkpieceBody& body) {
  const double reach = std::max(2.0 * workpiece.jet->width, 4.0 * workpiece.axis_spacing);
  std::vector<std::uint32_t> region;
  for (std::uint32_t slot = 0; slot < workpiece.position.size(); ++slot) {
    if (workpiece.body[slot] != body.body) continue;
    const auto& x = workpiece.position[slot];
    if (std::hypot(workpiece.jet->distance(x), workpiece.jet->depth(x) - body.bottom) <= reach)
      region.push_back(slot);
  }
  return region;
}

void add_particle(Workpiece& workpiece, const Frame& initial, std::uint32_t row) {
  if (row < initial.id.size() / workpiece.images.count())
    workpiece.slot_of_id[initial.id[row]] = static_cast<std::uint32_t>(workpiece.position.size());
  workpiece.position.push_back(initial.position[row]);
  workpiece.mass.push_back(initial.mass[row]);
  workpiece.size.push_back(initial.spacing[row]);
  workpiece.total_mass += initial.mass[row];
  workpiece.spacing = std::max(workpiece.spacing, static_cast<double>(initial.spacing[row]));
}

WorkpieceBody describe(const Case& description, std::uint16_t number) {
  const Body& body = description.bodies[number];
  WorkpieceBody described;
  described.body = number;
  described.can_break =
      description.materials.at(static_cast<std::size_t>(body.material)).can_break();
  if (description.workpiece && body.name == workpiece_name)
    described.below =
        thickness_below(*description.workpiece) / std::cos(description.jets.back().angle);
  return described;
}

// Finds what the measurements need to know of each body beside the jet.
void describe_bodies(Workpiece& workpiece, const Case& description) {
  const std::set<std::uint16_t> numbers(workpiece.body.begin(), workpiece.body.end());
  for (const std::uint16_t number : numbers)
    workpiece.bodies.push_back(describe(description, number));
  if (!workpiece.jet) return;
  const JetAxis& jet = *workpiece.jet;
  for (WorkpieceBody& body : workpiece.bodies) {
    for (std::size_t slot = 0; slot < workpiece.position.size(); ++slot)
      if (workpiece.body[slot] == body.body &&
          jet.depth(workpiece.position[slot]) >= -jet.standoff &&
          is_beside_axis(jet, workpiece.position[slot], workpiece.size[slot]))
        body.is_in_way = true;
    body.bottom = find_bottom(workpiece, body.body);
    workpiece.bottom = std::max(workpiece.bottom, body.bottom);
    body.exit_region = find_exit_region(workpiece, body);
    const Jet& own = description.jets[workpiece.jet_index];
    const KerfAxes beside(JetAxis(own, description.dimension), own.traverse, description.dimension);
    body.sides = find_sides(workpiece, body.body, beside, workpiece.initial_body_piece);
  }
}

// Takes the axis of a jet, from which depths count, and the particles beside it.
void take_axis(Workpiece& workpiece, const Case& description, std::size_t number) {
  const Jet& jet = description.jets.at(number);
  workpiece.jet_index = static_cast<std::uint16_t>(number);
  workpiece.jet.emplace(jet, description.dimension);
  workpiece.jet_density = description.materials.at(static_cast<std::size_t>(jet.material)).density;
  workpiece.axis_spacing = find_axis_spacing(workpiece);
  aim_at_face(workpiece, description);
}

// Returns the edges of the domain through which solid leaves it, m.
Box exits_of(const Case& description) {
  constexpr double beyond_all = std::numeric_limits<double>::infinity();
  Box exits = description.domain;
  for (std::size_t a = 0; a < 3; ++a) {
    if (description.symmetry.minimum[a]) exits.minimum[a] = -beyond_all;
    if (description.symmetry.maximum[a]) exits.maximum[a] = beyond_all;
  }
  return exits;
}

}  // namespace

double Workpiece::below(int number) const {
  double sum = 0.0;
  for (const WorkpieceBody& one : bodies)
    if (number < 0 || one.body == number) sum += one.below;
  return sum;
}

Workpiece make_workpiece(const Case& description, const Frame& initial) {
  Workpiece workpiece;
  workpiece.dimension = description.dimension;
  workpiece.images = symmetry_images(description);
  workpiece.interaction_range = 2.0 * description.smoothing_ratio;
  const auto& bodies = description.bodies;
  const auto group = join_bodies(bodies);
  const auto target = find_targets(description, initial, group);
  for (std::uint32_t row = 0; row < initial.position.size(); ++row) {
    const std::size_t source = initial.source[row];
    if (source >= bodies.size() || !can_be_cut(bodies[source]) || !target[group[source]]) continue;
    // What is loose as laid out was never solid: no jet can break it
    // (analysis/loose_particles.hpp).
    if (initial.category[row] == Category::fractured) continue;
    add_particle(workpiece, initial, row);
    workpiece.material_piece.push_back(group[source]);
    workpiece.body.push_back(initial.source[row]);
    const auto material = static_cast<std::size_t>(bodies[source].material);
    workpiece.volume.push_back(workpiece.mass.back() / description.materials.at(material).density);
  }
  workpiece.jet_source = static_cast<std::uint16_t>(bodies.size());
  workpiece.jet_count = static_cast<int>(description.jets.size());
  if (workpiece.empty()) return workpiece;
  if (!description.jets.empty()) {
    workpiece.jets = axes_of_jets(description, workpiece.images);
    take_axis(workpiece, description, 0);
    unite_bodies(description, workpiece);
  }
  if (initial.piece.empty()) workpiece.bonds = find_bonds(workpiece);
  Pieces pieces = find_pieces(workpiece, initial, locate(workpiece, initial));
  workpiece.initially_in_piece = pieces.in_piece;
  workpiece.initial_body_piece = pieces.body_piece;
  workpiece.initial_pieces = pieces.count;
  describe_bodies(workpiece, description);
  workpiece.exits = exits_of(description);
  workpiece.drift = drift_of(description, workpiece);
  return workpiece;
}

Workpiece along_jet(const Workpiece& workpiece, const Case& description, std::size_t jet) {
  Workpiece along = workpiece;
  along.bodies.clear();
  along.bottom = 0.0;
  take_axis(along, description, jet);
  describe_bodies(along, description);
  return along;
}

std::vector<std::uint32_t> locate(const Workpiece& workpiece, const Frame& frame) {
  std::vector<std::uint32_t> rows(workpiece.position.size(), Workpiece::none);
  const std::uint32_t images = workpiece.images.count();
  const auto slots = static_cast<std::uint32_t>(rows.size() / images);
  const auto once = static_cast<std::uint32_t>(frame.id.size() / images);
  for (std::uint32_t row = 0; row < once; ++row) {
    const auto found = workpiece.slot_of_id.find(frame.id[row]);
    if (found == workpiece.slot_of_id.end()) continue;
    for (std::uint32_t image = 0; image < images; ++image)
      rows[image * slots + found->second] = image * once + row;
  }
  return rows;
}

}  // namespace kerf
