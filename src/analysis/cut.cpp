// SPDX-License-Identifier: Apache-2.0
#include "analysis/cut.hpp"

#include <algorithm>

#include "analysis/cut_depth.hpp"
#include "analysis/front.hpp"
#include "analysis/kerf_map.hpp"
#include "analysis/left_whole.hpp"
#include "analysis/opening_width.hpp"
#include "analysis/pieces.hpp"
#include "analysis/torn_mass.hpp"
#include "analysis/workpiece.hpp"
#include "core/error.hpp"
#include "model/case.hpp"

namespace kerf {
namespace {

// Returns the depth of the front of the water of all jets, m; `of_first` is that of the first.
double front_of_all(const Workpiece& workpiece, const Frame& frame, double face, double of_first) {
  return workpiece.jet_count == 1 ? of_first
                                  : front_depth(workpiece, frame, face, WaterOf::all_jets);
}

double fractured_mass(const Workpiece& workpiece, const Frame& frame,
                      const std::vector<std::uint32_t>& rows) {
  double sum = 0.0;
  for (std::size_t slot = 0; slot < rows.size(); ++slot)
    if (!is_intact(frame, rows[slot])) sum += workpiece.mass[slot];
  return sum;
}

// Takes over what a state keeps of the one before it.
void carry_on(const CutState& last, CutState& state) {
  state.bodies = last.bodies;
  state.cut_through = last.cut_through;
  state.cut_depth = last.cut_depth;
  state.cut_jet = last.cut_jet;
  state.cut_front = last.cut_front;
  state.is_touched = last.is_touched;
  state.is_touched_by_first = last.is_touched_by_first;
}

}  // namespace

CutMonitor::CutMonitor(const Case& description, const Frame& initial)
    : contact_depth_(description.jets.empty() ? 0.0 : description.jets.front().spacing),
      has_wake_(description.workpiece &&
                description.workpiece->frame == WorkpieceFrame::travelling),
      rigid_(resting_rigid_shapes(description)) {
  take(description, initial);
}

void CutMonitor::follow(const Case& shifted, const Frame& layout) {
  take(shifted, layout);
}

void CutMonitor::take(const Case& description, const Frame& initial) {
  const SymmetryImages images = symmetry_images(description);
  workpiece_ = std::make_shared<const Workpiece>(
      make_workpiece(description, WholeFrame(initial, images).get()));
  // Of the layout at the start all stands; of a later window it is not known.
  traced_.traces.assign(workpiece_->position.size(), history_.empty() ? slot_trace::stood : 0);
  if (!workpiece_->jet) return;
  axes_.emplace(*workpiece_->jet, description.jets.front().traverse, description.dimension);
  ways_.assign(1, {workpiece_, *axes_});
  for (std::size_t n = 1; n < description.jets.size(); ++n) {
    const auto along = std::make_shared<const Workpiece>(along_jet(*workpiece_, description, n));
    ways_.push_back(
        {along, KerfAxes(*along->jet, description.jets[n].traverse, description.dimension)});
  }
  near_jets_ = mark_near_jets(*workpiece_);
  opening_lines_ = opening_lines(description, *workpiece_->jet);
}

double CutMonitor::contact_time(double now) const {
  const auto contact = std::find_if(history_.begin(), history_.end(),
                                    [](const CutState& state) { return state.front_depth > 0.0; });
  return contact == history_.end() ? now : contact->time;
}

CutState CutMonitor::observe(const Frame& frame, const std::array<double, 3>& water_impulse) {
  history_.push_back(measure(frame, water_impulse, traced_));
  return history_.back();
}

CutState CutMonitor::state_at(const Frame& frame,
                              const std::array<double, 3>& water_impulse) const {
  Traced traced = traced_;
  return measure(frame, water_impulse, traced);
}

CutState CutMonitor::measure(const Frame& part, const std::array<double, 3>& water_impulse,
                             Traced& traced) const {
  const Workpiece& workpiece = *workpiece_;
  CutState state;
  state.time = part.time;
  state.bodies.resize(workpiece.bodies.size());
  if (!history_.empty()) carry_on(history_.back(), state);
  if (!workpiece.empty()) {
    const WholeFrame whole(part, workpiece.images);
    const Frame& frame = whole.get();
    const auto rows = locate(workpiece, frame);
    Pieces pieces = find_pieces(workpiece, frame, rows);
    state.pieces = pieces.count;
    state.fractured_mass = fractured_mass(workpiece, frame, rows);
    state.fractured_fraction = state.fractured_mass / workpiece.total_mass;
    const double face = face_depth(workpiece, frame, rows);
    state.front_depth = front_depth(workpiece, frame, face);
    const double any_front = front_of_all(workpiece, frame, face, state.front_depth);
    state.pressed_share = pressed_share(workpiece, frame, rows, rigid_);
    auto standing = find_standing(workpiece, frame, rows, pieces.in_piece);
    keep_divided(workpiece, frame, rows, pieces.body_piece, traced.traces, standing);
    note_traces(rows, standing, traced.traces);
    if (has_wake_ && axes_) {
      state.wake = measure_wake({workpiece, frame, rows, standing}, *axes_);
      state.water_impulse = KerfAxes::dot(water_impulse, axes_->jet.along);
    }
    if (workpiece.jet && state.front_depth > 0.0) {
      // Below the workpiece there is no opening.
      const double half = std::min(state.front_depth, workpiece.bottom) / 2.0;
      const OpeningWidths widths = measure_opening(
          workpiece, frame, rows, pieces.in_piece,
          {opening_lines_, opening_places(workpiece, contact_time(frame.time), frame.time), half,
           half + face});
      state.fractured_width = widths.fractured;
      state.kerf_width = widths.open;
      state.void_width = widths.laid_out;
    }
    const bool touches = note_touch(frame, rows, any_front, state);
    if (state.is_touched) {
      const auto closed = closed_where_left(workpiece, standing, traced.traces);
      const KerfView view{workpiece, frame, rows, closed};
      note_torn(view, near_jets_, state.bodies);
      if (touches && !state.cut_through) judge_bodies(view, pieces, traced.traces, state);
      if (touches)
        state.cut_depth = std::max(state.cut_depth, measure_cut_depth(view, *axes_, state.bodies));
    }
    traced.fragments = std::move(pieces.fragments);
  } else if (workpiece.jet_count > 1 && !state.is_touched_by_first) {
    state.is_touched_by_first = touches_water(workpiece, part, {}, WaterOf::own_jet);
  }
  return state;
}

bool CutMonitor::note_touch(const Frame& frame, const std::vector<std::uint32_t>& rows,
                            double front, CutState& state) const {
  if (!workpiece_->jet) return false;
  const bool is_touched = front > 0.0 || touches_water(*workpiece_, frame, rows);
  state.is_touched = state.is_touched || is_touched;
  if (is_touched && !state.is_touched_by_first)
    state.is_touched_by_first = workpiece_->jet_count == 1 || state.front_depth > 0.0 ||
                                touches_water(*workpiece_, frame, rows, WaterOf::own_jet);
  return is_touched;
}

void CutMonitor::restore(std::vector<CutState> history, const std::vector<std::uint8_t>& traces,
                         const Frame& last) {
  history_ = std::move(history);
  if (traces.size() == traced_.traces.size()) traced_.traces = traces;
  for (const CutState& state : history_)
    require(state.bodies.size() == workpiece_->bodies.size(), "every row has all bodies");
  if (workpiece_->empty()) return;
  const WholeFrame whole(last, workpiece_->images);
  traced_.fragments =
      find_pieces(*workpiece_, whole.get(), locate(*workpiece_, whole.get())).fragments;
}

}  // namespace kerf
