// SPDX-License-Identifier: Apache-2.0
// This header declares the drawing of a case to scale: bodies, jets, probes, domain and symmetry
// planes, from the numbers of the case, without a layout of particles.
#pragma once

#include <string>
#include <vector>

namespace kerf {

struct Case;

struct CaseDrawing {
  std::string title;  // what is seen
  std::string svg;
};

// Returns the plane of a 2D case; of a 3D case the sections along x and along z through the point
// that the first jet aims at, or else through the middle of the domain.
std::vector<CaseDrawing> draw_case(const Case& description);

}  // namespace kerf
