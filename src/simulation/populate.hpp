// SPDX-License-Identifier: Apache-2.0
// This header declares the layout of the particles that a run starts with, on the host.
#pragma once

#include <vector>

#include "geometry/nozzle.hpp"
#include "particles/new_particle.hpp"

namespace kerf {

struct Case;

struct InitialParticles {
  std::vector<NewParticle> particles;
  std::vector<std::size_t> of_body;  // how many each body has, with those beyond symmetry planes
};

InitialParticles initial_particles(const Case& description, const std::vector<Nozzle>& nozzles);

// Returns the particles of the workpiece in its window after some shifts of a travelling frame.
std::vector<NewParticle> window_particles(const Case& description, std::uint64_t shifts);

}  // namespace kerf
