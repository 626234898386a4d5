// SPDX-License-Identifier: Apache-2.0
// The verdict on the bodies of the workpiece in a frame: each is judged in the way of every jet, so
// that the order of the jets in a case does not decide it.
#include <algorithm>

#include "analysis/crack_path.hpp"
#include "analysis/cut.hpp"
#include "analysis/front.hpp"
#include "analysis/kerf_map.hpp"
#include "analysis/left_whole.hpp"
#include "analysis/plug.hpp"
#include "analysis/unbroken.hpp"
#include "analysis/workpiece.hpp"

namespace kerf {
namespace {

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
  const KerfAxes& axes;                     // of the jet in whose way they are judged
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

// Returns the least share of the thickness of a body that is unbroken in the way of a jet.
double unbroken_share(const KerfView& view, const KerfAxes& axes) {
  const UnbrokenThickness thickness = measure_unbroken(view, axes, {{}, axes.way(view.frame.time)});
  return thickness.laid_out > 0.0 ? thickness.unbroken / thickness.laid_out : 1.0;
}

}  // namespace

// Adds the verdict of a frame to that of the frames before it. Where a body is cut through in the
// ways of several jets at once, it is the work of the one that has broken most in its own.
void CutMonitor::judge_bodies(const KerfView& seen, const Pieces& pieces,
                              const std::vector<std::uint8_t>& traces, CutState& state) const {
  std::vector<WayFront> fronts;
  for (const Way& way : ways_) {
    const double face = face_depth(*way.workpiece, seen.frame, seen.rows);
    fronts.push_back({front_depth(*way.workpiece, seen.frame, face),
                      front_depth(*way.workpiece, seen.frame, face, WaterOf::all_jets) + face});
  }
  bool all = true;
  for (std::size_t n = 0; n < workpiece_->bodies.size(); ++n) {
    const bool is_in_way = workpiece_->bodies[n].is_in_way;
    BodyCut& cut = state.bodies[n];
    double least = 2.0;
    for (std::size_t j = 0; j < ways_.size() && is_in_way && !cut.left; ++j) {
      const Way& way = ways_[j];
      if (cut.through && least > 1.0) break;  // before this frame
      const WorkpieceBody& body = way.workpiece->bodies[n];
      const KerfView view{*way.workpiece, seen.frame,     seen.rows,
                          seen.standing,  seen.positions, body.body};
      const BodyCut here = judge(body, view, {pieces, way.axes, traces}, fronts[j].of_all);
      if (j == 0 && here.left) cut.left = true;
      if (!here.through) continue;
      const double share = ways_.size() == 1 ? 0.0 : unbroken_share(view, way.axes);
      if (share >= least) continue;
      least = share;
      const double torn = cut.torn;
      cut = here;
      cut.torn = torn;
      state.cut_jet = static_cast<int>(j);
      state.cut_front = fronts[j].of_own;
    }
    all = all && (cut.through || !is_in_way);
  }
  state.cut_through = all;
}

}  // namespace kerf
