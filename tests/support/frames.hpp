// SPDX-License-Identifier: Apache-2.0
// Frames with known values.
#pragma once

#include <cmath>

#include "simulation/frame.hpp"

namespace kerf::test {

// Adds one particle. Its other values follow from its number and are all different.
inline void add_particle(Frame& frame, const std::array<double, 3>& place, Category category,
                         double spacing) {
  const auto i = static_cast<double>(frame.position.size());
  frame.position.push_back(place);
  frame.velocity.push_back({0.1 + i, -0.2 * i, 0.3});
  frame.category.push_back(category);
  frame.id.push_back(static_cast<std::uint32_t>(4000000000.0 - i));
  frame.source.push_back(static_cast<std::uint16_t>(60000.0 + i));
  frame.spacing.push_back(static_cast<float>(spacing));
  frame.mass.push_back(static_cast<float>(1e-3 * (1.0 + i)));
  frame.density.push_back(static_cast<float>(1000.0 + i / 3.0));
  frame.pressure.push_back(static_cast<float>(-1e5 / 7.0 * i));
  frame.upstream.push_back(0);
}

}  // namespace kerf::test
