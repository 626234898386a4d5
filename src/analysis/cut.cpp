// SPDX-License-Identifier: Apache-2.0
#include "analysis/cut.hpp"

#include <algorithm>

#include "analysis/cut_width.hpp"
#include "analysis/front.hpp"
#include "analysis/pieces.hpp"
#include "analysis/workpiece.hpp"
#include "model/case.hpp"

namespace kerf {
namespace {

// Returns the slope of the least-squares line through (time, front depth), m/s.
double slope(const std::vector<CutState>& states) {
  if (states.size() < 2) return 0.0;
  const double count = static_cast<double>(states.size());
  double mean_time = 0.0, mean_depth = 0.0;
  for (const CutState& state : states) {
    mean_time += state.time / count;
    mean_depth += state.front_depth / count;
  }
  double product = 0.0, square = 0.0;
  for (const CutState& state : states) {
    product += (state.time - mean_time) * (state.front_depth - mean_depth);
    square += (state.time - mean_time) * (state.time - mean_time);
  }
  return square > 0.0 ? product / square : 0.0;
}

double fractured_mass(const Workpiece& workpiece, const Frame& frame,
                      const std::vector<std::uint32_t>& rows) {
  double sum = 0.0;
  for (std::size_t slot = 0; slot < rows.size(); ++slot)
    if (!is_intact(frame, rows[slot])) sum += workpiece.mass[slot];
  return sum;
}

}  // namespace

CutMonitor::CutMonitor(const Case& description, const Frame& initial)
    : workpiece_(std::make_shared<const Workpiece>(make_workpiece(description, initial))),
      contact_depth_(description.jets.empty() ? 0.0 : description.jets.front().spacing) {}

CutState CutMonitor::observe(const Frame& frame) {
  const Workpiece& workpiece = *workpiece_;
  CutState state;
  state.time = frame.time;
  if (!workpiece.empty()) {
    const auto rows = locate(workpiece, frame);
    Pieces pieces = find_pieces(workpiece, frame, rows);
    state.pieces = pieces.count;
    state.fractured_mass = fractured_mass(workpiece, frame, rows);
    state.fractured_fraction = state.fractured_mass / workpiece.total_mass;
    state.front_depth = front_depth(workpiece, frame);
    if (workpiece.jet && state.front_depth > 0.0) {
      const double half = state.front_depth / 2.0;
      state.fractured_width = fractured_width(workpiece, frame, rows, half);
      state.kerf_width = kerf_width(workpiece, frame, rows, pieces.in_piece, half);
      const bool severed = pieces.count > std::max(1, workpiece.initial_pieces);
      const bool holed =
          state.front_depth >= bottom_depth(workpiece, frame, rows) - workpiece.axis_spacing;
      state.cut_through = severed || holed;
    }
    fragments_ = std::move(pieces.fragments);
  }
  if (!history_.empty() && history_.back().cut_through) state.cut_through = true;
  history_.push_back(state);
  return state;
}

CutSummary CutMonitor::summary() const {
  CutSummary summary;
  if (history_.empty()) return summary;
  summary.last = history_.back();
  summary.fragments = fragments_;
  const auto through = std::find_if(history_.begin(), history_.end(),
                                    [](const CutState& state) { return state.cut_through; });
  if (through != history_.end()) {
    summary.cut_through = true;
    summary.cut_through_time = through->time;
    summary.severed = through->pieces > std::max(1, workpiece_->initial_pieces);
    if (workpiece_->jet)
      summary.cut_through_place = workpiece_->jet->point_at(through->front_depth, through->time);
  }
  std::vector<CutState> cutting;
  for (const CutState& state : history_) {
    if (state.front_depth > 0.0 && state.front_depth >= contact_depth_) cutting.push_back(state);
    if (state.front_depth > 0.0 &&
        state.front_depth >= workpiece_->bottom - workpiece_->axis_spacing)
      break;
  }
  if (!cutting.empty()) summary.contact_time = cutting.front().time;
  summary.front_speed = slope(cutting);
  return summary;
}

void CutMonitor::restore(std::vector<CutState> history, const Frame& last) {
  history_ = std::move(history);
  if (!workpiece_->empty())
    fragments_ = find_pieces(*workpiece_, last, locate(*workpiece_, last)).fragments;
}

}  // namespace kerf
