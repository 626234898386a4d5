// SPDX-License-Identifier: Apache-2.0
// This measurement computes the margin of a cut and the thickness that is still unbroken.
#pragma once

#include "analysis/kerf_scene.hpp"
#include "analysis/metric.hpp"

namespace kerf {

struct CutMargin {
  // 1; the share of the stated time after the cut-through, else minus the share of the thickness
  // that is unbroken in the way of the jet.
  double value = -1.0;
  double unbroken =
      0.0;  // m, that thickness, of all bodies that are not cut through; 0 after a cut
  // Nothing in the way of the jet is removed or torn, also after a cut; false where that is not
  // known.
  bool is_whole = false;

  static CutMargin measure(const KerfScene& scene);
  static const MetricList<CutMargin>& metrics();
};

}  // namespace kerf
