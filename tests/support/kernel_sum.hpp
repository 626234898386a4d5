// SPDX-License-Identifier: Apache-2.0
// How much of its kernel a layout fills, for tests of geometry.
#pragma once

#include <cmath>
#include <vector>

#include "geometry/fill.hpp"
#include "kernels/wendland_c2.hpp"

namespace kerf::test {

// Returns sum V W over the particles of a body at a place, which may be one of them; h = 1.3 d.
inline double kernel_sum(const Body& body, const std::vector<Point>& points, const Point& x,
                         int dimension) {
  const double h = 1.3 * body.spacing, volume = particle_volume(body, dimension);
  double sum = 0.0;
  for (const Point& y : points) {
    const double r = std::hypot(x[0] - y[0], x[1] - y[1], x[2] - y[2]);
    sum += volume * (dimension == 2 ? WendlandC2<2>::value(r, h) : WendlandC2<3>::value(r, h));
  }
  return sum;
}

}  // namespace kerf::test
