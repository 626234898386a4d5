// SPDX-License-Identifier: Apache-2.0
#include "simulation/inflow.hpp"

namespace kerf {

std::vector<NewParticle> inlet_particles(const std::vector<InletParticle>& water,
                                         const Nozzle& nozzle, std::size_t source, double time) {
  std::vector<NewParticle> particles;
  const bool open = nozzle.is_open(time);
  const Point carried = nozzle.velocity(time);
  for (const InletParticle& drop : water) {
    NewParticle particle;
    particle.position = drop.position;
    particle.inlet_speed = drop.speed;
    particle.source = static_cast<std::uint16_t>(source);
    particle.flags = flag::upstream;
    for (std::size_t a = 0; a < 3; ++a)
      particle.velocity[a] = carried[a] + (open ? drop.speed * nozzle.direction()[a] : 0.0);
    particles.push_back(particle);
  }
  return particles;
}

}  // namespace kerf
