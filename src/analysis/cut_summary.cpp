// SPDX-License-Identifier: Apache-2.0
// The numbers of a cut over the run, from the history of its states.
#include <algorithm>

#include "analysis/cut.hpp"
#include "analysis/line_slope.hpp"
#include "analysis/workpiece.hpp"

namespace kerf {
namespace {

// Returns the mean speed of the front, m/s.
double mean_front_speed(const std::vector<CutState>& states) {
  return line_slope(
      states, [](const CutState& state) { return state.time; },
      [](const CutState& state) { return state.front_depth; });
}

}  // namespace

CutSummary CutMonitor::summary() const {
  CutSummary summary;
  if (history_.empty()) return summary;
  summary.last = history_.back();
  summary.fragments = traced_.fragments;
  for (const CutState& state : history_)
    summary.pressed_share = std::max(summary.pressed_share, state.pressed_share);
  for (std::size_t slot = 0; slot < traced_.traces.size(); ++slot)
    if (traced_.traces[slot] == slot_trace::left_whole)
      summary.mass_left_whole += workpiece_->mass[slot];
  if (summary.mass_left_whole > 0.0) summary.traces = traced_.traces;
  summary.pieces_since =
      std::find_if(history_.rbegin(), history_.rend(),
                   [&](const CutState& state) { return state.pieces != summary.last.pieces; })
          .base()
          ->time;
  summary.initial_pieces = workpiece_->initial_pieces;
  add_verdicts(summary);
  const auto touch = std::find_if(history_.begin(), history_.end(),
                                  [](const CutState& state) { return state.is_touched_by_first; });
  if (touch != history_.end()) summary.first_touch_time = touch->time;
  const double end = summary.cut_through ? summary.cut_through_time : summary.last.time;
  summary.is_of_other_jet =
      workpiece_->jet_count > 1 && (summary.cut_jet != 0 || !(summary.first_touch_time <= end));
  std::vector<CutState> cutting;
  for (const CutState& state : history_) {
    if (state.front_depth > 0.0 && state.front_depth >= contact_depth_) cutting.push_back(state);
    if (state.front_depth > 0.0 &&
        state.front_depth >= workpiece_->bottom - workpiece_->axis_spacing)
      break;
  }
  if (!cutting.empty()) summary.contact_time = cutting.front().time;
  summary.front_speed = mean_front_speed(cutting);
  return summary;
}

// Adds when and how the bodies and the workpiece were cut through.
void CutMonitor::add_verdicts(CutSummary& summary) const {
  summary.severed = summary.punched = true;
  for (std::size_t n = 0; n < workpiece_->bodies.size(); ++n) {
    const WorkpieceBody& body = workpiece_->bodies[n];
    BodyVerdict verdict{body.body, body.is_in_way, body.can_break, history_.back().bodies.at(n)};
    const auto cut = std::find_if(history_.begin(), history_.end(), [n](const CutState& state) {
      return state.bodies.at(n).through;
    });
    if (cut != history_.end()) verdict.time = cut->time;
    if (body.is_in_way) {
      summary.severed = summary.severed && verdict.cut.severed;
      summary.punched = summary.punched && verdict.cut.punched;
    }
    summary.bodies.push_back(verdict);
  }
  const auto through = std::find_if(history_.begin(), history_.end(),
                                    [](const CutState& state) { return state.cut_through; });
  summary.cut_through = through != history_.end();
  summary.severed = summary.severed && summary.cut_through;
  summary.punched = summary.punched && summary.cut_through;
  if (workpiece_->bottom > 0.0)
    summary.front_share_at_end = summary.last.front_depth / workpiece_->bottom;
  summary.removed_share_at_end = summary.last.removed_share();
  if (!summary.cut_through) return;
  summary.cut_through_time = through->time;
  summary.cut_jet = through->cut_jet;
  const Workpiece& cut = workpiece_along(summary.cut_jet);
  const double front = summary.cut_jet == 0 ? through->front_depth : through->cut_front;
  summary.cut_through_place = cut.jet->point_at(front, through->time);
  if (cut.bottom > 0.0) {
    summary.front_share_at_cut = front / cut.bottom;
    const double pressed = 0.5 * std::min(cut.jet->width, cut.bottom);
    summary.greatest_share = 1.0 + std::max(pressed, cut.axis_spacing) / cut.bottom;
  }
  if (summary.cut_jet != 0) return;  // the opening and the front of the history are of the first
  summary.removed_share_at_cut = through->removed_share();
  const auto passed = std::find_if(through, history_.end(), [&](const CutState& state) {
    return state.front_depth >= cut.bottom - cut.axis_spacing;
  });
  if (passed != history_.end()) summary.water_through_time = passed->time;
}

}  // namespace kerf
