// SPDX-License-Identifier: Apache-2.0
#include "app/jet_way.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "analysis/jet_axis.hpp"
#include "geometry/shapes.hpp"
#include "model/case.hpp"

namespace kerf {

Depths::Depths(const Body& body, const JetAxis& axis, int dimension) {
  const Box box = bounding_box(body.shape, dimension);
  for (std::size_t corner = 0; corner < 8; ++corner) {
    Point x = box.minimum;
    for (std::size_t a = 0; a < 3; ++a)
      if (corner >> a & 1) x[a] = box.maximum[a];
    least = std::min(least, axis.depth(x));
    greatest = std::max(greatest, axis.depth(x));
  }
}

bool is_in_way(const Jet& jet, const Body& body, int dimension) {
  constexpr int most_steps = 300, around = 8;
  const JetAxis axis(jet, dimension);
  const double deepest = std::max(Depths(body, axis, dimension).greatest, 0.0);
  const double reach = std::max(jet.width / 2.0, body.spacing);
  const double way = deepest + jet.standoff, step = std::max(body.spacing / 2.0, way / most_steps);
  for (double depth = -jet.standoff; depth <= deepest; depth += step)
    for (int n = 0; n < 2 * around + 1; ++n) {
      const double aside = n == 0 ? 0.0 : n <= around ? reach / 2.0 : reach;
      const double turn = 2.0 * std::numbers::pi * n / around;
      Point x = axis.aim;
      for (std::size_t a = 0; a < 3; ++a)
        x[a] += depth * axis.along[a] +
                aside * (std::cos(turn) * axis.across[a] + std::sin(turn) * axis.sideways[a]);
      if (contains(body.shape, x, dimension)) return true;
    }
  return false;
}

}  // namespace kerf
