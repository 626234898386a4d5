// SPDX-License-Identifier: Apache-2.0
// The number of particles of a body without laying them out, by a bounded number of looks at its
// lattice whatever the size of the body:
// - A lattice of few nodes is laid out, and the count is exact.
// - Of a larger lattice of one spacing, nodes that are spread evenly over it are tested. A box is
//   exact, because all its nodes are inside.
// - A larger graded body is searched as its quadtree (3D: octree) is built
// (geometry/graded_fill.hpp),
//   but of a cell that is split only as many parts are looked at as a budget allows. A part is
//   chosen with a probability p in proportion to the particles that it may have, and counts 1 / p
//   times, so that the expected count is the true one.
#pragma once

#include <optional>
#include <vector>

#include "geometry/graded_fill.hpp"
#include "model/body.hpp"

namespace kerf {

// The symmetry planes of the domain: particles beyond them are mirror images and do not count.
struct CountedSide {
  Faces planes;
  Box domain;
};

// Lattices of more nodes are not laid out.
inline constexpr double most_laid_nodes = 3e5;

struct ParticleEstimate {
  std::vector<double> levels;  // number of particles of each level, the finest first
  bool is_exact = true;
  double total() const;
  // Returns the number of particles that the body would have at its finest spacing.
  double uniform(int dimension) const;
};

// Looks at about `most` nodes.
ParticleEstimate estimate_particles(const Body& body, int dimension, const CountedSide& side = {},
                                    double most = most_laid_nodes);

// Returns the particle of the body whose cell holds the position. Cells that are split because
// their neighbours are fine count as whole.
std::optional<GradedParticle> particle_at(const Body& body, int dimension, const Point& position);

}  // namespace kerf
