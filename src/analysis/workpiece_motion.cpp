// SPDX-License-Identifier: Apache-2.0
#include "analysis/workpiece_motion.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "analysis/workpiece.hpp"
#include "geometry/shapes.hpp"
#include "model/case.hpp"
#include "model/expression.hpp"

namespace kerf {
namespace {

// Where a body moves: by its displacement, else at its velocity of the start.
class PrescribedWay {
 public:
  PrescribedWay(const Body& body, int dimension) : velocity_(first_velocity(body, dimension)) {
    if (body.displacement[0].empty()) return;
    velocity_ = {};
    for (std::size_t a = 0; a < 3; ++a)
      if (!body.displacement[a].empty()) driven_[a].emplace(body.displacement[a], variables_);
  }
  // Returns where the body has moved until a time, s; m from its place at the start.
  Point until(double time) const {
    Point moved{};
    for (std::size_t a = 0; a < 3; ++a)
      moved[a] = driven_[a] ? driven_[a]->evaluate(time) : velocity_[a] * time;
    return moved;
  }

 private:
  static inline const std::vector<std::string> variables_{"t"};
  Point velocity_;  // m/s
  std::array<std::optional<Expression>, 3> driven_;
};

}  // namespace

std::array<double, 3> first_velocity(const Body& body, int dimension) {
  const Box box = bounding_box(body.shape, dimension);
  Point middle{}, velocity{};
  for (std::size_t a = 0; a < 3; ++a) middle[a] = (box.minimum[a] + box.maximum[a]) / 2.0;
  for (std::size_t a = 0; a < 3; ++a)
    velocity[a] = Expression(body.velocity[a], {"x", "y", "z"})(middle);
  return velocity;
}

std::array<double, 3> drift_of(const Case& description, const Workpiece& workpiece) {
  Point drift{};
  bool is_first = true;
  for (const WorkpieceBody& described : workpiece.bodies) {
    if (!described.is_in_way) continue;
    const Point velocity =
        first_velocity(description.bodies[described.body], description.dimension);
    if (!is_first && velocity != drift) return {};
    drift = velocity;
    is_first = false;
  }
  return drift;
}

double way_across_jet(const Case& description, const Body& body) {
  constexpr int samples = 64;  // of the run: a displacement may return
  const JetAxis jet(description.jets.front(), description.dimension);
  const PrescribedWay way_of_body(body, description.dimension);
  const Point start = jet.point_at(0.0, 0.0);
  double farthest = 0.0;
  for (int n = 1; n <= samples; ++n) {
    const double time = description.time.end * n / samples;
    const Point moved = way_of_body.until(time), nozzle = jet.point_at(0.0, time);
    double across = 0.0, aside = 0.0;
    for (std::size_t a = 0; a < 3; ++a) {
      const double way = moved[a] - (nozzle[a] - start[a]);
      across += way * jet.across[a];
      aside += way * jet.sideways[a];
    }
    farthest = std::max(farthest, std::hypot(across, aside));
  }
  return farthest;
}

}  // namespace kerf
