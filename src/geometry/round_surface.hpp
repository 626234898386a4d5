// SPDX-License-Identifier: Apache-2.0
// The surfaces of round shapes in patches that keep ratios of areas: arcs, and in 3D cylinders,
// flat rings and bands of latitude.
#pragma once

#include "geometry/surface_patch.hpp"

namespace kerf {

// Adds the surface of a disc or ring; in 3D that of a cylinder or tube, with its flat ends.
void add_round(const Shape& shape, int dimension, PatchedSurface& surface);

// Adds the surface of a sphere.
void add_sphere(const Shape& shape, PatchedSurface& surface);

}  // namespace kerf
