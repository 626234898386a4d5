// SPDX-License-Identifier: Apache-2.0
// The monitor of a cut determines from each frame the depth of the water, the fractured solid and
// whether the workpiece is cut through. docs/metrics.md has the definitions.
#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "analysis/kerf_axes.hpp"
#include "analysis/metric.hpp"
#include "analysis/opening_width.hpp"
#include "analysis/pieces.hpp"
#include "analysis/pressed_solid.hpp"
#include "analysis/wake.hpp"
#include "simulation/frame.hpp"

namespace kerf {

struct Case;
struct KerfView;
struct Workpiece;

// Whether a body of the workpiece is cut through, at this instant or before.
struct BodyCut {
  bool through = false;
  bool severed = false;  // no piece of it joins the solid beside the jet; else it has a hole
  // Much of it beside the jet, or half of it, has left the domain unbroken: it is pushed out, not
  // cut. What happens to the rows there, which lose their neighbours, is not judged.
  bool left = false;
  bool punched = false;  // it is severed around a plug under the jet (analysis/plug.hpp)
  // kg, of it near the jets, torn so far (analysis/torn_mass.hpp); as at its cut from then on.
  double torn = 0.0;
};

// Returns the name of a kind of cut in results: `punched`, `severed` or `holed`.
std::string kind_of_cut(bool is_severed, bool is_punched);

// The state of a cut at one instant.
struct CutState {
  double time = 0.0;                // s
  double front_depth = 0.0;         // m, of the first jet, below the face; 0 before contact
  double cut_depth = 0.0;           // m, of the cut so far (analysis/cut_depth.hpp)
  int pieces = 0;                   // connected pieces of intact solid > 5% of the workpiece
  double fractured_fraction = 0.0;  // fractured mass over the workpiece's, as at the start
  double fractured_mass = 0.0;      // kg, of the workpiece, fractured or gone from the domain
  // At half the front depth, m: the breadths of the fractured region and of the opening, without
  // intact solid, and the part of this that the layout leaves empty.
  double fractured_width = 0.0, kerf_width = 0.0, void_width = 0.0;
  // Whether all bodies in the way of the jet are cut through, at this instant or before.
  bool cut_through = false;
  // Whether water of a jet touches or has entered the workpiece, at this instant or before.
  bool is_touched = false;
  bool is_touched_by_first = false;  // likewise, of the first jet, or of it and any solid
  std::vector<BodyCut> bodies;       // in the order of Workpiece::bodies
  // The jet whose way was cut, as an index into Case::jets, and the depth of the front of its
  // water then, m.
  int cut_jet = 0;
  double cut_front = 0.0;
  Wake wake;                   // of a nozzle with which a frame travels
  double water_impulse = 0.0;  // N s (2D: N s/m), of the water on the solids, along the jet
  double pressed_share = 0.0;  // of the mass, inside rigid bodies (analysis/pressed_solid.hpp)

  // Returns the part of the opening that is removed, of its width in solid; 1 without an opening,
  // and where a dent opens no path from the face.
  double removed_share() const {
    const double opened = kerf_width - void_width;
    const bool is_open = opened > 0.0 && (cut_through || cut_depth > 0.0);
    return is_open ? std::min(1.0, fractured_width / opened) : 1.0;
  }

