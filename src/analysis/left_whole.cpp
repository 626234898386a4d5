// SPDX-License-Identifier: Apache-2.0
#include "analysis/left_whole.hpp"

#include <algorithm>
#include <set>

#include "analysis/cut.hpp"
#include "geometry/cell_grid.hpp"

namespace kerf {
namespace {

using Place = CellGrid<3>::Position;

// The places, as laid out, of the solid that has left the domain whole.
std::vector<Place> places_that_left(const Workpiece& workpiece,
                                    const std::vector<std::uint8_t>& traces) {
  std::vector<Place> left;
  for (std::size_t slot = 0; slot < traces.size(); ++slot)
    if (traces[slot] == slot_trace::left_whole)
      left.push_back(Place::from(workpiece.position[slot]));
  return left;
}

bool is_near_any(const CellGrid<3>& cells, const std::vector<Place>& places, const Place& place,
                 double reach) {
  bool is_near = false;
  cells.visit_near(place,
                   [&](std::size_t n) { is_near = is_near || norm(places[n] - place) < reach; });
  return is_near;
}

// Returns whether a particle lies within a reach, m, of an edge through which solid leaves.
bool is_at_edge(const Workpiece& workpiece, const std::array<double, 3>& x, double reach) {
  for (std::size_t a = 0; a < static_cast<std::size_t>(workpiece.dimension); ++a)
    if (x[a] < workpiece.exits.minimum[a] + reach || x[a] > workpiece.exits.maximum[a] - reach)
      return true;
  return false;
}

}  // namespace

void keep_divided(const Workpiece& workpiece, const Frame& frame,
                  const std::vector<std::uint32_t>& rows,
                  const std::vector<std::uint32_t>& body_piece,
                  const std::vector<std::uint8_t>& traces, std::vector<std::uint8_t>& standing) {
  std::vector<std::uint8_t> until_now = traces;
  for (std::size_t slot = 0; slot < rows.size(); ++slot)
    if (rows[slot] == Workpiece::none && traces[slot] != 0)
      until_now[slot] = slot_trace::left_whole;
  const std::vector<Place> left = places_that_left(workpiece, until_now);
  if (left.empty()) return;
  const double reach = workpiece.interaction_range * workpiece.spacing;
  const CellGrid<3> cells(left, reach);
  // The images come after the part, whose edges those of the domain are.
  const std::size_t once = frame.id.size() / workpiece.images.count();
  const auto is_loose = [&](std::size_t slot) {
    return standing[slot] == 0 && traces[slot] == slot_trace::stood && is_intact(frame, rows[slot]);
  };
  std::set<std::uint32_t> divided;
  for (std::size_t slot = 0; slot < rows.size(); ++slot)
    if (is_loose(slot) && is_at_edge(workpiece, frame.position[rows[slot] % once], reach) &&
        is_near_any(cells, left, Place::from(workpiece.position[slot]), reach))
      divided.insert(body_piece[slot]);
  for (std::size_t slot = 0; slot < rows.size(); ++slot)
    if (is_loose(slot) && divided.count(body_piece[slot]) != 0) standing[slot] = 1;
}

void note_traces(const std::vector<std::uint32_t>& rows, const std::vector<std::uint8_t>& standing,
                 std::vector<std::uint8_t>& traces) {
  for (std::size_t slot = 0; slot < rows.size(); ++slot) {
    const bool has_left = rows[slot] == Workpiece::none && traces[slot] != 0;
    traces[slot] = has_left ? slot_trace::left_whole : standing[slot] != 0 ? slot_trace::stood : 0;
  }
}

std::vector<std::uint8_t> closed_where_left(const Workpiece& workpiece,
                                            std::vector<std::uint8_t> standing,
                                            const std::vector<std::uint8_t>& traces) {
  const std::vector<Place> left = places_that_left(workpiece, traces);
  if (left.empty()) return standing;
  for (std::size_t slot = 0; slot < traces.size(); ++slot) {
    if (traces[slot] == slot_trace::left_whole) standing[slot] = stands_as_laid_out;
    if (traces[slot] == slot_trace::stood) standing[slot] = 1;
  }
  const double reach = workpiece.interaction_range * workpiece.spacing;
  const CellGrid<3> near(left, reach);
  for (std::size_t slot = 0; slot < standing.size(); ++slot) {
    if (standing[slot] != 1) continue;
    if (is_near_any(near, left, Place::from(workpiece.position[slot]), reach))
      standing[slot] = stands_as_laid_out;
  }
  return standing;
}

bool has_left(const WorkpieceBody& body, const KerfView& view,
              const std::vector<std::uint8_t>& traces) {
  constexpr double most_near = 0.25, most = 0.5;  // of the mass; the lips of a cut may leave, too
  const JetAxis& jet = *view.workpiece.jet;
  const double reach = std::max(jet.width, 2.0 * view.workpiece.axis_spacing);
  double near = 0.0, near_left = 0.0, all = 0.0, left = 0.0;
  for (std::size_t slot = 0; slot < traces.size(); ++slot) {
    if (view.workpiece.body[slot] != body.body) continue;
    const double mass = view.workpiece.mass[slot];
    const double gone = traces[slot] == slot_trace::left_whole ? mass : 0.0;
    all += mass;
    left += gone;
    if (jet.distance(jet.swept(view.workpiece.position[slot], view.frame.time)) > reach) continue;
    near += mass;
    near_left += gone;
  }
  return near_left > most_near * near || left > most * all;
}

}  // namespace kerf
