// SPDX-License-Identifier: Apache-2.0
#include "machine/characteristic_speed.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/fill.hpp"
#include "geometry/nozzle.hpp"
#include "geometry/shapes.hpp"
#include "model/case.hpp"
#include "model/expression.hpp"

namespace kerf {

namespace {

constexpr double sampled_particles = 1e5;
constexpr int sampled_times = 2000;

// An expression that is not finite somewhere has no largest value.
double faster(double fastest, double speed) {
  return std::isfinite(speed) ? std::max(fastest, speed) : std::numeric_limits<double>::infinity();
}

std::vector<Expression> parsed(const std::array<std::string, 3>& formulas,
                               const std::vector<std::string>& variables) {
  std::vector<Expression> expressions;
  for (const auto& formula : formulas) expressions.emplace_back(formula, variables);
  return expressions;
}

double fastest_start(const Body& body, int dimension) {
  const auto velocity = parsed(body.velocity, {"x", "y", "z"});
  double fastest = 0.0;
  LatticeVisit request;
  request.window = bounding_box(body.shape, dimension);
  const double nodes = lattice_nodes(body, dimension) / sampled_particles;
  request.stride = std::max(1L, static_cast<long>(std::ceil(std::pow(nodes, 1.0 / dimension))));
  request.visit = [&](const Point& point) {
    fastest =
        faster(fastest, std::hypot(velocity[0](point), velocity[1](point), velocity[2](point)));
    return true;
  };
  visit_particles(body, dimension, request);
  return fastest;
}

// The velocity is a finite difference over a two-thousandth of the run.
double fastest_motion(const Body& body, double end) {
  if (body.displacement[0].empty()) return 0.0;
  const auto displacement = parsed(body.displacement, {"t"});
  const double interval = end / sampled_times;
  const auto at = [&](int i) {
    return Point{displacement[0].evaluate(i * interval), displacement[1].evaluate(i * interval),
                 displacement[2].evaluate(i * interval)};
  };
  double fastest = 0.0;
  for (int i = 0; i < sampled_times; ++i) {
    const Point before = at(i), after = at(i + 1);
    fastest = faster(
        fastest,
        std::hypot(after[0] - before[0], after[1] - before[1], after[2] - before[2]) / interval);
  }
  return fastest;
}

}  // namespace

double fastest_jet(const Case& description) {
  double fastest = 0.0;
  for (const Jet& jet : description.jets)
    fastest = std::max(fastest, fastest_water(jet, description.dimension));
  return fastest;
}

double fastest_body(const Case& description) {
  double fastest = 0.0;
  for (const Body& body : description.bodies) {
    if (body.role != Role::rigid)
      fastest = std::max(fastest, fastest_start(body, description.dimension));
    fastest = std::max(fastest, fastest_motion(body, description.time.end));
  }
  return fastest;
}

double falling_speed(const Case& description) {
  const Point& g = description.gravity;
  const double gravity = std::hypot(g[0], g[1], g[2]);
  if (gravity == 0.0) return 0.0;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double low = infinity, high = -infinity;
  for (const Body& body : description.bodies) {
    if (body.role != Role::water) continue;
    const Box box = bounding_box(body.shape, description.dimension);
    // Corners of the box along the direction of gravity.
    double centre = 0.0, reach = 0.0;
    for (std::size_t a = 0; a < 3; ++a) {
      centre += 0.5 * (box.minimum[a] + box.maximum[a]) * g[a] / gravity;
      reach += 0.5 * (box.maximum[a] - box.minimum[a]) * std::abs(g[a]) / gravity;
    }
    low = std::min(low, centre - reach);
    high = std::max(high, centre + reach);
  }
  return high > low ? std::sqrt(2.0 * gravity * (high - low)) : 0.0;
}

double characteristic_speed(const Case& description) {
  const double fastest = std::max(fastest_jet(description), fastest_body(description));
  return fastest > 0.0 ? fastest : falling_speed(description);
}

}  // namespace kerf
