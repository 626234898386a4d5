// SPDX-License-Identifier: Apache-2.0
#include "machine/travelling_frame.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "model/case.hpp"

namespace kerf {

namespace {

// Moves a box along an axis, m.
Box moved(Box box, std::size_t axis, double by) {
  box.minimum[axis] += by;
  box.maximum[axis] += by;
  return box;
}

}  // namespace

std::uint64_t TravellingFrame::shifts_due(double time) const {
  const double whole = std::floor(speed * (time - start) / shift);
  return whole > 0.0 ? std::min(most, static_cast<std::uint64_t>(whole)) : 0;
}

double TravellingFrame::offset(std::uint64_t shifts) const {
  return sign * shift * static_cast<double>(shifts);
}

Box TravellingFrame::window(std::uint64_t shifts) const {
  return moved(first, axis, offset(shifts));
}

double TravellingFrame::end_time() const {
  return start + shift * (static_cast<double>(most) + 1.0) / speed;
}

double coarsest_cell(const WorkpieceSetting& workpiece) {
  return std::ldexp(workpiece.spacing, workpiece.levels);
}

double usual_shift(const WorkpieceSetting& workpiece, std::size_t axis) {
  const double cell = coarsest_cell(workpiece);
  const double length = workpiece.part.maximum[axis] - workpiece.part.minimum[axis];
  return cell * std::max(1.0, std::floor(length / shifts_per_window / cell + 1e-6));
}

TravellingFrame travelling_frame(const WorkpieceSetting& workpiece, const Jet& jet) {
  constexpr double slack = 1e-6;  // of a cell
  TravellingFrame frame;
  frame.axis = std::abs(jet.traverse[0]) >= std::abs(jet.traverse[2]) ? 0 : 2;
  const std::size_t a = frame.axis;
  frame.sign = jet.traverse[a] < 0.0 ? -1.0 : 1.0;
  frame.speed = std::abs(jet.traverse[a]);
  frame.start = jet.start + jet.dwell;
  frame.shift = workpiece.shift;
  frame.first = frame.path = workpiece.part;
  const double cell = coarsest_cell(workpiece), edge = 0.5 * workpiece.size[a];
  const double room =
      frame.sign > 0.0 ? edge - frame.first.minimum[a] : frame.first.maximum[a] + edge;
  const double length = cell * std::floor(room / cell + slack);
  if (frame.sign > 0.0)
    frame.path.maximum[a] = frame.path.minimum[a] + length;
  else
    frame.path.minimum[a] = frame.path.maximum[a] - length;
  const double ahead = length - (frame.first.maximum[a] - frame.first.minimum[a]);
  if (frame.shift > 0.0 && ahead > 0.0)
    frame.most = static_cast<std::uint64_t>(ahead / frame.shift + slack);
  return frame;
}

std::optional<TravellingFrame> travelling_frame(const Case& description) {
  if (!description.workpiece || description.workpiece->frame != WorkpieceFrame::travelling)
    return {};
  require(!description.jets.empty(), "a window travels with the nozzle of a machine");
  return travelling_frame(*description.workpiece, description.jets.back());
}

Case at_shift(const Case& description, std::uint64_t shifts) {
  Case shifted = description;
  const auto frame = travelling_frame(description);
  if (!frame || shifts == 0) return shifted;
  const std::size_t a = frame->axis;
  const double offset = frame->offset(shifts);
  shifted.domain = moved(shifted.domain, a, offset);
  shifted.workpiece->part = frame->window(shifts);
  Box& box = shifted.bodies.front().shape.box;
  box.minimum[a] = shifted.workpiece->part.minimum[a];
  box.maximum[a] = shifted.workpiece->part.maximum[a];
  Jet& jet = shifted.jets.back();
  const double rear = frame->sign > 0.0 ? frame->first.minimum[a] : frame->first.maximum[a];
  const double behind = std::max(0.0, frame->sign * (jet.position[a] - rear) - 2.0 * jet.width);
  const double ahead = std::max(0.0, std::abs(offset) - behind);
  jet.position[a] += frame->sign * ahead;
  jet.dwell += ahead / frame->speed;
  return shifted;
}

Case at_time(const Case& description, double time) {
  const auto frame = travelling_frame(description);
  return frame ? at_shift(description, frame->shifts_due(time)) : description;
}

}  // namespace kerf
