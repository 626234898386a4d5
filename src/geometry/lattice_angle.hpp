// SPDX-License-Identifier: Apache-2.0
// The angle of the lattice of a body. A lattice along the faces of a body makes them smooth: a face
// at an angle to its lattice is a staircase, on which water, contact and bending differ from those
// of a plane face.
#pragma once

#include <vector>

#include "geometry/symmetry_planes.hpp"
#include "model/body.hpp"

namespace kerf {

// Returns the angle of most of the faces of a shape to the axes, rad, in (-pi/4, pi/4]: the
// direction, up to quarter turns, with the greatest length of edges in the plane of x and y. It is
// 0 for shapes without plane faces, for shapes with meshes, and where no direction has more than
// each of the others, so that a symmetric shape has a symmetric layout. Of a difference the first
// part counts.
double angle_of_faces(const Shape& shape);

// Sets `lattice_angle` of the bodies whose lattice follows their faces. A body that is joined to
// another one has the angle of that one. Lattices of bodies that
// reach one of the `planes` of symmetry of the domain are along the axes, in line with their mirror
// image.
void orient_lattices(const std::vector<Body*>& bodies, const SymmetryPlanes& symmetry,
                     int dimension);

// Returns the body in the axes of its lattice: what lies at a point x of it lies at turn(x) of the
// body, with turn = PlaneTurn(body.lattice_angle). The region of a grading is left out.
Body along_lattice(const Body& body);

}  // namespace kerf
