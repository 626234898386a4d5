// SPDX-License-Identifier: Apache-2.0
#include "output/metric_interval.hpp"

namespace kerf {

const MetricList<MetricInterval>& MetricInterval::metrics() {
  using M = MetricInterval;
  static const MetricList<M> list{
      {"metric", "1", "metric", "Key of the metric in this file.", &M::metric},
      {"unit", "1", "unit", "SI unit of the numbers of this record.", &M::unit},
      {"value", "1", "value", "The metric of this run.", &M::value},
      {"low", "1", "lower end",
       "Lower end of the interval; null where no coarser run has the metric.", &M::low},
      {"high", "1", "upper end", "Upper end of the interval, likewise.", &M::high},
      {"spacing", "1", "part of the spacing",
       "Distance from the value to an end of the interval that the spacing causes.", &M::spacing},
      {"layout", "1", "part of the layout",
       "Distance from the value to an end of the interval that the layout of the particles causes; "
       "null where it was not varied.",
       &M::layout},
      {"order", "1", "observed order",
       "Observed order of convergence in the spacing, where the runs show one.", &M::order},
      {"rule", "1", "rule",
       "How the part of the spacing was found: `grid convergence`, `limited order`, `two "
       "spacings`, `range`, `constant` or `unknown` (docs/limits.md).",
       &M::rule},
      {"runs", "1", "runs", "Number of runs that have the metric.", &M::runs}};
  return list;
}

}  // namespace kerf
