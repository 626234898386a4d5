// SPDX-License-Identifier: Apache-2.0
#include "verification/placement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <regex>

#include "geometry/jet_direction.hpp"
#include "geometry/lattice_angle.hpp"
#include "geometry/plane_turn.hpp"
#include "model/case.hpp"

namespace kerf {

namespace {

Point moved_by(const Point& x, const Point& shift) {
  return {x[0] + shift[0], x[1] + shift[1], x[2] + shift[2]};
}

PlaneTurn turn_of(const Placement& placement) {
  return PlaneTurn(placement.angle, placement.mirrored);
}

// The unit vector at right angles to the first jet, in the plane of x and y.
Point across_jet(const Jet& jet) {
  const Point direction = jet_direction(jet);
  const double length = std::hypot(direction[0], direction[1]);
  return {-direction[1] / length, direction[0] / length, 0.0};
}

Point shift_of(const Case& written, const Placement& placement) {
  if (placement.moved == 0.0 || written.jets.empty()) return {};
  const Jet& jet = written.jets.front();
  const Point across = across_jet(jet);
  const double by = placement.moved * jet.spacing;
  return {by * across[0], by * across[1], 0.0};
}

// Returns the components of a vector in the run, each a formula of the components as written.
std::array<std::string, 3> turned(const std::array<std::string, 3>& v, const PlaneTurn& turn) {
  return {fmt::format("{:.17g}*({})-({:.17g})*({})", turn.c * turn.side, v[0], turn.s, v[1]),
          fmt::format("{:.17g}*({})+({:.17g})*({})", turn.s * turn.side, v[0], turn.c, v[1]), v[2]};
}

// Writes x and y of the case as written in terms of those of the run.
std::string in_coordinates_of_run(const std::string& formula, const PlaneTurn& turn) {
  const std::string x =
      fmt::format("({:.17g}*(x_run)+({:.17g})*(y_run))", turn.side * turn.c, turn.side * turn.s);
  const std::string y = fmt::format("({:.17g}*(x_run)+({:.17g})*(y_run))", -turn.s, turn.c);
  std::string result = std::regex_replace(formula, std::regex("\\bx\\b"), x);
  result = std::regex_replace(result, std::regex("\\by\\b"), y);
  result = std::regex_replace(result, std::regex("\\bx_run\\b"), "x");
  return std::regex_replace(result, std::regex("\\by_run\\b"), "y");
}

void mirror_sides(Faces& faces, const PlaneTurn& turn) {
  if (turn.side < 0.0) std::swap(faces.minimum[0], faces.maximum[0]);
}

void place(Body& body, const PlaneTurn& turn) {
  body.shape = turned(body.shape, turn);
  if (body.grading.around) body.grading.around = turned(*body.grading.around, turn);
  for (auto& line : body.grading.lines) {
    line.origin = turn(line.origin);
    line.direction = turn(line.direction);
  }
  for (std::string& component : body.velocity) component = in_coordinates_of_run(component, turn);
  body.velocity = turned(body.velocity, turn);
  if (!body.displacement[0].empty()) body.displacement = turned(body.displacement, turn);
  mirror_sides(body.absorbing, turn);
  body.offset[0] *= turn.side;
  body.lattice_angle *= turn.side;
  if (turn.side > 0.0) return;
  if (body.repelling_layer == RepellingLayer::left)
    body.repelling_layer = RepellingLayer::right;
  else if (body.repelling_layer == RepellingLayer::right)
    body.repelling_layer = RepellingLayer::left;
}

void place(Load& load, const PlaneTurn& turn) {
  if (load.region) load.region = turned(*load.region, turn);
  load.traction = turn(load.traction);
  load.acceleration = turn(load.acceleration);
}

// Contains the turned domain and the nozzles, of which `reach` is the half of the largest width.
Box turned_domain(const Case& description, const Box& written, const PlaneTurn& turn) {
  auto corners = corners_of(written);
  turn_corners(corners, turn);
  Box box = written;
  for (std::size_t a = 0; a < 2; ++a) {
    box.minimum[a] = box.maximum[a] = corners.front()[a];
    for (const auto& corner : corners) {
      box.minimum[a] = std::min(box.minimum[a], corner[a]);
      box.maximum[a] = std::max(box.maximum[a], corner[a]);
    }
    for (const Jet& jet : description.jets) {
      const double exit = jet.position[a] - jet.standoff * jet_direction(jet)[a];
      const double reach = jet.width + 8.0 * jet.spacing;
      box.minimum[a] = std::min(box.minimum[a], exit - reach);
      box.maximum[a] = std::max(box.maximum[a], exit + reach);
    }
  }
  return box;
}

}  // namespace

Case placed(Case description, const Placement& placement) {
  if (placement.is_as_written()) return description;
  const PlaneTurn turn = turn_of(placement);
  const Point shift = shift_of(description, placement);
  const Box domain = description.domain;
  const double delay = PlacementInverse(description, placement).delay();
  for (Jet& jet : description.jets) {
    // The direction (sin angle, -cos angle) of a jet in the plane of x and y turns by the angle.
    const Point direction = turn(jet_direction(jet));
    if (description.dimension == 2 || std::sin(jet.angle) != 0.0 || direction[0] != 0.0) {
      jet.angle = std::atan2(direction[0], -direction[1]);
      jet.azimuth = 0.0;
    }
    jet.position = turn(moved_by(jet.position, shift));
    jet.traverse = turn(jet.traverse);
    jet.standoff *= placement.standoff;
  }
  for (Probe& probe : description.probes) {
    probe.position = turn(moved_by(probe.position, shift));
    probe.normal = turn(probe.normal);
  }
  std::vector<Body*> bodies;
  for (Body& body : description.bodies) {
    place(body, turn);
    bodies.push_back(&body);
  }
  for (Load& load : description.loads) place(load, turn);
  description.gravity = turn(description.gravity);
  mirror_sides(description.symmetry, turn);
  description.domain = turned_domain(description, domain, turn);
  orient_lattices(bodies, {description.symmetry, description.domain}, description.dimension);
  if (delay > 0.0) description.time.end += delay;
  return description;
}

PlacementInverse::PlacementInverse(const Case& written, const Placement& placement)
    : placement_(placement), shift_(shift_of(written, placement)) {
  std::size_t next = 0;
  for (const Probe& probe : written.probes) {
    const bool is_point = !probe.is_plane();
    vectors_.push_back(is_point ? next + 1 : next);
    next += is_point ? 4 : 3;
  }
  for (const Jet& jet : written.jets)
    delay_ = std::max(delay_, (placement.standoff - 1.0) * jet.standoff / jet.speed);
}

std::array<double, 3> PlacementInverse::vector(const std::array<double, 3>& v) const {
  return turn_of(placement_).back(v);
}

Frame PlacementInverse::frame(Frame frame) const {
  if (placement_.is_as_written()) return frame;
  for (auto& x : frame.position) {
    x = vector(x);
    for (std::size_t a = 0; a < 3; ++a) x[a] -= shift_[a];
  }
  for (auto& v : frame.velocity) v = vector(v);
  frame.time -= delay_;
  return frame;
}

Balance PlacementInverse::balance(Balance balance) const {
  if (placement_.is_as_written()) return balance;
  for (auto* v : {&balance.momentum_initial, &balance.momentum_now, &balance.momentum_in,
                  &balance.momentum_out, &balance.impulse_gravity, &balance.impulse_rigid,
                  &balance.impulse_constraint, &balance.impulse_load, &balance.impulse_water,
                  &balance.force_rigid, &balance.force_water})
    *v = vector(*v);
  return balance;
}

std::vector<double> PlacementInverse::probe_values(std::vector<double> values) const {
  for (const std::size_t first : vectors_) {
    const auto back = vector({values[first], values[first + 1], values[first + 2]});
    std::copy(back.begin(), back.end(), values.begin() + static_cast<std::ptrdiff_t>(first));
  }
  return values;
}

}  // namespace kerf
