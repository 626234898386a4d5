// SPDX-License-Identifier: Apache-2.0
// The space that a piece of solid fills, by the shapes of its bodies.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "model/shape.hpp"

namespace kerf {

struct Body;

// The shapes of all bodies of a piece; none where it is one body of a convex shape, which has no
// voids.
using SolidRegion = std::shared_ptr<const std::vector<Shape>>;

// The body of a medium, and the space that its piece fills; none where its shape has no voids.
struct BondRegion {
  std::uint16_t body = 0;
  SolidRegion region;
};

// Returns whether a straight line between two points of the shape never leaves it.
bool is_convex(const Shape& shape, int dimension);

// Returns the region of each body. `pieces`: the number of the piece of each, which joined bodies
// share.
std::vector<SolidRegion> regions_of(const std::vector<Body>& bodies,
                                    const std::vector<std::uint16_t>& pieces, int dimension);

// Returns whether the point is within one of the shapes.
bool is_within(const std::vector<Shape>& shapes, const Point& point, int dimension);

}  // namespace kerf
