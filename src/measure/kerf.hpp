// SPDX-License-Identifier: Apache-2.0
// The kerf at one instant, in numbers: shape, damage, removal, splash, fragments, layers.
// Definitions: docs/metrics.md.
#pragma once

#include <limits>
#include <vector>

#include "measure/cut.hpp"
#include "measure/damaged_zone.hpp"
#include "measure/fragment_sizes.hpp"
#include "measure/kerf_shape.hpp"
#include "measure/leak.hpp"
#include "measure/removal.hpp"
#include "measure/splash.hpp"

namespace kerf {

// What a frame does not say.
struct KerfConditions {
  std::array<double, 3> traverse{};  // m/s, velocity of the nozzle
  double moves_from = 0.0;           // s, when the traverse began
  double jet_speed = 0.0;            // m/s
  double on_time_factor = 1.0;       // 1, part of the time since contact in which water flowed
  double contact_time = std::numeric_limits<double>::quiet_NaN();      // s, nan before contact
  double cut_through_time = std::numeric_limits<double>::quiet_NaN();  // s, nan = not cut through
  double front_depth = 0.0;                                            // m, of the water
};

// Those of the first jet of the case, after a run that went as `summary` says.
KerfConditions kerf_conditions(const Case& description, const CutSummary& summary);

// A body of a workpiece that is made of several.
struct KerfLayer {
  int body = 0;                 // index into Case::bodies
  double top = 0.0;             // m, depth of its face at the axis
  KerfShape shape;              // as if it were alone; `through` = it is cut through at the axis
  double volume = 0.0;          // m^3 (2D: m^2), as laid out
  double removed_volume = 0.0;  // m^3 (2D: m^2)
};

struct Kerf {
  KerfShape shape;            // of what was taken away, on the workpiece as laid out
  KerfShape opening;          // of what is open now: what flowed aside without breaking too
  double damaged_zone = 0.0;  // m
  Removal removal;
  Splash splash;
  Leak leak;
  FragmentSizes fragments;
  std::vector<KerfLayer> layers;  // the upper first; empty where the workpiece is one body
  // 1; cut through: the part of the run that was left; not so: minus the part of the thickness that
  // the water had still to go.
  double margin = 0.0;
};

// All 0 or empty without a workpiece or a jet, but for the fragments, which need no jet.
Kerf measure_kerf(const Workpiece& workpiece, const Frame& frame, const KerfConditions& conditions);

}  // namespace kerf
