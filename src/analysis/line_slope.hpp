// SPDX-License-Identifier: Apache-2.0
// The straight line through points.
#pragma once

namespace kerf {

// Returns the slope of the least-squares line through the points (x(p), y(p)) of a list; 0 where
// all have one x.
template <class Points, class X, class Y>
double line_slope(const Points& points, const X& x, const Y& y) {
  const double count = static_cast<double>(points.size());
  double mean_x = 0.0, mean_y = 0.0;
  for (const auto& point : points) {
    mean_x += x(point) / count;
    mean_y += y(point) / count;
  }
  double product = 0.0, square = 0.0;
  for (const auto& point : points) {
    product += (x(point) - mean_x) * (y(point) - mean_y);
    square += (x(point) - mean_x) * (x(point) - mean_x);
  }
  return square > 0.0 ? product / square : 0.0;
}

}  // namespace kerf
