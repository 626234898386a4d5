// SPDX-License-Identifier: Apache-2.0
// The points of the face of a gauge against the moments of a strip and of a disc.
#include "geometry/gauge_face.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace kerf {
namespace {

// The mean of (x - centre) . e squared over a disc of radius R is R^2 / 4 for every e in its plane,
// over a strip of the width 2 R it is R^2 / 3. Equal parts with a point in the middle of each miss
// less than 2% of it: 1 / n^2 for n parts of a strip, 1 / (2 n^2) and less for n rings.
TEST(GaugeFace, HasTheMomentsOfItsShape) {
  const Point centre{0.3, -0.2, 0.7};
  for (const int dimension : {2, 3})
    for (const double turn : {0.0, 0.4, 1.1, 2.9}) {
      Point normal{std::cos(turn), std::sin(turn), 0.0};
      if (dimension == 3) normal = {0.6 * std::cos(turn), 0.6 * std::sin(turn), 0.8};
      const auto points = gauge_face(centre, normal, 0.02, dimension);
      Point mean{};
      double square = 0.0;
      for (const Point& p : points) {
        const Point r{p[0] - centre[0], p[1] - centre[1], p[2] - centre[2]};
        const double share = 1.0 / static_cast<double>(points.size());
        const double off = r[0] * normal[0] + r[1] * normal[1] + r[2] * normal[2];
        square += share * (r[0] * r[0] + r[1] * r[1] + r[2] * r[2]);
        mean = {mean[0] + share * p[0], mean[1] + share * p[1], mean[2] + share * p[2]};
        EXPECT_NEAR(off, 0.0, 1e-15);
        EXPECT_TRUE(dimension == 3 || std::abs(p[2] - centre[2]) < 1e-15);
      }
      for (std::size_t a = 0; a < 3; ++a) EXPECT_NEAR(mean[a], centre[a], 1e-15);
      const double expected = dimension == 2 ? 1e-4 / 3.0 : 1e-4 / 2.0;
      EXPECT_NEAR(square, expected, 0.04 * expected);
    }
}

// A gauge that looks along z has a face too.
TEST(GaugeFace, LooksAnywhere) {
  for (const Point& normal : {Point{0.0, 0.0, 1.0}, Point{0.0, 0.0, -1.0}, Point{0.0, 1.0, 0.0}})
    for (const Point& p : gauge_face({}, normal, 2.0, 3)) {
      const double distance = std::hypot(p[0], p[1], p[2]);
      EXPECT_LT(distance, 1.0);
      EXPECT_NEAR(p[0] * normal[0] + p[1] * normal[1] + p[2] * normal[2], 0.0, 1e-15);
    }
}

}  // namespace
}  // namespace kerf