  static const MetricList<CutState>& metrics();
};

// What a particle of the workpiece did: it stood in the last frame, or it has left the domain after
// a frame in which it stood; else 0.
namespace slot_trace {
inline constexpr std::uint8_t stood = 1, left_whole = 2;
}  // namespace slot_trace

// The verdict on a body of the workpiece.
struct BodyVerdict {
  int body = 0;  // index into Case::bodies
  bool is_in_way = false, can_break = false;
  BodyCut cut;
  double time = std::numeric_limits<double>::quiet_NaN();  // s, when it was cut through
};

// The numbers of a cut over the run so far.
struct CutSummary {
  // Of front_share_at_cut, where the cut is that of the water.
  static constexpr double least_share = 0.5;
  bool cut_through = false;
  double cut_through_time = std::numeric_limits<double>::quiet_NaN();  // s
  bool severed = false;  // every body in the way is parted; else some have a hole
  bool punched = false;  // of every body in the way a plug is punched out
  // The jet whose way was cut, as an index into Case::jets.
  int cut_jet = 0;
  // m, position of the front at that time, on the axis of that jet
  std::array<double, 3> cut_through_place{};
  // How deep that front was then, over the depth at which the axis leaves the workpiece as laid
  // out.
  double front_share_at_cut = 1.0;
  // The greatest such share at which the workpiece did not give way: the front of water that
  // removes what is in its way ends at the far face, and one beyond it has pressed that face ahead.
  // This may be by half the width of the jet, or by half the thickness where that is less.
  double greatest_share = 2.0;
  // The part of the opening at half the depth then that is removed, and not pushed aside: of its
  // width. Of an opening by water that removes solid it is more than half.
  double removed_share_at_cut = 1.0;
  static constexpr double least_removed = 0.5;
  // Both shares at the end of the run, which tell of a workpiece that is not cut through.
  double front_share_at_end = 0.0, removed_share_at_end = 1.0;
  // s, from then on the first time at which the front is within a spacing of that depth
  double water_through_time = std::numeric_limits<double>::quiet_NaN();
  double contact_time = std::numeric_limits<double>::quiet_NaN();  // s, first with a front
  // s, first at which water of the first jet touched the workpiece; nan = never
  double first_touch_time = std::numeric_limits<double>::quiet_NaN();
  // Of several jets: the way of another than the first was cut, or the water of the first had
  // touched nothing when the workpiece was cut through, or by the end of a run without a cut.
  bool is_of_other_jet = false;
  int initial_pieces = 0;  // pieces as laid out: bodies that nothing joins are pieces of their own
  double front_speed = 0.0;  // m/s, least-squares slope of front depth from contact to the exit
  std::vector<BodyVerdict> bodies;
  CutState last;
  double pressed_share = 0.0;        // the largest of all states
  double mass_left_whole = 0.0;      // kg, of the solid that stood until it left the domain
  std::vector<std::uint8_t> traces;  // slot_trace of each slot; empty where nothing has left whole
  double pieces_since = 0.0;         // s, the time from which on the number of pieces is the last
  std::vector<Fragment> fragments;   // of the last frame, the heaviest first

  // Returns the share of the workpiece that stood until it left the domain.
  double left_fraction() const {
    return mass_left_whole > 0.0 ? mass_left_whole / last.fractured_mass * last.fractured_fraction
                                 : 0.0;
  }
  // Returns the share of the workpiece that is fractured, or has left the domain after it had come
  // off: what stood until it left is none of it.
  double broken_fraction() const {
    constexpr double rounding = 1e-9;
    const double share = last.fractured_mass > 0.0 ? mass_left_whole / last.fractured_mass : 0.0;
    return share > 1.0 - rounding ? 0.0 : (1.0 - share) * last.fractured_fraction;
  }

  // Whether the front is known that was there when another jet than the first had cut.
  bool knows_front() const { return !is_of_other_jet || cut_jet != 0; }
  // Whether a crack parted or pierced more of the thickness than the water had passed by then.
  bool cracked_ahead() const {
    return cut_through && knows_front() && front_share_at_cut < least_share;
  }
  // Whether the jet had pressed the workpiece ahead by more than that by then, or had pushed aside
  // more than it had removed. A front below the far face of what is not cut has pressed that ahead.
  bool was_pressed_ahead() const {
    return cut_through ? front_share_at_cut > greatest_share : front_share_at_end >= 1.0;
  }
  bool was_pushed_aside() const {
    if (!cut_through) return removed_share_at_end < least_removed;
    return !cracked_ahead() && removed_share_at_cut < least_removed;
  }
  // It does not give way to a first jet that met nothing.
  bool gave_way() const { return !is_of_other_jet && (was_pressed_ahead() || was_pushed_aside()); }
  // Whether a nozzle that moves may fail where this one, which stands, cuts through: it strikes but
  // once, and edges that give way evade it (docs/theory/exposure.md).
  bool holds_at_rest_only() const { return cracked_ahead() || gave_way(); }

