// SPDX-License-Identifier: Apache-2.0
#include "simulation/populate.hpp"

#include <algorithm>
#include <limits>

#include "geometry/fill.hpp"
#include "geometry/graded_fill.hpp"
#include "geometry/shapes.hpp"
#include "geometry/surface_layers.hpp"
#include "kernels/wendland_c2.hpp"
#include "machine/travelling_frame.hpp"
#include "model/case.hpp"
#include "model/expression.hpp"
#include "simulation/inflow.hpp"
#include "simulation/media.hpp"
#include "simulation/media_order.hpp"

namespace kerf {
namespace {

// Returns a thin region beyond a symmetry plane, which covers the face of a body that ends in the
// plane: its image goes on there.
Shape region_beyond(const Box& domain, std::size_t axis, bool at_minimum, double reach) {
  constexpr double far = 1e6;             // m
  const double thickness = 0.01 * reach;  // beyond the step of nearest_face()
  Shape region;
  region.box = {{-far, -far, -far}, {far, far, far}};
  const double plane = at_minimum ? domain.minimum[axis] : domain.maximum[axis];
  region.box.minimum[axis] = at_minimum ? plane - thickness : plane;
  region.box.maximum[axis] = at_minimum ? plane : plane + thickness;
  return region;
}

// Returns the surface of a body down to the reach of water. Covered are the parts in symmetry
// planes, where a solid is joined to another, and where a rigid body touches another.
SurfaceLayers surface_of(const Case& description, std::size_t number) {
  const Body& body = description.bodies[number];
  double coarsest = 0.0;
  for (const Body& one : description.bodies) coarsest = std::max(coarsest, one.spacing);
  for (const Jet& jet : description.jets) coarsest = std::max(coarsest, jet.spacing);
  SurfaceLayers layers{body, {}, 0.0};
  layers.depth = WendlandC2<2>::support * description.smoothing_ratio * coarsest;
  const auto pieces = pieces_of(description.bodies);
  for (std::size_t b = 0; b < description.bodies.size(); ++b) {
    const Body& other = description.bodies[b];
    const bool covers =
        body.role == Role::rigid ? other.role == Role::rigid : pieces[b] == pieces[number];
    if (b != number && covers) layers.others.push_back(other.shape);
  }
  for (std::size_t a = 0; a < 3; ++a) {
    if (description.symmetry.minimum[a])
      layers.others.push_back(region_beyond(description.domain, a, true, layers.depth));
    if (description.symmetry.maximum[a])
      layers.others.push_back(region_beyond(description.domain, a, false, layers.depth));
  }
  return layers;
}

// The particles of a body as laid out.
struct Layout {
  std::vector<Point> points;                      // m
  std::vector<int> levels;                        // of resolution
  std::vector<std::uint8_t> repelling;            // flags of rigid bodies
  std::vector<std::optional<NearestFace>> faces;  // of bodies that are smooth walls
};

// Returns the particles of a window of the path of a travelling frame.
std::vector<GradedParticle> fill_window(const Body& body, int dimension,
                                        const TravellingFrame& frame, std::uint64_t shifts) {
  Body block = body;
  block.shape.box = frame.path;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Box window{{-infinity, -infinity, -infinity}, {infinity, infinity, infinity}};
  window.minimum[frame.axis] = frame.window(shifts).minimum[frame.axis];
  window.maximum[frame.axis] = frame.window(shifts).maximum[frame.axis];
  return fill_levels(block, dimension, window);
}

// Whether there is water, which alone acts on the faces of solids.
bool has_water(const Case& description) {
  const auto is_water = [](const Body& body) { return body.role == Role::water; };
  return !description.jets.empty() ||
         std::any_of(description.bodies.begin(), description.bodies.end(), is_water);
}

// Returns the faces nearest to the particles of a body. Those of a rigid one are laid along its
// surface.
std::vector<std::optional<NearestFace>> faces_of(const Case& description, std::size_t number,
                                                 const std::optional<TravellingFrame>& frame,
                                                 std::vector<Point>& points) {
  const Body& body = description.bodies[number];
  SurfaceLayers layers = surface_of(description, number);
  if (body.role == Role::rigid) return lay_along_surface(layers, description.dimension, points);
  if (body.role != Role::elastic || !has_water(description)) return {};
  if (!frame) return nearest_faces(layers, description.dimension, points);
  Body block = body;  // the window is a part of the path
  block.shape.box = frame->path;
  return nearest_faces({block, layers.others, layers.depth}, description.dimension, points);
}

Layout lay_out(const Case& description, std::size_t number, std::uint64_t shifts) {
  const Body& body = description.bodies[number];
  Layout layout;
  const auto frame = travelling_frame(description);
  for (const GradedParticle& particle :
       frame ? fill_window(body, description.dimension, *frame, shifts)
             : fill_levels(body, description.dimension)) {
    layout.points.push_back(particle.position);
    layout.levels.push_back(particle.level);
  }
  const bool is_rigid = body.role == Role::rigid;
  const bool is_standard = description.formulation == Formulation::standard;
  if (is_standard && description.numerics.smooth_walls)
    layout.faces = faces_of(description, number, frame, layout.points);
  layout.levels.resize(layout.points.size());
  layout.faces.resize(layout.points.size());
  layout.repelling.resize(layout.points.size());
  if (is_rigid) layout.repelling = repelling_flags(body, layout.points, description.dimension);
  return layout;
}

// Returns how many particles the body has, with those beyond symmetry planes and the domain.
// `levels`: the media of its levels; `shifts`: of a travelling frame.
std::size_t add_body(const Case& description, std::size_t number,
                     const std::vector<std::uint16_t>& levels, std::vector<NewParticle>& particles,
                     std::uint64_t shifts = 0) {
  const Body& body = description.bodies[number];
  const int dimension = description.dimension;
  const Layout layout = lay_out(description, number, shifts);
  std::vector<Expression> velocity;
  for (const std::string& component : body.velocity)
    velocity.emplace_back(component, std::vector<std::string>{"x", "y", "z"});
  for (std::size_t k = 0; k < layout.points.size(); ++k) {
    if (is_beyond(description.symmetry, description.domain, layout.points[k])) continue;
    NewParticle particle;
    particle.position = layout.points[k];
    particle.source = levels[static_cast<std::size_t>(layout.levels[k])];
    particle.flags = layout.repelling[k] ? flag::repelling : std::uint8_t{0};
    if (const auto& face = layout.faces[k]) {
      particle.face_normal = face->normal;
      particle.face_depth = face->depth;
      particle.face_corner = face->corner;
    }
    if (!body.fixed && body.displacement[0].empty() && body.role != Role::rigid)
      for (int a = 0; a < dimension; ++a)
        particle.velocity[static_cast<std::size_t>(a)] =
            velocity[static_cast<std::size_t>(a)](particle.position);
    particles.push_back(particle);
  }
  return layout.points.size();
}

}  // namespace

InitialParticles initial_particles(const Case& description, const std::vector<Nozzle>& nozzles) {
  InitialParticles result;
  const auto levels = media_of_levels(description);
  for (std::size_t b = 0; b < description.bodies.size(); ++b)
    result.of_body.push_back(add_body(description, b, levels[b], result.particles));
  for (std::size_t j = 0; j < nozzles.size(); ++j) {
    for (const NewParticle& particle : inlet_particles(nozzles[j].standing_water(), nozzles[j],
                                                       description.bodies.size() + j, 0.0))
      result.particles.push_back(particle);
  }
  return result;
}

std::vector<NewParticle> window_particles(const Case& description, std::uint64_t shifts) {
  std::vector<NewParticle> particles;
  add_body(description, 0, media_of_levels(description).front(), particles, shifts);
  return particles;
}

}  // namespace kerf
