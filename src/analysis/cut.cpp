// SPDX-License-Identifier: Apache-2.0
#include "analysis/cut.hpp"

#include <algorithm>

#include "analysis/crack_path.hpp"
#include "analysis/cut_depth.hpp"
#include "analysis/front.hpp"
#include "analysis/kerf_map.hpp"
#include "analysis/left_whole.hpp"
#include "analysis/opening_width.hpp"
#include "analysis/pieces.hpp"
#include "analysis/plug.hpp"
#include "analysis/unbroken.hpp"
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

// Returns whether a body is parted where a nozzle that crosses the section has been since it began
// (2D): its sides are those beside a place of the path where all is torn.
bool is_parted_on_path(const KerfView& view, const Pieces& pieces, const KerfAxes& axes,
                       const KerfPath& path) {
  const auto body = static_cast<std::uint16_t>(view.body);
  for (const double place : torn_places(view, axes, path)) {
    KerfAxes there = axes;
    for (std::size_t a = 0; a < 3; ++a) there.jet.aim[a] += place * axes.unit_crosswise[a];
    for (const BodySides& sides :
         find_sides(view.workpiece, body, there, view.workpiece.initial_body_piece))
      if (joint_of(sides, view.workpiece, pieces.body_piece) == Joint::parted) return true;
  }
  return false;
}

// Returns whether the jet, where it is now, has punched a plug out of a body.
BodyCut judge_plug(const KerfView& view, const Pieces& pieces, const KerfAxes& axes) {
  KerfAxes here = axes;
  here.jet.aim = axes.jet.point_at(0.0, view.frame.time);
  const PlugState state =
      find_plug(view.workpiece, static_cast<std::uint16_t>(view.body), here, pieces);
  if (state == PlugState::held) return {};
  return {.through = true, .severed = true, .punched = state == PlugState::apart};
}

// What tells the fate of the bodies in a frame.
struct Evidence {
  const Pieces& pieces;
  const KerfAxes& axes;
  const std::vector<std::uint8_t>& traces;  // slot_trace
};

// Returns whether a body is cut through in a frame in which water of a jet touches or has entered
// the workpiece. `front`: depth of the front below the face as laid out, m.
BodyCut judge(const WorkpieceBody& body, const KerfView& view, const Evidence& evidence,
              double front) {
  const auto& pieces = evidence.pieces;
  const auto& axes = evidence.axes;
  const auto& traces = evidence.traces;
  BodyCut cut;
  if (!body.is_in_way) return cut;
  if (has_left(body, view, traces)) return {.left = true};
  if (!body.can_break || body.below > 0.0) return cut;
  if (const BodyCut plug = judge_plug(view, pieces, axes); plug.through) return plug;
  bool is_joined = false;
  for (const BodySides& sides : body.sides) {
    const Joint joint = joint_of(sides, view.workpiece, pieces.body_piece);
    if (joint == Joint::parted) return {.through = true, .severed = true};
    is_joined = is_joined || joint == Joint::joined;
  }
  const KerfPath path{{}, axes.way(view.frame.time)};
  if (view.workpiece.dimension == 2) {
    const bool is_cracked = std::any_of(
        body.sides.begin(), body.sides.end(),
        [&](const BodySides& sides) { return is_parted_by_crack(sides, view, axes, pieces); });
    if (is_cracked || (axes.moves() && is_parted_on_path(view, pieces, axes, path)))
      return {.through = true, .severed = true};
    // In the plane a chain of bonds between the sides crosses the axis of the jet.
    if (is_joined) return cut;
  }
  const UnbrokenThickness thickness = measure_unbroken(view, axes, path);
  const bool is_past = front >= bottom_depth(view.workpiece, body, view.frame, view.rows) -
                                    view.workpiece.axis_spacing;
  cut.through = thickness.is_open || (thickness.is_torn_through && is_past);
  return cut;
}

// Adds the verdict of a frame to that of the frames before it.
void judge_bodies(KerfView view, const Evidence& evidence, double front, CutState& state) {
  const Workpiece& workpiece = view.workpiece;
  bool all = true;
  for (std::size_t n = 0; n < workpiece.bodies.size(); ++n) {
    const WorkpieceBody& body = workpiece.bodies[n];
    view.body = body.body;
    if (!state.bodies[n].through && !state.bodies[n].left)
      state.bodies[n] = judge(body, view, evidence, front);
    all = all && (state.bodies[n].through || !body.is_in_way);
  }
  state.cut_through = all;
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
  if (!history_.empty()) {
    const CutState& last = history_.back();
    state.bodies = last.bodies;
    state.cut_through = last.cut_through;
    state.cut_depth = last.cut_depth;
    state.is_touched = last.is_touched;
    state.is_touched_by_first = last.is_touched_by_first;
  }
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
    if (note_touch(frame, rows, any_front, state)) {
      const auto closed = closed_where_left(workpiece, standing, traced.traces);
      if (!state.cut_through)
        judge_bodies({workpiece, frame, rows, closed}, {pieces, *axes_, traced.traces},
                     any_front + face, state);
      state.cut_depth =
          std::max(state.cut_depth,
                   measure_cut_depth({workpiece, frame, rows, closed}, *axes_, state.bodies));
    }
    traced.fragments = std::move(pieces.fragments);
  } else if (workpiece.jet_count > 1 && !state.is_touched_by_first) {
    state.is_touched_by_first = touches_water(workpiece, part, {}, WaterOf::first_jet);
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
                                touches_water(*workpiece_, frame, rows, WaterOf::first_jet);
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
