// SPDX-License-Identifier: Apache-2.0
#include "simulation/run_loads.hpp"

#include <algorithm>

#include "geometry/shapes.hpp"
#include "geometry/surface_elements.hpp"
#include "model/case.hpp"
#include "particles/new_particle.hpp"

namespace kerf {
namespace {

std::size_t body_number(const Case& description, const Load& load) {
  const auto found = std::find_if(description.bodies.begin(), description.bodies.end(),
                                  [&](const Body& body) { return body.name == load.body; });
  return static_cast<std::size_t>(found - description.bodies.begin());
}

Point force_on(const Load& load, const SurfaceElement& element) {
  Point force{};
  for (std::size_t a = 0; a < 3; ++a)
    force[a] = element.area * (load.kind == LoadKind::pressure ? -load.pressure * element.normal[a]
                                                               : load.traction[a]);
  return force;
}

// Sets the part of the surface of a body that a load acts on. What lies in a symmetry plane is no
// part of the surface.
void set_face(const Case& description, const Load& load, RunLoad& result) {
  // Elements per spacing: the edge of a load that ends within a face is that accurate.
  const double fineness = description.dimension == 2 ? 32.0 : 4.0;
  const std::size_t number = body_number(description, load);
  if (load.kind == LoadKind::body_force || number == description.bodies.size()) return;
  const Body& body = description.bodies[number];
  const double size = body.spacing / fineness;
  const SymmetryPlanes planes{description.symmetry, description.domain};
  result.is_all_around = result.follows;
  for (const SurfaceElement& element :
       surface_elements(body.shape, description.dimension, size, planes))
    if (!load.region || contains(*load.region, element.position, description.dimension))
      result.faces.push_back({element.position, force_on(load, element)});
    else
      result.is_all_around = false;
}

// Returns the ids of the particles that a body force acts on.
std::vector<std::uint32_t> loaded_particles(const Case& description, const Load& load,
                                            const std::vector<NewParticle>& particles,
                                            const std::vector<MediumOrigin>& origins) {
  const std::size_t body = body_number(description, load);
  std::vector<std::uint32_t> chosen;
  for (std::uint32_t id = 0; id < particles.size(); ++id) {
    if (origins[particles[id].source].source != body) continue;
    if (load.region && !contains(*load.region, particles[id].position, description.dimension))
      continue;
    chosen.push_back(id);
  }
  return chosen;
}

}  // namespace

std::vector<RunLoad> run_loads(const Case& description, const std::vector<NewParticle>& particles,
                               const std::vector<MediumOrigin>& origins) {
  std::vector<RunLoad> loads;
  for (const Load& load : description.loads) {
    RunLoad result;
    result.source = body_number(description, load);
    result.follows = load.kind == LoadKind::pressure;
    result.pressure = load.pressure;
    set_face(description, load, result);
    result.history = Expression(load.history, {"t"});
    if (load.kind == LoadKind::body_force) {
      result.acceleration = load.acceleration;
      result.particles = loaded_particles(description, load, particles, origins);
    }
    loads.push_back(std::move(result));
  }
  return loads;
}

}  // namespace kerf
