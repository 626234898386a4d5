// SPDX-License-Identifier: Apache-2.0
// The kerf at one instant: its shape, what was removed, damage, splash, leaked water, fragments,
// layers. docs/metrics.md defines the numbers. The depth of the kerf is measured in
// analysis/kerf_shape.hpp, its widths in analysis/kerf_width.hpp, the current width of the opening
// in analysis/opening_width.hpp.
#pragma once

#include <tuple>
#include <vector>

#include "analysis/cut_margin.hpp"
#include "analysis/damaged_zone.hpp"
#include "analysis/dent.hpp"
#include "analysis/fragment_sizes.hpp"
#include "analysis/leak.hpp"
#include "analysis/removal.hpp"
#include "analysis/splash.hpp"

namespace kerf {

// Every measurement of a kerf besides its shape, in the order of result.json. A measurement is a
// struct of the measured values with `static T measure(const KerfScene&)` and `static const
// MetricList<T>& metrics()`.
using KerfMeasurements =
    std::tuple<DamagedZone, Removal, CutMargin, Dent, Splash, Leak, FragmentSizes>;

// A body of a workpiece that is made of several bodies.
struct KerfLayer {
  int body = 0;      // index into Case::bodies
  double top = 0.0;  // m, depth of its face at the axis
  // m, of its edges as laid out, across the jet from its axis
  double left = 0.0, right = 0.0;
  KerfShape shape;              // as if it were alone
  double volume = 0.0;          // m^3 (2D: m^2), as laid out
  double removed_volume = 0.0;  // m^3 (2D: m^2)
  double fractured_mass = 0.0;  // kg (2D: kg/m), fractured or gone from the domain
  BodyVerdict verdict;
  double margin = 0.0;    // 1, as CutMargin, of this body; 0 where it is not in the way of the jet
  double unbroken = 0.0;  // m, least thickness in the way of the jet
  // A body above it in the way of the jet is not cut through: the water has not come to it.
  bool is_covered = false;

  // Whether it stands in the way of the jet above a depth, m, of a kerf or a cut beside it.
  bool stands_above(double depth) const {
    return verdict.is_in_way && !verdict.cut.through && !verdict.cut.left && unbroken > 0.0 &&
           top + shape.depth < depth;
  }
};

struct Kerf {
  KerfShape shape;    // of the removed material, in the initial layout
  KerfShape opening;  // of the current opening, which includes material displaced without fracture
  KerfMeasurements measurements;  // zero or nan without a workpiece or a jet
  std::vector<KerfLayer> layers;  // the upper first; empty where the workpiece is one body

  template <class Measurement>
  const Measurement& of() const {
    return std::get<Measurement>(measurements);
  }
  template <class Measurement>
  Measurement& of() {
    return std::get<Measurement>(measurements);
  }
};

// Measures the kerf of a frame of a run. All numbers are zero, nan or empty without a workpiece or
// a jet. With verdicts in `conditions` a kerf, an opening or a layer that is not cut through is not
// `through`, whatever its depth: a last layer of solid may still stand, or have been pushed ahead.
Kerf measure_kerf(const Workpiece& workpiece, const Frame& frame, const KerfConditions& conditions);

}  // namespace kerf
