// SPDX-License-Identifier: Apache-2.0
#include "simulation/populate.hpp"

#include <algorithm>

#include "geometry/fill.hpp"
#include "geometry/graded_fill.hpp"
#include "geometry/nearest_face.hpp"
#include "geometry/shapes.hpp"
#include "kernels/wendland_c2.hpp"
#include "model/case.hpp"
#include "model/expression.hpp"
#include "simulation/inflow.hpp"
#include "simulation/media_order.hpp"

namespace kerf {
namespace {

// Sets the faces of the rigid body `number` that are nearest to its particles.
class FaceFinder {
 public:
  FaceFinder(const Case& description, std::size_t number)
      : body_(description.bodies[number]),
        dimension_(description.dimension),
        is_wanted_(description.numerics.smooth_walls && body_.role == Role::rigid) {
    double coarsest = 0.0;
    for (const Body& body : description.bodies) coarsest = std::max(coarsest, body.spacing);
    for (const Jet& jet : description.jets) coarsest = std::max(coarsest, jet.spacing);
    reach_ = WendlandC2<2>::support * description.smoothing_ratio * coarsest;
    for (std::size_t b = 0; b < description.bodies.size(); ++b)
      if (b != number && description.bodies[b].role == Role::rigid)
        others_.push_back(description.bodies[b].shape);
  }
  void find(NewParticle& particle) const {
    if (!is_wanted_) return;
    const auto face = nearest_face(body_.shape, others_, particle.position, reach_, dimension_);
    if (!face) return;
    particle.face_normal = face->normal;
    particle.face_depth = face->depth;
  }

 private:
  const Body& body_;
  int dimension_;
  bool is_wanted_;
  double reach_ = 0.0;  // m
  std::vector<Shape> others_;
};

// `levels`: the media of its levels.
void add_body(const Case& description, std::size_t number, const std::vector<std::uint16_t>& levels,
              std::vector<NewParticle>& particles) {
  const Body& body = description.bodies[number];
  const int dimension = description.dimension;
  const std::vector<GradedParticle> laid = fill_levels(body, dimension);
  std::vector<Point> points;
  for (const GradedParticle& particle : laid) points.push_back(particle.position);
  std::vector<std::uint8_t> repelling(points.size(), 0);
  if (body.role == Role::rigid) repelling = repelling_flags(body, points, dimension);
  std::vector<Expression> velocity;
  for (const std::string& component : body.velocity)
    velocity.emplace_back(component, std::vector<std::string>{"x", "y", "z"});
  const FaceFinder faces(description, number);
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (is_beyond(description.symmetry, description.domain, points[k])) continue;
    NewParticle particle;
    particle.position = points[k];
    particle.source = levels[static_cast<std::size_t>(laid[k].level)];
    particle.flags = repelling[k] ? flag::repelling : std::uint8_t{0};
    faces.find(particle);
    if (!body.fixed && body.displacement[0].empty() && body.role != Role::rigid)
      for (int a = 0; a < dimension; ++a)
        particle.velocity[static_cast<std::size_t>(a)] =
            velocity[static_cast<std::size_t>(a)](points[k]);
    particles.push_back(particle);
  }
}

}  // namespace

std::vector<NewParticle> initial_particles(const Case& description,
                                           const std::vector<Nozzle>& nozzles) {
  std::vector<NewParticle> particles;
  const auto levels = media_of_levels(description);
  for (std::size_t b = 0; b < description.bodies.size(); ++b)
    add_body(description, b, levels[b], particles);
  for (std::size_t j = 0; j < nozzles.size(); ++j) {
    for (const NewParticle& particle : inlet_particles(nozzles[j].standing_water(), nozzles[j],
                                                       description.bodies.size() + j, 0.0))
      particles.push_back(particle);
  }
  return particles;
}

}  // namespace kerf
