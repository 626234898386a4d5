// SPDX-License-Identifier: Apache-2.0
// Refuses bodies that are joined to one that no bond reaches: they would be two pieces.
#include <fmt/format.h>

#include <algorithm>
#include <boost/pending/disjoint_sets.hpp>
#include <cmath>
#include <limits>

#include "geometry/fill.hpp"
#include "geometry/shapes.hpp"
#include "input/draft.hpp"
#include "input/units.hpp"
#include "kernels/wendland_c2.hpp"
#include "model/case.hpp"

namespace kerf {

namespace {

Box with_margin(Box box, double margin, int dimension) {
  for (std::size_t a = 0; a < static_cast<std::size_t>(dimension); ++a) {
    box.minimum[a] -= margin;
    box.maximum[a] += margin;
  }
  return box;
}

double distance_of(const Point& a, const Point& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

// Returns how long a bond between particles of two bodies may be, m: less than the support of their
// mean smoothing length (solid/bond_weight.hpp). Graded bodies have the longest of their levels.
double bond_reach(const Case& description, const Body& a, const Body& b) {
  const auto coarsest = [](const Body& body) {
    return std::ldexp(body.spacing, body.grading.levels);
  };
  return WendlandC2<2>::support * description.smoothing_ratio * 0.5 * (coarsest(a) + coarsest(b));
}

// Whether the body has a particle nearer to the point than `reach`.
bool has_particle_near(const Body& body, const Point& point, double reach, int dimension) {
  bool found = false;
  LatticeVisit request;
  request.window = with_margin({point, point}, reach, dimension);
  request.visit = [&](const Point& other) {
    found = distance_of(point, other) < reach;
    return !found;
  };
  visit_particles(body, dimension, request);
  return found;
}

// Whether a bond can join the bodies. Where not all particles can be tested, it is taken for
// granted.
bool has_bond(const Draft& draft, const Body& a, const Body& b) {
  constexpr double most_tested = 1e5;
  const int dimension = draft.reading.dimension;
  const double reach = bond_reach(draft.result, a, b);
  const Box own = bounding_box(a.shape, dimension), other = bounding_box(b.shape, dimension);
  LatticeVisit request;
  request.window = with_margin(other, reach, dimension);
  for (std::size_t i = 0; i < static_cast<std::size_t>(dimension); ++i)
    if (own.minimum[i] > request.window.maximum[i] || own.maximum[i] < request.window.minimum[i])
      return false;
  bool found = false;
  request.visit = [&](const Point& point) {
    found = has_particle_near(b, point, reach, dimension);
    return !found;
  };
  return visit_sample(a, dimension, request, most_tested) > 1.0 || found;
}

std::vector<Point> some_particles(const Body& body, int dimension) {
  constexpr double most = 2000.0;
  std::vector<Point> particles;
  LatticeVisit request;
  request.window = bounding_box(body.shape, dimension);
  request.visit = [&](const Point& point) {
    particles.push_back(point);
    return true;
  };
  visit_sample(body, dimension, request, most);
  return particles;
}

// Returns the distance of the nearest particles of two bodies, m, about; of small bodies exactly.
double distance_between(const Body& a, const Body& b, int dimension) {
  double shortest = std::numeric_limits<double>::infinity();
  const std::vector<Point> others = some_particles(b, dimension);
  for (const Point& point : some_particles(a, dimension))
    for (const Point& other : others) shortest = std::min(shortest, distance_of(point, other));
  return shortest;
}

// Bodies that bonds can join, directly or through others of the same piece.
class Joints {
 public:
  explicit Joints(const Draft& draft)
      : draft_(draft), named_(draft.result.bodies.size()), bonded_(draft.result.bodies.size()) {
    const auto& bodies = draft.result.bodies;
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      named_.make_set(b);
      bonded_.make_set(b);
    }
    for (std::size_t b = 0; b < bodies.size(); ++b)
      if (!bodies[b].joined_to.empty()) named_.union_set(b, target_of(b));
    for (std::size_t a = 0; a < bodies.size(); ++a)
      for (std::size_t b = 0; b < a; ++b)
        if (named_.find_set(a) == named_.find_set(b) && has_bond(draft, bodies[a], bodies[b]))
          bonded_.union_set(a, b);
  }

  std::size_t target_of(std::size_t number) const {
    const auto& bodies = draft_.result.bodies;
    const auto is_target = [&](const Body& body) { return body.name == bodies[number].joined_to; };
    const auto found = std::find_if(bodies.begin(), bodies.end(), is_target);
    return static_cast<std::size_t>(found - bodies.begin());
  }
  bool are_one_piece(std::size_t a, std::size_t b) {
    return bonded_.find_set(a) == bonded_.find_set(b);
  }

 private:
  const Draft& draft_;
  boost::disjoint_sets_with_storage<> named_, bonded_;
};

}  // namespace

void check_joints(Draft& draft) {
  const auto& bodies = draft.result.bodies;
  const auto is_joined = [](const Body& body) { return !body.joined_to.empty(); };
  if (draft.reading.problems.any() || std::none_of(bodies.begin(), bodies.end(), is_joined)) return;
  Joints joints(draft);
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    if (!is_joined(bodies[b]) || joints.are_one_piece(b, joints.target_of(b))) continue;
    const Body& other = bodies[joints.target_of(b)];
    const bool is_inclusion = !draft.bodies[b].inclusion_of.empty();
    const double distance = distance_between(bodies[b], other, draft.reading.dimension);
    const double reach = bond_reach(draft.result, bodies[b], other);
    draft.reading.problems.add(
        {body_key(draft, b, is_inclusion ? "inclusion_of" : "joined_to"),
         fmt::format(
             "no bond joins \"{}\" to \"{}\": their nearest particles are about {:.3g} m apart",
             bodies[b].name, other.name, distance),
         fmt::format(
             "bodies whose nearest particles are less than {:.3g} m apart, such as ones that "
             "touch",
             reach),
         "Move the body to the face of the other, or remove the key"});
  }
}

}  // namespace kerf
