// SPDX-License-Identifier: Apache-2.0
#include "machine/jet_water.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/nozzle.hpp"
#include "geometry/shapes.hpp"
#include "machine/simulated_piece.hpp"
#include "machine/travelling_frame.hpp"
#include "model/case.hpp"

namespace kerf {

namespace {

constexpr double slowed = 10.0;  // the speed of a jet over that of its water that is on its way out
constexpr double crowding = 1.1;  // of water that is compressed, or out of order

// Returns the share of a jet that is not beyond symmetry planes. The axis is in the planes that cut
// the jet.
double simulated_share(const Case& description, const Jet& jet) {
  const double near = 1e-6 * jet.spacing;
  double share = 1.0;
  for (std::size_t a = 0; a < 3; ++a) {
    const double below = jet.position[a] - description.domain.minimum[a];
    const double above = description.domain.maximum[a] - jet.position[a];
    if (description.symmetry.minimum[a]) share *= below > near ? 1.0 : below < -near ? 0.0 : 0.5;
    if (description.symmetry.maximum[a]) share *= above > near ? 1.0 : above < -near ? 0.0 : 0.5;
  }
  return share;
}

// Returns the part of the domain in which the run is at one time, m.
Box domain_at_once(const Case& description) {
  const auto frame = travelling_frame(description);
  return frame ? at_shift(description, 0).domain : description.domain;
}

double edge(const Box& box, std::size_t axis) {
  return std::max(0.0, box.maximum[axis] - box.minimum[axis]);
}

// Returns the number of particles of a jet that fill a box.
double filling(const Box& box, const Jet& jet, int dimension) {
  double particles = crowding;
  for (std::size_t a = 0; a < static_cast<std::size_t>(dimension); ++a)
    particles *= edge(box, a) / jet.spacing;
  return particles;
}

// Returns the part of the domain between the outermost faces of all bodies.
Box box_of_bodies(const Case& description, const Box& domain) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Box around{{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
  for (const Body& body : description.bodies) {
    const Box box = bounding_box(body.shape, description.dimension);
    for (std::size_t a = 0; a < 3; ++a) {
      around.minimum[a] = std::min(around.minimum[a], box.minimum[a]);
      around.maximum[a] = std::max(around.maximum[a], box.maximum[a]);
    }
  }
  for (std::size_t a = 0; a < 3; ++a) {
    around.minimum[a] = std::max(around.minimum[a], domain.minimum[a]);
    around.maximum[a] = std::min(around.maximum[a], domain.maximum[a]);
  }
  return around;
}

// Returns whether water that no body holds leaves the domain at about the speed of its jet.
bool is_free_to_leave(const Case& description) {
  for (std::size_t a = 0; a < 3; ++a)
    if (description.gravity[a] != 0.0 ||
        (description.symmetry.minimum[a] && description.symmetry.maximum[a]))
      return false;
  return std::all_of(description.bodies.begin(), description.bodies.end(), [](const Body& body) {
    return body.velocity == Body{}.velocity && body.displacement == Body{}.displacement;
  });
}

}  // namespace

double emitted_water(const Case& description, const Jet& jet, double end) {
  return simulated_share(description, jet) * entering_particles(jet, description.dimension, end);
}

double most_jet_water(const Case& description, const Jet& jet, double end) {
  const int dimension = description.dimension;
  const Box domain = domain_at_once(description);
  const double emitted = emitted_water(description, jet, std::min(end, longest_stay(description)));
  const double most = std::min(emitted, filling(domain, jet, dimension));
  double square = 0.0;
  for (std::size_t a = 0; a < static_cast<std::size_t>(dimension); ++a)
    square += edge(domain, a) * edge(domain, a);
  const double pulse = jet.pulse_frequency > 0.0 ? slugs_of(jet).period : 0.0;
  const double way_out = slowed * std::sqrt(square) / jet.speed + pulse;  // s
  if (way_out >= end || !is_free_to_leave(description)) return most;
  const double passing = emitted_water(description, jet, jet.start + way_out);
  return std::min(most, passing + filling(box_of_bodies(description, domain), jet, dimension));
}

}  // namespace kerf
