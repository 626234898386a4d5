// SPDX-License-Identifier: Apache-2.0
// This measurement finds how high the centre of mass of the solid is.
#pragma once

#include "analysis/kerf_scene.hpp"
#include "analysis/metric.hpp"

namespace kerf {

struct SolidHeight {
  double height = 0.0;  // m, of the centre of mass of all solid that is not rigid

  static SolidHeight measure(const KerfScene& scene) {
    const Frame& frame = scene.view.frame;
    double mass = 0.0, moment = 0.0;
    for (std::size_t i = 0; i < frame.mass.size(); ++i) {
      if (frame.category[i] != Category::solid && frame.category[i] != Category::fractured)
        continue;
      mass += static_cast<double>(frame.mass[i]);
      moment += static_cast<double>(frame.mass[i]) * frame.position[i][1];
    }
    return {mass > 0.0 ? moment / mass : 0.0};
  }
  static const MetricList<SolidHeight>& metrics() {
    static const MetricList<SolidHeight> list{{"solid_height", "m", "height of the solid",
                                               "Height of the centre of mass of the solid.",
                                               &SolidHeight::height}};
    return list;
  }
};

}  // namespace kerf
