// SPDX-License-Identifier: Apache-2.0
// Lays out a body that is coarser further away from where it matters (docs/theory/
// graded_resolution.md): a quadtree (3D: octree) over the lattice of its finest spacing d. A cell
// of level L, 2^L d wide, is one particle where it is L widths or more from what the body is graded
// around, and where every one of the 2^(L D) particles that the uniform body has in it is inside
// the shape; else it is split, and so is one that touches cells two levels finer. So a graded body
// fills exactly what the uniform one fills, and its surface is where it was.
#pragma once

#include <vector>

#include "model/case.hpp"

namespace kerf {

struct GradedParticle {
  Point position{};
  int level = 0;
};

// The particles of any body, cell by cell; those of one spacing are of level 0, in their order.
std::vector<GradedParticle> fill_levels(const Body& body, int dimension);

// How many there are of each level, from the finest on.
std::vector<std::size_t> count_levels(const Body& body, int dimension);

// m, from the region in which the body is finest to the place; 0 inside it.
double distance_from_finest(const Grading& grading, const Point& place, int dimension);

// The spacing of a level, m.
double level_spacing(const Body& body, int level);
// The body with that spacing throughout.
Body at_level(const Body& body, int level);

}  // namespace kerf
