// SPDX-License-Identifier: Apache-2.0
// Checks of bodies and probes that need the complete case.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "geometry/fill.hpp"
#include "geometry/nozzle.hpp"
#include "geometry/particle_estimate.hpp"
#include "geometry/shapes.hpp"
#include "input/draft.hpp"
#include "input/read.hpp"
#include "input/units.hpp"
#include "machine/jet_water.hpp"
#include "machine/simulated_piece.hpp"
#include "model/case.hpp"

namespace kerf {

namespace {

std::string position_text(const Point& point, int dimension) {
  const std::string xy = fmt::format("{:.6g} m, {:.6g} m", point[0], point[1]);
  return dimension == 2 ? fmt::format("({})", xy) : fmt::format("({}, {:.6g} m)", xy, point[2]);
}

std::string box_text(const Box& box, int dimension) {
  return fmt::format("from {} to {}", position_text(box.minimum, dimension),
                     position_text(box.maximum, dimension));
}

bool box_within(const Box& inner, const Box& outer, int dimension) {
  for (std::size_t a = 0; a < static_cast<std::size_t>(dimension); ++a)
    if (inner.minimum[a] < outer.minimum[a] || inner.maximum[a] > outer.maximum[a]) return false;
  return true;
}

// Returns the domain without bounds at symmetry planes, beyond which mirror images replace the
// particles.
Box domain_of_bodies(const Case& description) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Box box = description.domain;
  for (std::size_t a = 0; a < 3; ++a) {
    if (description.symmetry.minimum[a]) box.minimum[a] = -infinity;
    if (description.symmetry.maximum[a]) box.maximum[a] = infinity;
  }
  return box;
}

bool box_is_empty(const Box& box, int dimension) {
  for (std::size_t a = 0; a < static_cast<std::size_t>(dimension); ++a)
    if (box.minimum[a] >= box.maximum[a]) return true;
  return false;
}

Box common_part(const Box& a, const Box& b) {
  Box box;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    box.minimum[axis] = std::max(a.minimum[axis], b.minimum[axis]);
    box.maximum[axis] = std::min(a.maximum[axis], b.maximum[axis]);
  }
  return box;
}

// Returns whether the point is inside the shape by more than `depth` along every axis; bodies may
// touch.
bool deep_inside(const Shape& shape, const Point& point, double depth, int dimension) {
  if (!contains(shape, point, dimension)) return false;
  for (std::size_t a = 0; a < static_cast<std::size_t>(dimension); ++a)
    for (const double sign : {-1.0, 1.0}) {
      Point beside = point;
      beside[a] += sign * depth;
      if (!contains(shape, beside, dimension)) return false;
    }
  return true;
}

// Returns the first particle of `body` inside `other`; of very many particles `most` are tested.
std::optional<Point> particle_inside(const Body& body, const Body& other, int dimension,
                                     double most) {
  LatticeVisit request;
  request.window =
      common_part(bounding_box(body.shape, dimension), bounding_box(other.shape, dimension));
  if (box_is_empty(request.window, dimension)) return {};
  std::optional<Point> found;
  request.visit = [&](const Point& point) {
    if (deep_inside(other.shape, point, 0.25 * body.spacing, dimension)) found = point;
    return !found;
  };
  visit_sample(body, dimension, request, most);
  return found;
}

// Where the lattice has more than `most` nodes, that many are tested, and a body with more volume
// than a few particles holds one.
bool holds_a_particle(const Body& body, int dimension, double most) {
  constexpr double few = 10.0;
  bool found = false;
  LatticeVisit request;
  request.window = bounding_box(body.shape, dimension);
  request.visit = [&](const Point&) {
    found = true;
    return false;
  };
  visit_sample(body, dimension, request, most);
  return found || (lattice_nodes(body, dimension) > most &&
                   volume_estimate(body.shape, dimension) > few * particle_volume(body, dimension));
}

