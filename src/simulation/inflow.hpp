// SPDX-License-Identifier: Apache-2.0
// The inflow of water: a nozzle emits layers of water as the jet advances (Nozzle::emit of
// geometry/nozzle.hpp), the function below makes particles of them, and before each list of
// neighbours ParticleRun::inject_inflow (simulation/particle_run_step.hpp) adds them to the run.
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/nozzle.hpp"
#include "particles/new_particle.hpp"

namespace kerf {

// Returns the particles of water that a nozzle emits at a time (s); they move with the nozzle, and
// at the speed of the jet while it is open. `source` is the medium.
std::vector<NewParticle> inlet_particles(const std::vector<InletParticle>& water,
                                         const Nozzle& nozzle, std::size_t source, double time);

}  // namespace kerf
