// SPDX-License-Identifier: Apache-2.0
// This signal is the extent of a body, from surface to surface. The surface is half a spacing
// beyond the outermost particle in the initial layout, and half the distance to its inner neighbour
// once deformed.
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "verification/signal.hpp"

namespace kerf {

namespace {

// The coordinate along x, y or z, or the distance from the y axis.
struct Along {
  std::size_t axis = 0;
  bool radial = false;

  double of(const Point& x) const { return radial ? std::hypot(x[0], x[2]) : x[axis]; }
  // Returns x moved by `distance` in this direction.
  Point moved(Point x, double distance) const {
    const double radius = of(x);
    if (!radial) {
      x[axis] += distance;
    } else if (radius > 0.0) {
      x[0] += distance * x[0] / radius;
      x[2] += distance * x[2] / radius;
    }
    return x;
  }
};

struct Edge {
  std::uint32_t outer, inner;  // ids of a particle at the surface and its neighbour inwards
};

double square_distance(const Point& a, const Point& b) {
  double sum = 0.0;
  for (std::size_t k = 0; k < 3; ++k) sum += (a[k] - b[k]) * (a[k] - b[k]);
  return sum;
}

struct Laid {
  std::uint32_t id;
  Point position;
  double spacing;
};

// Returns the outermost particles of the initial layout, `inwards` = -1 or +1, within a spacing of
// the outermost.
std::vector<Edge> find_edges(const std::vector<Laid>& particles, const Along& along,
                             double inwards) {
  const auto surface = [&](const Laid& particle) {
    return -inwards * along.of(particle.position) + 0.5 * particle.spacing;
  };
  double outermost = -std::numeric_limits<double>::infinity();
  for (const Laid& particle : particles) outermost = std::max(outermost, surface(particle));
  std::vector<Edge> edges;
  for (const Laid& particle : particles) {
    if (surface(particle) < outermost - 0.999 * particle.spacing) continue;
    const Point target = along.moved(particle.position, inwards * particle.spacing);
    const auto nearest =
        std::min_element(particles.begin(), particles.end(), [&](const Laid& a, const Laid& b) {
          return square_distance(a.position, target) < square_distance(b.position, target);
        });
    if (nearest->id != particle.id) edges.push_back({particle.id, nearest->id});
  }
  return edges;
}

}  // namespace

Signal extent_signal(const Parameters& parameters, const Beginning& beginning) {
  const std::string word = parameters.text("along");
  if (word != "x" && word != "y" && word != "z" && word != "radius")
    parameters.fail("along is x, y, z or radius");
  const Along along{word == "radius" ? 0 : static_cast<std::size_t>(word[0] - 'x'),
                    word == "radius"};
  const std::size_t body = named_body(parameters, beginning);
  const Frame& frame = beginning.frame;
  std::vector<Laid> particles;
  for (std::size_t row = 0; row < frame.id.size(); ++row)
    if (frame.source[row] == body)
      particles.push_back(
          {frame.id[row], frame.position[row], static_cast<double>(frame.spacing[row])});
  const auto upper = find_edges(particles, along, -1.0);
  const auto lower = along.radial ? std::vector<Edge>{} : find_edges(particles, along, 1.0);
  return [along, upper, lower](Moment& moment) {
    const Frame& now = moment.frame();
    std::vector<double> at(1 + *std::max_element(now.id.begin(), now.id.end()));
    for (std::size_t row = 0; row < now.id.size(); ++row)
      at[now.id[row]] = along.of(now.position[row]);
    const auto surface = [&](const Edge& e) { return 1.5 * at[e.outer] - 0.5 * at[e.inner]; };
    double most = -std::numeric_limits<double>::infinity(), least = along.radial ? 0.0 : -most;
    for (const Edge& edge : upper) most = std::max(most, surface(edge));
    for (const Edge& edge : lower) least = std::min(least, surface(edge));
    return most - least;
  };
}

}  // namespace kerf
