// SPDX-License-Identifier: Apache-2.0
// Shapes of a few members, for tests of geometry.
#pragma once

#include <utility>
#include <vector>

#include "model/shape.hpp"

namespace kerf::test {

inline Shape box(const Point& minimum, const Point& maximum) {
  Shape shape;
  shape.box = {minimum, maximum};
  return shape;
}

inline Shape of_parts(Shape::Kind kind, std::vector<Shape> parts) {
  Shape shape;
  shape.kind = kind;
  shape.parts = std::move(parts);
  return shape;
}

}  // namespace kerf::test
