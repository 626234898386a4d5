// SPDX-License-Identifier: Apache-2.0
// This measurement computes the margin of a cut.
#pragma once

#include <algorithm>
#include <cmath>

#include "analysis/kerf_scene.hpp"
#include "analysis/metric.hpp"

namespace kerf {

struct CutMargin {
  // 1; the share of the run after the cut-through, else minus the share of the thickness below the
  // water front.
  double value = 0.0;

  static CutMargin measure(const KerfScene& scene) {
    const KerfConditions& conditions = scene.conditions;
    const double time = scene.view.frame.time, bottom = scene.view.workpiece.bottom;
    if (!std::isnan(conditions.cut_through_time))
      return {time > 0.0 ? (time - conditions.cut_through_time) / time : 0.0};
    if (bottom <= 0.0) return {};
    return {std::min(0.0, conditions.front_depth / bottom - 1.0)};
  }
  static const MetricList<CutMargin>& metrics() {
    static const MetricList<CutMargin> list{{"margin", share(), "margin of the cut",
                                             "Share of the run that was left after the cut; below "
                                             "0, minus the share of the thickness that "
                                             "the water has not yet reached.",
                                             &CutMargin::value}};
    return list;
  }
};

}  // namespace kerf
