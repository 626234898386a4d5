// SPDX-License-Identifier: Apache-2.0
// Checks of a workpiece whose window travels with the nozzle.
#include <fmt/format.h>

#include <cmath>

#include "geometry/graded_cells.hpp"
#include "input/draft.hpp"
#include "input/units.hpp"
#include "machine/travelling_frame.hpp"
#include "model/case.hpp"

namespace kerf {

namespace {

constexpr double slack = 1e-6;  // of a cell

std::string length_text(double length) {
  return fmt::format("{:.6g} m", length);
}

void add(Draft& draft, std::string_view key, const std::string& what, const std::string& allowed,
         const std::string& remedy) {
  draft.reading.problems.add({std::string(key), what, allowed, remedy});
}

// Refuses a nozzle that does not travel along an axis.
void check_nozzle(Draft& draft) {
  const Machine& machine = *draft.result.machine;
  const Point& direction = machine.traverse_direction;
  if (machine.motion == NozzleMotion::standing)
    add(draft, "machine.motion", "the frame of the workpiece travels with the nozzle",
        "\"travelling\" or \"auto\"", "Remove the key, or set workpiece.frame to \"fixed\"");
  if (machine.traverse_speed == 0.0)
    add(draft, "machine.traverse_speed", "a frame that travels needs a nozzle that does",
        "a speed greater than 0 m/s",
        "Write the feed of the nozzle, or set workpiece.frame to \"fixed\"");
  if (direction[0] != 0.0 && direction[2] != 0.0)
    add(draft, "machine.traverse_direction", "a frame travels along an axis of the case",
        "along x or z", "Turn the workpiece so that the nozzle travels along x");
}

}  // namespace

void check_travel(Draft& draft, Section& top, Section& section) {
  check_nozzle(draft);
  const std::string fixed = ", or set workpiece.frame to \"fixed\"";
  for (const char* list : {"body", "load", "jet"})
    if (top.has(list))
      top.refuse(list, "the frame of the workpiece travels, and only its own solid is fed in",
                 "Remove it" + fixed, "none where workpiece.frame is \"travelling\"");
  if (draft.reading.dimension == 2 && draft.workpiece.setting.levels > 0)
    section.refuse("levels", "in 2D no distance across the path of the nozzle exists",
                   "Remove the key" + fixed, "0 where a 2D frame travels");
  const MaterialDraft* entry = use_material(draft, section, draft.workpiece.material);
  if (entry != nullptr && entry->material.criterion == BondCriterion::grady_kipp)
    section.refuse(
        "material",
        "the flaws of \"grady_kipp\" belong to the order of the particles, which a frame "
        "that travels changes",
        "Choose another criterion" + fixed, "a material without flaws");
}

void check_window(Draft& draft, Section& section) {
  const WorkpieceSetting& workpiece = draft.workpiece.setting;
  const TravellingFrame frame = travelling_frame(workpiece, draft.jets.back().jet);
  const double cell = coarsest_cell(workpiece);
  const double length = frame.first.maximum[frame.axis] - frame.first.minimum[frame.axis];
  const std::string cells = "whole coarsest cells of " + length_text(cell);
  if (!is_whole(length, cell))
    section.refuse(section.has("maximum") ? "maximum" : "minimum",
                   fmt::format("the window is {} long", length_text(length)), "Correct the corners",
                   cells);
  if (!is_whole(workpiece.shift, cell) || workpiece.shift > length)
    section.refuse("shift", "the window cannot move by " + length_text(workpiece.shift),
                   "Correct it or remove the key",
                   cells + ", and no more than the window of " + length_text(length));
  const Faces& planes = draft.result.symmetry;
  if (planes.minimum[frame.axis] || planes.maximum[frame.axis])
    add(draft, "domain.symmetry", "the frame of the workpiece travels through this plane",
        "planes along the path of the nozzle",
        "Remove the plane, or set workpiece.frame to \"fixed\"");
  if (frame.most == 0)
    section.refuse("size", "ahead of the window there is no room for a shift",
                   "Enlarge the workpiece, move the position of the machine back, or set "
                   "workpiece.frame to \"fixed\"",
                   fmt::format("a window of {} and a shift of {} within the workpiece",
                               length_text(length), length_text(workpiece.shift)));
}

void check_travelling_time(Draft& draft, Section& section) {
  const TimeControl& time = draft.result.time;
  const bool travels =
      draft.workpiece.setting.frame == WorkpieceFrame::travelling && draft.result.workpiece;
  if (!travels) {
    // A frame without its workpiece has a problem that is told already.
    const bool has_frame = draft.workpiece.setting.frame == WorkpieceFrame::travelling;
    if (time.stop == RunStop::stationary && !has_frame)
      section.refuse("stop", "no frame travels",
                     "Set workpiece.frame to \"travelling\", or remove it",
                     "\"end\" where workpiece.frame is not \"travelling\"");
    return;
  }
  if (time.relax > 0.0)
    section.refuse("relax", "the frame of the workpiece travels", "Remove the key",
                   "0 s where workpiece.frame is \"travelling\"");
  const double last = travelling_frame(draft.workpiece.setting, draft.jets.back().jet).end_time();
  if (time.end > last * (1.0 + slack))
    section.refuse("end", "the window reaches the edge of the workpiece before",
                   "End earlier, enlarge the workpiece, or move the position of the machine back",
                   fmt::format("at most {:.6g} s", last));
}

}  // namespace kerf
