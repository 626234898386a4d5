// SPDX-License-Identifier: Apache-2.0
// These functions lay out the particles of a body on a lattice.
//
// The nodes of a square (cubic) lattice are at (i + 1/2) d from the lowest corner of the shape's
// bounding box, so a box of 100 mm x 50 mm at 2 mm holds exactly 50 x 25 particles. Discs, rings,
// spheres, meshes and differences of them have their lattice centred in that box, as has every
// shape whose edge is an integer number of spacings: the coordinates of a shape that is symmetric
// about 0 are then symmetric to the last bit. A hexagonal lattice has its rows along x,
// d sqrt(3)/2 apart, every other row shifted by d/2; in 3D it is hexagonal close-packed with layers
// d sqrt(2/3) apart along z.
//
// All of this holds in the axes of the lattice, which are those of the case turned by
// `lattice_angle` about z: "x" and "box" above are along those axes.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "model/body.hpp"

namespace kerf {

// Returns the positions of the particles, m, in order of z, then y, then x of their nodes: those of
// visit_particles(), jittered (geometry/jitter.hpp).
std::vector<Point> fill(const Body& body, int dimension);

// Returns the volume of one particle, m^3 (2D: m^2): that of a cell of the lattice.
double particle_volume(const Body& body, int dimension);

// Returns the number of lattice nodes in the bounding box of the body, an upper bound of the number
// of its particles.
double lattice_nodes(const Body& body, int dimension);

// Returns the box that the cells of an unshifted square lattice fill, including the nodes outside
// the shape, in the axes of the lattice.
Box lattice_box(const Body& body, int dimension);

// Calls `visit` for the nodes of particles inside `window`, in order, every `stride`-th node along
// each axis, until it returns false.
struct LatticeVisit {
  Box window;
  long stride = 1;
  std::function<bool(const Point&)> visit;
};
void visit_particles(const Body& body, int dimension, const LatticeVisit& request);

// Does the same for at most `most` nodes of the window, which are spread evenly over it where it
// has more (`stride` is then not used). Returns how many nodes each of them stands for.
double visit_sample(const Body& body, int dimension, const LatticeVisit& request, double most);

// Returns one flag per particle: 1 for particles of a rigid body in its `repelling_layer`, which
// have no neighbour on that side.
std::vector<std::uint8_t> repelling_flags(const Body& body, const std::vector<Point>& particles,
                                          int dimension);

}  // namespace kerf
