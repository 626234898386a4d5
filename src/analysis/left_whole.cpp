// SPDX-License-Identifier: Apache-2.0
#include "analysis/left_whole.hpp"

#include <algorithm>

#include "analysis/cut.hpp"
#include "geometry/cell_grid.hpp"

namespace kerf {

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
  using Place = CellGrid<3>::Position;
  std::vector<Place> left;
  for (std::size_t slot = 0; slot < standing.size(); ++slot)
    if (traces[slot] == slot_trace::left_whole) {
      standing[slot] = stands_as_laid_out;
      left.push_back(Place::from(workpiece.position[slot]));
    }
  if (left.empty()) return standing;
  const double reach = workpiece.interaction_range * workpiece.spacing;
  const CellGrid<3> near(left, reach);
  for (std::size_t slot = 0; slot < standing.size(); ++slot) {
    if (standing[slot] != 1) continue;
    const Place place = Place::from(workpiece.position[slot]);
    near.visit_near(place, [&](std::size_t other) {
      if (norm(left[other] - place) < reach) standing[slot] = stands_as_laid_out;
    });
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
