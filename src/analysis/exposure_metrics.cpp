// SPDX-License-Identifier: Apache-2.0
// The metrics of the exposure.
#include <cmath>

#include "analysis/exposure.hpp"

namespace kerf {

double Exposure::decades() const {
  return simulated > 0.0 && !std::isnan(exponent) ? std::max(0.0, std::log10(longest / simulated))
                                                  : 0.0;
}

const MetricList<Exposure>& Exposure::metrics() {
  using E = Exposure;
  static const MetricList<E> list{
      {"shortest", "s", "shortest exposure, w / u",
       "Time for which the jet covers a point of its path: its extent over the traverse speed.",
       &E::shortest},
      {"longest", "s", "longest exposure, W / u",
       "Time for which the jet stays within the hole that it has made by then: the width of the "
       "opening over the traverse speed.",
       &E::longest},
      {"simulated", "s", "simulated exposure",
       "Time of the run since the jet met the workpiece, until the water is through the cut or the "
       "run ends, less the time that water takes from the surface to the front.",
       &E::simulated},
      {"decades", "1", "decades of time carried",
       "Decimal logarithm of the longest exposure over the simulated time; 0 where the run covers "
       "the exposure, and once the water is through.",
       &E::decades},
      {"cuts", "1", "certainly cut through at the traverse speed",
       "Whether the shortest exposure cuts the workpiece through. Of a jet in drops it is at least "
       "three of their periods.",
       &E::cuts},
      {"may_cut", "1", "possibly cut through at the traverse speed",
       "Whether the longest exposure cuts the workpiece through, or the run tells no depth after "
       "it.",
       &E::may_cut},
      {"depth", "m", "depth at the traverse speed",
       "Geometric mean of the two following depths; none where the cut holds of a nozzle at rest "
       "only.",
       &E::depth},
      {"depth_low", "m", "least depth at the traverse speed",
       "Depth after the shortest exposure, at most the thickness; that before the cut where this "
       "holds of a nozzle at rest only.",
       &E::depth_low},
      {"depth_high", "m", "greatest depth at the traverse speed",
       "Depth after the longest exposure, at most the thickness; none where the front rests at the "
       "end of a shorter run, or has passed the far face of a workpiece that is not cut.",
       &E::depth_high},
      {"exponent", "1", "exponent of time, n",
       "Exponent n of the depth over time, which carries the depth beyond the run.", &E::exponent},
      {"greatest_feed", "m/s", "greatest traverse speed that cuts",
       "Traverse speed at which the shortest exposure just cuts through, at most the speed of the "
       "jet, and of a jet in drops that at which a point is exposed for three of their periods; 0 "
       "where no speed is certain to.",
       &E::greatest_feed},
      {"possible_feed", "m/s", "greatest traverse speed that may cut",
       "Traverse speed at which the longest exposure just cuts through, at most the speed of the "
       "jet.",
       &E::possible_feed}};
  return list;
}

}  // namespace kerf
