// SPDX-License-Identifier: Apache-2.0
// fit_to_surface() lays the outermost particles of a body along faces that are not in line with
// its lattice (docs/theory/layout.md). Near such faces the layout is relaxed,
//   x_i -= 0.2 h^2 (sum_j V S_ij (x_j - x_i) + sum_e A_e W(x_i - x_e) n_e),
// where the first sum is over particles and the second, over elements of the surface, is the same
// sum over a uniform filling of the space outside: particles fill the shape evenly, up to half a
// spacing from the surface.
#pragma once

#include <vector>

#include "model/point.hpp"

namespace kerf {

struct Body;
struct Shape;

// Returns whether a face of the shape is round or slanted to the axes.
bool has_slanted_face(const Shape& shape, int dimension);

// Returns whether particles of the body are moved to such faces.
bool is_fitted(const Body& body, int dimension);

// Returns whether the particles of the body have equal shares of its fitted_volume(). Those of
// rigid bodies fill cells of their lattice, since they act by sums over the water that they
// displace.
bool shares_volume(const Body& body, int dimension);

// Returns the volume of a fitted body, m^3 (2D: m^2), from the elements of its surface by the
// divergence theorem. Its particles have equal shares of it, which differ from a cell of the
// lattice because a round shape holds some more or fewer nodes than cells.
double fitted_volume(const Body& body, int dimension);

// `nodes`: positions of the nodes of the lattice inside the shape, in the axes of the lattice, in
// order, m. Those less than five spacings from a round or slanted face are moved; the outermost
// come to lie half a spacing below it.
void fit_to_surface(const Body& body, int dimension, std::vector<Point>& nodes);

}  // namespace kerf
