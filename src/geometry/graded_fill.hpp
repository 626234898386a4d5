// SPDX-License-Identifier: Apache-2.0
// These functions lay out a body whose resolution decreases with the distance from a region of
// interest (docs/theory/graded_resolution.md): a quadtree (3D: octree) over the lattice of its
// finest spacing d. A cell of level L, 2^L d wide, is one particle if it is L widths or more from
// that region and if each of the 2^(L D) particles that the uniform body has in it is inside the
// shape; else it is split. A cell that touches cells two levels finer is split too. So a graded
// body fills exactly the region of the uniform one and has the same surface.
#pragma once

#include <vector>

#include "model/body.hpp"

namespace kerf {

struct GradedParticle {
  Point position{};
  int level = 0;
};

// Returns the particles of any body, cell by cell. A body of one spacing has level 0 only, in the
// order of fill().
std::vector<GradedParticle> fill_levels(const Body& body, int dimension);

// Returns those in a window whose faces are faces of coarsest cells, in the same order.
std::vector<GradedParticle> fill_levels(const Body& body, int dimension, const Box& window);

// Returns the number of particles of each level, the finest first.
std::vector<std::size_t> count_levels(const Body& body, int dimension);

// Returns the distance of a position from the region of finest resolution, m; 0 inside it.
double distance_from_finest(const Grading& grading, const Point& position, int dimension);

// Returns the spacing of a level, m.
double level_spacing(const Body& body, int level);
// Returns the body with that spacing everywhere.
Body at_level(const Body& body, int level);

}  // namespace kerf
