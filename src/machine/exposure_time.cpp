// SPDX-License-Identifier: Apache-2.0
// Times of a cut: for how long a jet covers a point of its path, and passes a workpiece.
#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/jet_direction.hpp"
#include "machine/simulated_piece.hpp"
#include "machine/travelling_frame.hpp"
#include "model/case.hpp"
#include "model/machine.hpp"

namespace kerf {

double passage_time(const Jet& jet, double thickness) {
  return (jet.standoff + 4.0 * thickness / std::cos(jet.angle)) / (jet.speed * jet.duty);
}

double exposure_time(const Machine& machine, const Jet& jet, int dimension) {
  if (machine.traverse_speed == 0.0) return std::numeric_limits<double>::infinity();
  return width_along(jet, machine.traverse_direction, dimension) / machine.traverse_speed;
}

double longest_stay(const Case& description) {
  const double end = description.time.end;
  const auto frame = travelling_frame(description);
  if (!frame) return end;
  const double length = frame->first.maximum[frame->axis] - frame->first.minimum[frame->axis];
  return std::min(end, length / frame->speed);
}

bool may_stand(const Machine& machine, const Jet& jet, double thickness, int dimension) {
  return exposure_time(machine, jet, dimension) > passage_time(jet, thickness);
}

bool stands_for_traverse(const Case& description) {
  return description.workpiece && description.machine &&
         description.machine->motion == NozzleMotion::standing &&
         description.machine->traverse_speed > 0.0;
}

}  // namespace kerf
