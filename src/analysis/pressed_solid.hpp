// SPDX-License-Identifier: Apache-2.0
// Solid that is pressed into rigid bodies, where nothing can be: the contact of solids yields to
// pressures beyond the stiffness of the solid (docs/theory/solid_contact.md).
#pragma once

#include <cstdint>
#include <vector>

#include "model/shape.hpp"
#include "simulation/frame.hpp"

namespace kerf {

struct Case;
struct Workpiece;

// A rigid body that does not move.
struct RigidShape {
  Shape shape;
  double spacing = 0.0;  // m
};

std::vector<RigidShape> resting_rigid_shapes(const Case& description);

// Returns the share of the mass of the workpiece that is intact and lies inside one of these
// bodies, one spacing or more (the larger of the two) behind its surface.
double pressed_share(const Workpiece& workpiece, const Frame& frame,
                     const std::vector<std::uint32_t>& rows, const std::vector<RigidShape>& bodies);

}  // namespace kerf