void check_overlap(Draft& draft, std::size_t i, std::size_t j) {
  const Body& first = draft.result.bodies[i];
  const Body& second = draft.result.bodies[j];
  const int dimension = draft.reading.dimension;
  const double most = draft.effort.most_tested;
  auto found = particle_inside(first, second, dimension, most);
  if (!found) found = particle_inside(second, first, dimension, most);
  if (!found) return;
  draft.reading.problems.add(
      {body_key(draft, j, "shape"),
       fmt::format("the body \"{}\" overlaps the body \"{}\", for example at {}", second.name,
                   first.name, position_text(*found, dimension)),
       "bodies that touch at most",
       "Move one of them or cut it away with a shape of the type \"difference\""});
}

// Returns the key that sets the spacing of the [workpiece]: its own, that of the [machine], or the
// length from which the width of the jet follows, which grows beyond the coherent length. Where the
// jet is one that machines have, the size of the workpiece is to blame.
std::string key_of_spacing(const Draft& draft) {
  constexpr double widest_usual = 0.02;  // m, of a jet
  for (const char* key : {"workpiece.spacing", "machine.spacing"})
    if (draft.reading.problems.is_written(key)) return key;
  const Machine& machine = *draft.result.machine;
  if (draft.jets.back().jet.width <= widest_usual) return "workpiece.size";
  return machine.standoff > machine.coherent_length ? "machine.standoff"
                                                    : "machine.orifice_diameter";
}

// Returns where the spacing of bodies that state none comes from: the width of the jet of a
// machine, which a long standoff widens.
std::string reason_of_spacing(const Draft& draft, const std::string& key) {
  std::string reason = fmt::format(": it is that of the jet, which is {} wide at the workpiece",
                                   show_quantity(draft.jets.back().jet.width, "m"));
  if (key == "machine.standoff")
    reason += fmt::format(" after a standoff of {}, of which it keeps together for {}",
                          show_quantity(draft.result.machine->standoff, "m"),
                          show_quantity(draft.result.machine->coherent_length, "m"));
  return reason;
}

void add_no_particle_of_body(Draft& draft, std::size_t number) {
  const Body& body = draft.result.bodies[number];
  const std::string spacing = show_quantity(body.spacing, "m");
  const std::string cause = draft.result.machine ? key_of_spacing(draft) : std::string();
  const bool is_of_machine = cause.starts_with("machine.") && !cause.ends_with(".spacing") &&
                             !draft.reading.problems.is_written(body_key(draft, number, "spacing"));
  draft.reading.problems.add(
      {is_of_machine ? cause : body_key(draft, number, "shape"),
       is_of_machine
           ? fmt::format("no particle of the body \"{}\" fits into it at the spacing of {}{}",
                         body.name, spacing, reason_of_spacing(draft, cause))
           : fmt::format("no particle of the body \"{}\" fits into it", body.name),
       fmt::format("a shape that contains a lattice point at {}", spacing),
       is_of_machine ? "Correct this length or its unit, or give the body a spacing"
                     : "Choose a smaller spacing or correct the shape"});
}

// Refuses a body in which no particle fits. The spacing of a [workpiece] follows from its jet.
void add_no_particle(Draft& draft, std::size_t number) {
  const Body& body = draft.result.bodies[number];
  const std::string spacing = show_quantity(body.spacing, "m");
  if (draft.bodies[number].path != "workpiece") return add_no_particle_of_body(draft, number);
  const std::string wide = fmt::format("a spacing of less than {}, which fits into the workpiece",
                                       show_quantity(draft.workpiece.setting.size[1], "m"));
  const std::string key = key_of_spacing(draft);
  const bool is_written = key.ends_with(".spacing");
  const std::string reason = is_written ? "" : reason_of_spacing(draft, key);
  draft.reading.problems.add(
      {key,
       fmt::format("no particle fits into the workpiece at the spacing of {}{}", spacing, reason),
       wide,
       is_written ? "Lower it"
                  : "Correct this length or its unit, or give workpiece.spacing: two particles or "
                    "more across the thickness are bonded"});
}

}  // namespace

