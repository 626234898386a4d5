// SPDX-License-Identifier: Apache-2.0
// The particles that a run starts with and those that enter through its nozzles, on the host.
#pragma once

#include <vector>

#include "geometry/nozzle.hpp"
#include "particles/new_particle.hpp"

namespace kerf {

struct Case;

std::vector<NewParticle> initial_particles(const Case& description,
                                           const std::vector<Nozzle>& nozzles);
// The water of a nozzle; it is at rest while the nozzle is closed.
std::vector<NewParticle> inlet_particles(const std::vector<InletParticle>& water,
                                         const Nozzle& nozzle, std::size_t source, double time);

}  // namespace kerf
