// SPDX-License-Identifier: Apache-2.0
#include "simulation/run_settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "geometry/fill.hpp"
#include "geometry/gauge_face.hpp"
#include "model/case.hpp"
#include "simulation/media.hpp"
#include "simulation/populate.hpp"
#include "simulation/symmetry.hpp"

namespace kerf {
namespace {

std::vector<Nozzle> make_nozzles(const Case& description) {
  std::vector<Nozzle> nozzles;
  for (const Jet& jet : description.jets) {
    const auto material = static_cast<std::size_t>(jet.material);
    nozzles.emplace_back(jet, description.materials.at(material).density, description.dimension);
    nozzles.back().cut_at(description.symmetry, description.domain);
  }
  return nozzles;
}

std::vector<std::string> source_names(const Case& description) {
  std::vector<std::string> names;
  for (const Body& body : description.bodies) names.push_back(fmt::format("body '{}'", body.name));
  for (const Jet& jet : description.jets) names.push_back(fmt::format("jet '{}'", jet.name));
  return names;
}

std::vector<Point> points_of(const Probe& probe, int dimension) {
  if (probe.is_plane()) return {};
  if (probe.kind == Probe::Kind::point) return {probe.position};
  return gauge_face(probe.position, probe.normal, probe.diameter, dimension);
}

std::vector<RunProbe> run_probes(const Case& description) {
  std::vector<RunProbe> probes;
  for (const Probe& probe : description.probes)
    probes.push_back(
        {probe.is_plane(), probe.position, probe.normal, points_of(probe, description.dimension)});
  return probes;
}

std::vector<AbsorbingSide> absorbing_sides(const Case& description) {
  std::vector<AbsorbingSide> sides;
  for (std::size_t b = 0; b < description.bodies.size(); ++b) {
    const Body& body = description.bodies[b];
    for (int a = 0; a < description.dimension; ++a) {
      const auto axis = static_cast<std::size_t>(a);
      const double layer = layer_distance(body, a, description.dimension);
      if (body.absorbing.minimum[axis]) sides.push_back({b, a, -1.0, layer});
      if (body.absorbing.maximum[axis]) sides.push_back({b, a, 1.0, layer});
    }
  }
  return sides;
}

// The workpiece continues behind every window but the first.
std::optional<MovingWindow> moving_window(const Case& description) {
  const auto frame = travelling_frame(description);
  if (!frame) return {};
  Case within = description;
  within.bodies.front().absorbing.minimum[frame->axis] = true;
  within.bodies.front().absorbing.maximum[frame->axis] = true;
  return MovingWindow{*frame, absorbing_sides(within), [description](std::uint64_t shifts) {
                        return window_particles(description, shifts);
                      }};
}

void set_numbers(RunSettings& settings, const Case& description) {
  settings.end_time = description.time.end;
  settings.courant = description.time.courant;
  settings.maximum_step = description.time.maximum_step;
  settings.relax_time = description.time.relax;
  settings.gravity = description.gravity;
  settings.domain_minimum = description.domain.minimum;
  settings.domain_maximum = description.domain.maximum;
  settings.mirror_minimum = description.symmetry.minimum;
  settings.mirror_maximum = description.symmetry.maximum;
  settings.removes_back_flow = description.back_flow_removal.has_value();
  settings.smoothing_ratio = description.smoothing_ratio;
  settings.artificial_stress = description.artificial_stress.epsilon;
  settings.artificial_stress_exponent = description.artificial_stress.exponent;
  settings.water_scheme = description.numerics.water;
  settings.shifting = description.numerics.shifting;
  settings.smooth_walls = description.numerics.smooth_walls;
  settings.subcycles = description.numerics.subcycles;
  settings.sleep = description.numerics.sleep;
}

// Returns the regions of the media; empty where no body has voids.
std::vector<BondRegion> bond_regions(const Case& description,
                                     const std::vector<MediumOrigin>& origins) {
  const std::vector<SolidRegion> of_body =
      regions_of(description.bodies, pieces_of(description.bodies), description.dimension);
  const auto has_voids = [](const SolidRegion& region) { return region != nullptr; };
  if (std::none_of(of_body.begin(), of_body.end(), has_voids)) return {};
  std::vector<BondRegion> regions;
  for (const MediumOrigin& origin : origins)
    regions.push_back(
        {origin.source, origin.source < of_body.size() ? of_body[origin.source] : SolidRegion()});
  return regions;
}

}  // namespace

RunSettings run_settings(const Case& description) {
  RunSettings settings;
  set_numbers(settings, description);
  settings.probes = run_probes(description);
  settings.source_names = source_names(description);
  settings.nozzles = make_nozzles(description);
  settings.motion = Motion(description);
  settings.origins = medium_origins(description);
  InitialParticles laid = initial_particles(description, settings.nozzles);
  settings.particles = std::move(laid.particles);
  settings.media = make_media(description, settings.nozzles, laid.of_body);
  settings.bond_regions = bond_regions(description, settings.origins);
  settings.absorbing = absorbing_sides(description);
  settings.window = moving_window(description);
  settings.loads = run_loads(description, settings.particles, settings.origins);
  if (description.dimension == 2)
    join_mirrors(mirror_planes<2>(settings), settings.particles, settings.media);
  else
    join_mirrors(mirror_planes<3>(settings), settings.particles, settings.media);
  return settings;
}

}  // namespace kerf
