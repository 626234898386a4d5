// SPDX-License-Identifier: Apache-2.0
// Particles of solids that are loose from the start: their layout gives them too few neighbours for
// a deformation gradient, so that they are detached before anything has happened
// (solid/gradient_correction.hpp). Foils one particle thick and sharp tips have such particles.
#pragma once

#include <cstddef>
#include <vector>

namespace kerf {

struct Case;
struct Frame;

struct LooseParticles {
  int body = 0;                    // index into Case::bodies
  std::size_t loose = 0, all = 0;  // particles of the body
};

// Returns the elastic bodies that are not fixed and have such particles, by the layout of the case;
// none in a formulation without bonds. Factors of bonds at jumps of the spacing are left out.
// Throws UserError where the case cannot be built.
std::vector<LooseParticles> loose_particles(const Case& description);

// The same by the frame before the first step.
std::vector<LooseParticles> loose_particles(const Case& description, const Frame& initial);

}  // namespace kerf
