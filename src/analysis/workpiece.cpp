// SPDX-License-Identifier: Apache-2.0
#include "analysis/workpiece.hpp"

#include <algorithm>
#include <boost/pending/disjoint_sets.hpp>

#include "analysis/pieces.hpp"
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
    const double reach = std::max(jet.width / 2.0, static_cast<double>(initial.spacing[row]));
    const auto& x = initial.position[row];
    if (jet.distance(x) <= reach && jet.depth(x) >= -jet.standoff) hit[group[source]] = 1;
  }
  return hit;
}

// Returns the depth at which the axis leaves the solid: that of the deepest particle within a
// spacing of it.
double find_bottom(const Workpiece& workpiece) {
  double bottom = 0.0;
  for (std::size_t slot = 0; slot < workpiece.position.size(); ++slot)
    if (workpiece.jet->distance(workpiece.position[slot]) <= workpiece.size[slot])
      bottom = std::max(
          bottom, workpiece.jet->depth(workpiece.position[slot]) + workpiece.size[slot] / 2.0);
  return bottom;
}

// Returns the largest spacing beside the axis; a graded body is finer there.
double find_axis_spacing(const Workpiece& workpiece) {
  double largest = 0.0;
  for (std::size_t slot = 0; slot < workpiece.position.size(); ++slot) {
    const double reach = std::max(workpiece.jet->width / 2.0, workpiece.size[slot]);
    if (workpiece.jet->distance(workpiece.position[slot]) <= reach)
      largest = std::max(largest, workpiece.size[slot]);
  }
  return largest > 0.0 ? largest : workpiece.spacing;
}

std::vector<std::uint32_t> find_exit_region(const Workpiece& workpiece) {
  const double reach = std::max(2.0 * workpiece.jet->width, 4.0 * workpiece.axis_spacing);
  std::vector<std::uint32_t> region;
  for (std::uint32_t slot = 0; slot < workpiece.position.size(); ++slot) {
    const auto& x = workpiece.position[slot];
    if (std::hypot(workpiece.jet->distance(x), workpiece.jet->depth(x) - workpiece.bottom) <= reach)
      region.push_back(slot);
  }
  return region;
}

void add_particle(Workpiece& workpiece, const Frame& initial, std::uint32_t row) {
  workpiece.slot_of_id[initial.id[row]] = static_cast<std::uint32_t>(workpiece.position.size());
  workpiece.position.push_back(initial.position[row]);
  workpiece.mass.push_back(initial.mass[row]);
  workpiece.size.push_back(initial.spacing[row]);
  workpiece.total_mass += initial.mass[row];
  workpiece.spacing = std::max(workpiece.spacing, static_cast<double>(initial.spacing[row]));
}

}  // namespace

Workpiece make_workpiece(const Case& description, const Frame& initial) {
  Workpiece workpiece;
  const auto& bodies = description.bodies;
  const auto group = join_bodies(bodies);
  const auto target = find_targets(description, initial, group);
  for (std::uint32_t row = 0; row < initial.position.size(); ++row) {
    const std::size_t source = initial.source[row];
    if (source >= bodies.size() || !can_be_cut(bodies[source]) || !target[group[source]]) continue;
    add_particle(workpiece, initial, row);
    workpiece.material_piece.push_back(group[source]);
    workpiece.body.push_back(initial.source[row]);
    const auto material = static_cast<std::size_t>(bodies[source].material);
    workpiece.volume.push_back(workpiece.mass.back() / description.materials.at(material).density);
  }
  if (workpiece.empty()) return workpiece;
  workpiece.bonds = find_bonds(workpiece);
  Pieces pieces = find_pieces(workpiece, initial, locate(workpiece, initial));
  workpiece.initial_pieces = pieces.count;
  workpiece.initially_in_piece = std::move(pieces.in_piece);
  if (description.jets.empty()) return workpiece;
  const Jet& jet = description.jets.front();
  workpiece.jet.emplace(jet, description.dimension);
  workpiece.jet_source = static_cast<std::uint16_t>(bodies.size());
  workpiece.jet_density = description.materials.at(static_cast<std::size_t>(jet.material)).density;
  workpiece.axis_spacing = find_axis_spacing(workpiece);
  workpiece.bottom = find_bottom(workpiece);
  workpiece.exit_region = find_exit_region(workpiece);
  return workpiece;
}

std::vector<std::uint32_t> locate(const Workpiece& workpiece, const Frame& frame) {
  std::vector<std::uint32_t> rows(workpiece.position.size(), Workpiece::none);
  for (std::uint32_t row = 0; row < frame.id.size(); ++row) {
    const auto found = workpiece.slot_of_id.find(frame.id[row]);
    if (found != workpiece.slot_of_id.end()) rows[found->second] = row;
  }
  return rows;
}

}  // namespace kerf
