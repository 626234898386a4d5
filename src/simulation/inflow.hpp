// SPDX-License-Identifier: Apache-2.0
// The inflow of water: a nozzle emits layers of water as the jet advances (Nozzle::emit of
// geometry/nozzle.hpp), emit_inflow() makes particles of them, and ParticleRun::inject_inflow
// (simulation/particle_run_step.hpp) adds them to the run before each list of neighbours.
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/nozzle.hpp"
#include "particles/new_particle.hpp"

namespace kerf {

// Returns the particles of water that a nozzle emits at a time (s); they move with the nozzle, and
// at the speed of their column, as far as the pump reaches it, while it is open. `medium` is the
// index of the water in the list of media.
inline std::vector<NewParticle> inlet_particles(const std::vector<InletParticle>& water,
                                                const Nozzle& nozzle, std::size_t medium,
                                                double time) {
  std::vector<NewParticle> particles;
  const Point carried = nozzle.velocity(time);
  for (const InletParticle& drop : water) {
    NewParticle particle;
    particle.position = drop.position;
    particle.inlet_column = drop.column;
    particle.source = static_cast<std::uint16_t>(medium);
    particle.flags = flag::upstream;
    const double speed =
        nozzle.is_open(time) ? nozzle.pump(drop.column).speed_share() * drop.speed : 0.0;
    for (std::size_t a = 0; a < 3; ++a)
      particle.velocity[a] = carried[a] + speed * nozzle.direction()[a];
    particles.push_back(particle);
  }
  return particles;
}

// Emits the water that has entered since the last call until `time` (s) from each nozzle, and calls
// accept(medium, particles) for each nozzle that emitted some. The water of nozzle j is the medium
// `first_medium` + j.
template <class Accept>
void emit_inflow(std::vector<Nozzle>& nozzles, std::size_t first_medium, double time,
                 const Accept& accept) {
  for (std::size_t j = 0; j < nozzles.size(); ++j) {
    const std::vector<InletParticle> water = nozzles[j].emit(time);
    if (water.empty()) continue;
    accept(first_medium + j, inlet_particles(water, nozzles[j], first_medium + j, time));
  }
}

}  // namespace kerf
