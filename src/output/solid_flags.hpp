// SPDX-License-Identifier: Apache-2.0
// Flags of solids that the discretisation does not hold, particles that are loose from the start
// and solid that is pressed into rigid bodies, and of solid that fails by pressure alone.
#pragma once

#include <string>
#include <vector>

#include "analysis/loose_particles.hpp"
#include "output/validity.hpp"

namespace kerf {

struct Case;
struct RunOutcome;

// Says how many particles of a body are loose from the start, and the remedy.
std::string loose_sentence(const Case& description, const LooseParticles& body);

// Throws a UserError if a body has no other particles.
void refuse_loose_bodies(const Case& description, const std::vector<LooseParticles>& bodies);

void add_solid_flags(const RunOutcome& outcome, std::vector<ValidityFlag>& flags);

}  // namespace kerf
