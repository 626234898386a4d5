// SPDX-License-Identifier: Apache-2.0
// This header declares the interval of a metric that several runs of a case give.
#pragma once

#include <limits>
#include <string>

#include "analysis/metric.hpp"

namespace kerf {

// Amounts are in the SI unit of the metric.
struct MetricInterval {
  std::string metric;            // its key in result.json
  std::string unit = "1";        // SI
  double value = 0.0;            // of the run itself
  double low = 0.0, high = 0.0;  // NaN = no coarser run has the metric
  double spacing = 0.0;          // the part of the spacing, the larger of its two sides
  double layout = 0.0;           // the part of the layout, likewise; NaN = one layout
  double order = std::numeric_limits<double>::quiet_NaN();  // observed, in the spacing; NaN = none
  std::string rule;  // by which the part of the spacing was found: a word of spacing_rules
  int runs = 0;      // that have the metric

  static const MetricList<MetricInterval>& metrics();
};

}  // namespace kerf
