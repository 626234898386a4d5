// SPDX-License-Identifier: Apache-2.0
// Flags of solids that the discretisation does not hold, particles that are loose from the start
// and solid that is pressed into rigid bodies, and of solid that fails by pressure alone.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/loose_particles.hpp"
#include "output/validity.hpp"

namespace kerf {

struct Case;
struct RunOutcome;

// Says how many particles of a body are loose from the start, and the remedy.
std::string loose_sentence(const Case& description, const LooseParticles& body);

// A body without other particles: the key to correct, and a sentence with its value, the range and
// the remedy.
struct LooseBody {
  std::string key, sentence;
};
std::optional<LooseBody> loose_body(const Case& description,
                                    const std::vector<LooseParticles>& bodies);
// Throws a UserError if there is one.
void refuse_loose_bodies(const Case& description, const std::vector<LooseParticles>& bodies);

void add_solid_flags(const RunOutcome& outcome, std::vector<ValidityFlag>& flags);

}  // namespace kerf
