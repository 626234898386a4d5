// SPDX-License-Identifier: Apache-2.0
// The vector product of two points.
#pragma once

#include "model/point.hpp"

namespace kerf {

inline Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace kerf