  // Those of the summary alone; `last` has its own.
  static const MetricList<CutSummary>& metrics();
};

class CutMonitor {
 public:
  // `initial` is the frame before the first step, also where a run is resumed. Frames are those of
  // the run, also with symmetry planes.
  CutMonitor(const Case& description, const Frame& initial);
  // Frames in order of time; `water_impulse`: of the water on the solids so far, N s (2D: N s/m).
  CutState observe(const Frame& frame, const std::array<double, 3>& water_impulse = {});
  // Returns the state of a frame after the last one observed, without a trace in the history.
  CutState state_at(const Frame& frame, const std::array<double, 3>& water_impulse = {}) const;
  // Takes the workpiece in the window of a travelling frame, as laid out. The case is that after
  // its shifts (machine/travelling_frame.hpp).
  void follow(const Case& shifted, const Frame& layout);
  CutSummary summary() const;
  // The history, from which a resumed run continues its measurements.
  const std::vector<CutState>& history() const { return history_; }
  const Workpiece& workpiece() const { return *workpiece_; }
  // The workpiece as that jet of the case meets it.
  const Workpiece& workpiece_along(int jet) const {
    return *ways_.at(static_cast<std::size_t>(jet)).workpiece;
  }
  // The slot_trace of each slot, with which a resumed run continues too.
  const std::vector<std::uint8_t>& traces() const { return traced_.traces; }
  void restore(std::vector<CutState> history, const std::vector<std::uint8_t>& traces,
               const Frame& last);

 private:
  // What an observation leaves behind besides the state.
  struct Traced {
    std::vector<std::uint8_t> traces;
    std::vector<Fragment> fragments;
  };

  // Returns the state of a frame; `traced` has the traces before it, and then those with it.
  CutState measure(const Frame& frame, const std::array<double, 3>& water_impulse,
                   Traced& traced) const;
  // The way of a jet of the case.
  struct Way {
    std::shared_ptr<const Workpiece> workpiece;
    KerfAxes axes;
  };
  // The depths of the fronts along a way, m: of the water of its jet below the face as that lies,
  // and of all water below the face as laid out.
  struct WayFront {
    double of_own = 0.0, of_all = 0.0;
  };

  void judge_bodies(const KerfView& view, const Pieces& pieces,
                    const std::vector<std::uint8_t>& traces, CutState& state) const;
  void add_verdicts(CutSummary& summary) const;
  void take(const Case& description, const Frame& layout);
  // Notes what water of the jets touches in a frame, and returns whether water of any does.
  bool note_touch(const Frame& frame, const std::vector<std::uint32_t>& rows, double front,
                  CutState& state) const;
  // Returns the time of the first front so far, s, before a row at `now`.
  double contact_time(double now) const;

  std::shared_ptr<const Workpiece> workpiece_;  // as laid out
  std::optional<KerfAxes> axes_;                // of the first jet
  std::vector<Way> ways_;                       // of all jets, the first at the beginning
  std::vector<std::uint8_t> near_jets_;         // mark_near_jets(), by slot
  std::vector<OpeningLine> opening_lines_;
  double contact_depth_ = 0.0;  // m, one spacing of the first jet
  bool has_wake_ = false;       // whether a frame travels
  std::vector<RigidShape> rigid_;
  std::vector<CutState> history_;
  Traced traced_;  // of the last frame observed
};

}  // namespace kerf
