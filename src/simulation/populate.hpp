// SPDX-License-Identifier: Apache-2.0
// The particles a run starts with, on the host.
#pragma once

#include <cstdint>
#include <vector>

#include "case/case.hpp"
#include "particles/nozzle.hpp"

namespace kerf {

struct NewParticle {
  Point position{};          // m
  Point velocity{};          // m/s
  double inlet_speed = 0.0;  // m/s
  std::uint16_t source = 0;  // its medium (simulation/levels.hpp)
  std::uint8_t flags = 0;
};

std::vector<NewParticle> initial_particles(const Case& description,
                                           const std::vector<Nozzle>& nozzles);
// Water entering through a nozzle; it stands still while the nozzle is shut.
std::vector<NewParticle> inlet_particles(const std::vector<InletParticle>& water,
                                         const Nozzle& nozzle, std::size_t source, double time);

}  // namespace kerf
