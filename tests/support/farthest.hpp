// SPDX-License-Identifier: Apache-2.0
// The largest difference between two runs.
#pragma once

#include <algorithm>
#include <cmath>

#include "support/runs.hpp"

namespace kerf::test {

// Returns the largest difference of a vector field over the particles of a, matched with those of b
// by id.
template <class Column>
double farthest(const Frame& a, const Frame& b, const Column& column) {
  const auto place = by_id(b);
  double most = 0.0;
  for (std::size_t k = 0; k < a.id.size(); ++k) {
    const auto& x = column(a)[k];
    const auto& y = column(b)[place.at(a.id[k])];
    for (std::size_t axis = 0; axis < 3; ++axis)
      most = std::max(most, std::abs(double(x[axis]) - double(y[axis])));
  }
  return most;
}

}  // namespace kerf::test