std::string body_key(const Draft& draft, std::size_t number, std::string_view key) {
  const std::string& path = draft.bodies[number].path;
  const bool is_size = path == "workpiece" && key == "shape";
  return fmt::format("{}.{}", path, is_size ? "size" : key);
}

namespace {

// Returns the key to which a body owes the number of its particles: its spacing, or the size of a
// [workpiece] for which no spacing is stated.
std::string key_of_count(const Draft& draft, std::size_t number) {
  const bool is_workpiece = draft.bodies[number].path == "workpiece";
  if (!is_workpiece || !draft.result.machine) return body_key(draft, number, "spacing");
  const std::string key = key_of_spacing(draft);
  return key.ends_with(".spacing") ? key : std::string("workpiece.size");
}

// Returns the number of particles of a body: of one whose lattice has too many nodes, about those
// that its grading and the symmetry planes leave.
double counted_particles(const Case& result, const Body& body, double most) {
  const double nodes = lattice_nodes(body, result.dimension);
  if (nodes <= most || nodes > quick_look.most_particles) return nodes;
  return estimate_particles(body, result.dimension, {result.symmetry, result.domain}).total();
}

constexpr const char* coarser_body = "Choose a larger spacing or a smaller shape";
constexpr const char* coarser_jet =
    "Choose a larger spacing, a smaller [domain] or an earlier end of the [time]";

}  // namespace

void check_counts(Draft& draft) {
  const Case& result = draft.result;
  const double most = draft.effort.most_particles;
  const std::string allowed = fmt::format("at most {:g} particles", ReadEffort{}.most_particles);
  double total = 0.0;
  const auto count = [&](const std::string& path, double particles, const char* remedy) {
    total += particles;
    if (total <= most) return;
    draft.reading.problems.add(
        {path, fmt::format("this makes {:.3g} particles", particles), allowed, remedy});
    total = 0.0;
  };
  for (std::size_t i = 0; i < result.bodies.size(); ++i)
    count(key_of_count(draft, i), counted_particles(result, result.bodies[i], most), coarser_body);
  for (std::size_t i = 0; i < result.jets.size(); ++i)
    count(draft.jets[i].path + ".spacing",
          most_jet_water(result, result.jets[i], result.time.end) +
              10.0 * nozzle_columns(result.jets[i], result.dimension),
          coarser_jet);
}

void check_bodies(Draft& draft) {
  const Case& result = draft.result;
  const int dimension = result.dimension;
  const Box domain = domain_of_bodies(result);
  for (std::size_t i = 0; i < result.bodies.size(); ++i) {
    const Body& body = result.bodies[i];
    const std::string path = body_key(draft, i, "shape");
    const Box around = bounding_box(body.shape, dimension);
    if (!box_within(around, domain, dimension))
      draft.reading.problems.add({path,
                                  fmt::format("the body \"{}\" reaches {} and leaves the domain",
                                              body.name, box_text(around, dimension)),
                                  "shapes inside the domain, " + box_text(result.domain, dimension),
                                  "Move the body or enlarge the [domain]"});
    if (!holds_a_particle(body, dimension, draft.effort.most_tested)) add_no_particle(draft, i);
  }
  draft.reading.problems.throw_if_any();
  for (std::size_t j = 1; j < result.bodies.size(); ++j)
    for (std::size_t i = 0; i < j; ++i) check_overlap(draft, i, j);
}

void check_probes(Draft& draft) {
  const Case& result = draft.result;
  for (std::size_t i = 0; i < result.probes.size(); ++i) {
    const Point& position = result.probes[i].position;
    if (box_within({position, position}, result.domain, result.dimension)) continue;
    draft.reading.problems.add({indexed("probe", i) + ".position",
                                "the probe is outside the domain",
                                "positions " + box_text(result.domain, result.dimension),
                                "Move the probe or enlarge the [domain]"});
  }
}

}  // namespace kerf
