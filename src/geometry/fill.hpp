// SPDX-License-Identifier: Apache-2.0
// Lays out the particles of a body on a lattice.
//
// The nodes of a square (cubic) lattice stand at (i + 1/2) d from the lowest corner of the shape's
// bounding box, so a box of 100 mm x 50 mm at 2 mm holds exactly 50 x 25 particles. Discs, rings,
// spheres, meshes and what is cut from them have their lattice centred on the middle of that box,
// as has every shape whose edge is a whole number of spacings: the coordinates of a shape that is
// symmetric about 0 are then symmetric to the last bit. A hexagonal lattice has its rows along x,
// d sqrt(3)/2 apart, every other row shifted by d/2; in 3D it is hexagonal close-packed with layers
// d sqrt(2/3) apart along z.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "model/case.hpp"

namespace kerf {

// The particles, in order of z, then y, then x of their nodes: those of visit_particles(), jittered
// (geometry/jitter.hpp).
std::vector<Point> fill(const Body& body, int dimension);

// Volume of one particle, m^3 (m^2 in 2D): the cell of the lattice.
double particle_volume(const Body& body, int dimension);

// Distance of neighbouring layers of the body's lattice along an axis, m.
double layer_distance(const Body& body, int axis, int dimension);

// Nodes of the lattice in the bounding box of the body: an upper bound of its particles.
double lattice_nodes(const Body& body, int dimension);

// What the cells of an unshifted square lattice fill, nodes outside the shape included.
Box lattice_box(const Body& body, int dimension);

// Calls `visit` for the nodes of particles inside `window`, in order, every `stride`-th node along
// each axis, until it returns false.
struct LatticeVisit {
  Box window;
  long stride = 1;
  std::function<bool(const Point&)> visit;
};
void visit_particles(const Body& body, int dimension, const LatticeVisit& request);

// One per particle: 1 where a rigid body's particle is of the outermost layer towards its
// `repelling_layer`, that is, has no neighbour on that side.
std::vector<std::uint8_t> repelling_flags(const Body& body, const std::vector<Point>& particles,
                                          int dimension);

}  // namespace kerf
