// SPDX-License-Identifier: Apache-2.0
#include "simulation/run_settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/gauge_face.hpp"
#include "geometry/surface_elements.hpp"
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

// Returns the box whose sides absorb; of a difference it is the first part.
const Box& box_of(const Shape& shape) {
  return shape.kind == Shape::Kind::difference ? shape.parts.front().box : shape.box;
}

// Returns what symmetry planes leave of a box.
Box cut_at(const SymmetryPlanes& symmetry, Box box) {
  for (std::size_t a = 0; a < 3; ++a) {
    if (symmetry.planes.minimum[a])
      box.minimum[a] = std::max(box.minimum[a], symmetry.domain.minimum[a]);
    if (symmetry.planes.maximum[a])
      box.maximum[a] = std::min(box.maximum[a], symmetry.domain.maximum[a]);
  }
  return box;
}

// Returns the elements in the side of a box at `face`, m.
std::vector<AbsorbingElement> elements_at(double face, std::size_t axis, double tolerance,
                                          const std::vector<SurfaceElement>& surface) {
  std::vector<AbsorbingElement> elements;
  for (const SurfaceElement& element : surface)
    if (std::abs(element.normal[axis]) > 0.5 && std::abs(element.position[axis] - face) < tolerance)
      elements.push_back({element.position, element.area});
  return elements;
}

// What lies in a symmetry plane or beyond one is no part of a face.
void add_absorbing_sides(const Case& description, std::size_t number,
                         std::vector<AbsorbingSide>& sides) {
  const Body& body = description.bodies[number];
  if (!body.absorbing.any()) return;
  const double fineness = description.dimension == 2 ? 8.0 : 4.0;  // elements per spacing
  const SymmetryPlanes symmetry{description.symmetry, description.domain};
  const auto surface =
      surface_elements(body.shape, description.dimension, body.spacing / fineness, symmetry);
  const Box& box = box_of(body.shape);
  for (int a = 0; a < description.dimension; ++a) {
    const auto axis = static_cast<std::size_t>(a);
    const auto add = [&](double face) {
      sides.push_back({number, a, cut_at(symmetry, box),
                       elements_at(face, axis, 1e-6 * body.spacing, surface)});
    };
    if (body.absorbing.minimum[axis]) add(box.minimum[axis]);
    if (body.absorbing.maximum[axis]) add(box.maximum[axis]);
  }
}

std::vector<AbsorbingSide> absorbing_sides(const Case& description) {
  std::vector<AbsorbingSide> sides;
  for (std::size_t b = 0; b < description.bodies.size(); ++b)
    add_absorbing_sides(description, b, sides);
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

std::vector<AbsorbingSide> MovingWindow::absorbing_after(std::uint64_t shifts) const {
  std::vector<AbsorbingSide> moved = absorbing;
  const double offset = frame.offset(shifts);
  for (AbsorbingSide& side : moved) {
    side.edges.minimum[frame.axis] += offset;
    side.edges.maximum[frame.axis] += offset;
    for (AbsorbingElement& element : side.elements) element.position[frame.axis] += offset;
  }
  return moved;
}

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
