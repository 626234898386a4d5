// SPDX-License-Identifier: Apache-2.0
// The way of the water of a jet as laid out.
#pragma once

namespace kerf {

struct Body;
struct Jet;

// Returns whether a body is in the way of a jet: whether points of the water are within it, as far
// aside as the analysis counts a body as in its way (analysis/workpiece.hpp).
bool is_in_way(const Jet& jet, const Body& body, int dimension);

}  // namespace kerf
