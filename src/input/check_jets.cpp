// SPDX-License-Identifier: Apache-2.0
// Checks that a jet can start and can hit a body.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geometry/beside_jet.hpp"
#include "geometry/jet_direction.hpp"
#include "geometry/nozzle.hpp"
#include "geometry/shapes.hpp"
#include "geometry/water_line.hpp"
#include "input/draft.hpp"
#include "input/units.hpp"
#include "machine/characteristic_speed.hpp"
#include "machine/machine_jet.hpp"
#include "machine/travelling_frame.hpp"
#include "model/case.hpp"

namespace kerf {

namespace {

// To rounding: the nozzle of a jet that leans along a symmetry plane is on it.
bool inside(const Box& box, const Point& point, int dimension) {
  for (std::size_t a = 0; a < static_cast<std::size_t>(dimension); ++a) {
    const double slack = 1e-9 * (box.maximum[a] - box.minimum[a]);
    if (point[a] < box.minimum[a] - slack || point[a] > box.maximum[a] + slack) return false;
  }
  return true;
}

const Body* body_at(const Case& description, const Point& point) {
  for (const Body& body : description.bodies)
    if (contains(body.shape, point, description.dimension)) return &body;
  return nullptr;
}

Point along(const Point& start, const Point& direction, double distance) {
  Point point = start;
  for (std::size_t a = 0; a < 3; ++a) point[a] += distance * direction[a];
  return point;
}

// Tests points along a line in the box around a body, half a spacing apart: however large the
// domain is, they do not step over the body.
bool meets(const Body& body, const WaterLine& line, double length, int dimension) {
  constexpr double most_steps = 1e5;
  WayPart part = way_within(bounding_box(body.shape, dimension), line, dimension);
  part.end = std::min(part.end, length);
  const double way = part.end - part.begin;
  if (!(way >= 0.0)) return false;
  const double steps = std::clamp(std::ceil(way / (0.5 * body.spacing)), 1.0, most_steps);
  for (double step = 0.0; step <= steps; ++step)
    if (contains(body.shape, line.at(part.begin + step / steps * way), dimension)) return true;
  return false;
}

// Returns the water that stands in a nozzle, its rows `factor` times as far from the exit: those of
// fewer columns have the distances of all.
std::vector<InletParticle> rows_moved(const Nozzle& nozzle, double factor) {
  std::vector<InletParticle> water = nozzle.standing_water();
  const Point exit = nozzle.exit(0.0), direction = nozzle.direction();
  for (InletParticle& particle : water) {
    double before = 0.0;
    for (std::size_t a = 0; a < 3; ++a) before += (particle.position[a] - exit[a]) * direction[a];
    particle.position = along(particle.position, direction, (factor - 1.0) * before);
  }
  return water;
}

// Tests a few columns of the jet, up to the end of the domain.
bool hits_a_body(const Case& description, const Nozzle& nozzle,
                 const std::vector<InletParticle>& water) {
  constexpr std::size_t most_columns = 50;
  double length = 0.0;
  for (std::size_t a = 0; a < 3; ++a)
    length += description.domain.maximum[a] - description.domain.minimum[a];
  const std::size_t stride = std::max<std::size_t>(1, water.size() / most_columns);
  for (std::size_t i = 0; i < water.size(); i += stride)
    for (const Body& body : description.bodies)
      if (meets(body, {water[i].position, nozzle.direction()}, length, description.dimension))
        return true;
  return false;
}

// Returns whether a body lies along the jet: beside its outermost column of particles, but within a
// spacing of its water, as the wall of a channel. It is within reach of that column, and what flows
// past it is a case of its own.
bool flows_along_a_body(const Case& description, const Jet& jet, double most_tested) {
  constexpr double slack = 1.01;  // spacings: a face in the column is beside it
  std::vector<const Body*> bodies;
  for (const Body& body : description.bodies) bodies.push_back(&body);
  const BesideJet beside = beside_jet(jet, bodies, description.dimension, most_tested);
  if (beside.body == nullptr) return false;
  const double reach = std::max(jet.spacing, beside.body->spacing);
  if (beside.distance > reach) return false;
  Jet columns = jet;
  columns.width = std::max(0.0, jet.width - slack * jet.spacing);
  return beside_jet(columns, bodies, description.dimension, most_tested).distance > 0.0;
}

// Returns for how long the nozzle moves beside the workpiece before the cut begins, s. Bodies that
// move come to it at another time; whether a point is inside a mesh takes long.
double time_beside_bodies(const Case& description, const Jet& jet) {
  if (fastest_body(description) > 0.0 || travelling_frame(description)) return 0.0;
  std::vector<const Body*> bodies;
  for (const Body& body : description.bodies)
    if (body.role == Role::elastic && !body.fixed && body.shape.kind != Shape::Kind::mesh)
      bodies.push_back(&body);
  double longest = 0.0;  // through the whole domain
  for (std::size_t a = 0; a < 3; ++a)
    longest += description.domain.maximum[a] - description.domain.minimum[a];
  longest /= traverse_speed(jet);
  if (description.time.end > 0.0)
    longest = std::min(longest, description.time.end - jet.start - jet.dwell);
  return time_beside(jet, bodies, longest, description.dimension);
}

// Returns whether bodies move or gravity acts, so that the jet may hit a body later.
bool anything_moves(const Case& description) {
  const Point& g = description.gravity;
  return fastest_body(description) > 0.0 || g[0] != 0.0 || g[1] != 0.0 || g[2] != 0.0;
}

// A workpiece lies where its machine aims: the standoff decides where the water starts.
void add_start_inside(Draft& draft, std::size_t number, const Body& body) {
  const std::string& path = draft.jets[number].path;
  const std::string what = fmt::format("the jet starts inside the body \"{}\"", body.name);
  if (path == "machine" && draft.result.workpiece) {
    const double least = least_flight(draft.result.jets[number]);
    draft.reading.problems.add(
        {path + ".standoff", what,
         fmt::format("at least {} at this angle", show_quantity(least, "m", Bound::least)),
         "Lengthen the standoff or turn the angle"});
    return;
  }
  draft.reading.problems.add({path + ".position", what,
                              "a nozzle that is outside all bodies with its last 4 spacings",
                              "Move the jet, lengthen its standoff or turn its angle"});
}

void add_outside(Draft& draft, const std::string& path) {
  draft.reading.problems.add({path + ".position", "the nozzle is outside the domain",
                              "a nozzle that is in the domain with its last 4 spacings",
                              "Move the jet, shorten its standoff or enlarge the [domain]"});
}

void check_start(Draft& draft, std::size_t number, const std::vector<InletParticle>& water) {
  const Case& result = draft.result;
  const std::string& path = draft.jets[number].path;
  for (const InletParticle& particle : water) {
    if (!std::isfinite(particle.speed)) {
      draft.reading.problems.add({path + ".profile_expression",
                                  "the profile is 0 at every particle of the section",
                                  "a formula that is greater than 0 at some particles",
                                  "Correct the formula or choose a smaller spacing"});
      return;
    }
    if (!inside(result.domain, particle.position, result.dimension)) {
      add_outside(draft, path);
      return;
    }
    if (const Body* body = body_at(result, particle.position)) {
      add_start_inside(draft, number, *body);
      return;
    }
  }
}

// Refuses a nozzle that leaves the domain before the end of the run, or is never in it: beyond a
// symmetry plane it has no water that check_start() could see.
void check_traverse(Draft& draft, const std::string& path, const Nozzle& nozzle) {
  const Case& result = draft.result;
  const double end = result.time.end;
  if (!inside(result.domain, nozzle.exit(0.0), result.dimension)) return add_outside(draft, path);
  if (inside(at_time(result, end).domain, nozzle.exit(end), result.dimension)) return;
  draft.reading.problems.add({path + (path == "machine" ? ".traverse_speed" : ".traverse"),
                              "the nozzle leaves the domain before the end of the run",
                              "a nozzle that is in the domain until the end",
                              "Enlarge the [domain], or let the run end earlier"});
}

// Says where the straight water of a jet flows that meets no body.
std::string miss_text(const Draft& draft, const Jet& jet) {
  std::vector<const Body*> bodies;
  for (const Body& body : draft.result.bodies) bodies.push_back(&body);
  const BesideJet beside =
      beside_jet(jet, bodies, draft.result.dimension, draft.effort.most_tested);
  if (beside.body == nullptr) return "the jet points away from every body";
  return fmt::format(
      "the jet passes beside every body: its water is {:.3g} m from the nearest, \"{}\"",
      beside.distance, beside.body->name);
}

// Returns whether a body is within the breadth of the jet, but between its particles.
bool is_between_water(const Draft& draft, const Jet& jet) {
  std::vector<const Body*> bodies;
  for (const Body& body : draft.result.bodies) bodies.push_back(&body);
  return beside_jet(jet, bodies, draft.result.dimension, draft.effort.most_tested).distance <= 0.0;
}

void add_miss(Draft& draft, std::size_t number) {
  const Jet& jet = draft.result.jets[number];
  const std::string& path = draft.jets[number].path;
  if (path != "machine" && is_between_water(draft, jet)) {
    draft.reading.problems.add(
        {path + (draft.result.dimension == 3 ? ".diameter" : ".width"),
         fmt::format("the bodies lie between the particles of this jet, which are {} apart",
                     show_quantity(jet.spacing, "m")),
         "a jet whose particles meet a body", "Choose a narrower jet or a smaller jet.spacing"});
    return;
  }
  draft.reading.problems.add(
      {path + ".position", miss_text(draft, jet), "a position and an angle whose line meets a body",
       traverse_speed(jet) > 0.0 ? "Let the path of the nozzle come over a body before the run ends"
                                 : "Aim the jet at the workpiece: angle 0 is straight down"});
}

}  // namespace

// Of several jets one must hit; `kerf check` warns of the others.
void check_jets(Draft& draft) {
  for (Jet& jet : draft.result.jets) jet.time_beside = time_beside_bodies(draft.result, jet);
  const Case& result = draft.result;
  bool one_hits = result.bodies.empty() || anything_moves(result);
  std::vector<std::size_t> misses;
  for (std::size_t i = 0; i < result.jets.size(); ++i) {
    const Jet& jet = result.jets[i];
    const std::string& path = draft.jets[i].path;
    const auto& water = result.materials[static_cast<std::size_t>(jet.material)];
    const Jet tested = coarsened(jet, result.dimension, draft.effort.most_tested);
    Nozzle nozzle(tested, water.density, result.dimension);
    nozzle.cut_at(result.symmetry, result.domain);
    const auto standing = rows_moved(nozzle, jet.spacing / tested.spacing);
    const std::size_t before = draft.reading.problems.count();
    check_start(draft, i, standing);
    if (draft.reading.problems.count() == before) check_traverse(draft, path, nozzle);
    if (draft.reading.problems.count() > before || one_hits) continue;
    one_hits = jet.time_beside > 0.0 || hits_a_body(result, nozzle, standing) ||
               flows_along_a_body(result, jet, draft.effort.most_tested);
    if (!one_hits) misses.push_back(i);
  }
  if (one_hits) return;
  for (const std::size_t number : misses) add_miss(draft, number);
}

}  // namespace kerf
