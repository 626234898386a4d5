// SPDX-License-Identifier: Apache-2.0
#include "analysis/observation_times.hpp"

#include <algorithm>
#include <cmath>

#include "model/case.hpp"

namespace kerf {

ObservationTimes::ObservationTimes(const Case& description) {
  for (const Jet& jet : description.jets) {
    const double interval = spacings * jet.spacing / jet.speed;
    shortest_ = shortest_ > 0.0 ? std::min(shortest_, interval) : interval;
  }
}

bool ObservationTimes::is_due(double now, double last) const {
  return has_own() && now >= last + std::max(shortest_, relative * last);
}

double ObservationTimes::count(double end) const {
  if (!has_own() || end <= 0.0) return 0.0;
  const double even = shortest_ / relative;  // s, until then the interval is the shortest
  if (end <= even) return end / shortest_;
  return (1.0 + std::log(end / even)) / relative;
}

}  // namespace kerf
