// SPDX-License-Identifier: Apache-2.0
// The prescribed motion of a run: the displacement of moved bodies, and of nozzles with how long
// each was open.
#pragma once

#include <vector>

#include "geometry/nozzle.hpp"
#include "model/expression.hpp"
#include "particles/prescribed_motion.hpp"
#include "simulation/media_order.hpp"

namespace kerf {

struct Case;

// Returns the flow of each column of a nozzle from `start` to `now`. `water`: medium of the jet.
inline std::vector<ColumnFlow> column_flows(const Nozzle& nozzle, const Medium<double>& water,
                                            double start, double now) {
  std::vector<ColumnFlow> flows;
  for (std::size_t k = 0; k < nozzle.columns(); ++k) {
    const double distance = nozzle.travelled(k, now) - nozzle.travelled(k, start);
    flows.push_back({distance, now > start ? distance / (now - start) : 0.0,
                     compression_at(water, nozzle.pump(k).pressure())});
  }
  return flows;
}

class Motion {
 public:
  Motion() = default;  // of a run without bodies and jets
  explicit Motion(const Case& description);

  // Prescribed motion from `start` to `now`, one entry per medium; `now` >= `start`. The velocity
  // of a body is its mean from `start` to `end`, the end of the step: what bodies do to others in
  // the middle of a step then works over the distance that they go in it. The columns of nozzles
  // are those of column_flows() and are not set.
  template <int D>
  std::vector<PrescribedMotion<D>> between(double start, double now, double end,
                                           const std::vector<Nozzle>& nozzles) const {
    std::vector<PrescribedMotion<D>> result;
    for (const MediumOrigin& origin : origins_)
      result.push_back(origin.source < bodies_
                           ? of_body<D>(origin.source, start, now, end)
                           : of_jet<D>(origin.source - bodies_, nozzles, start, now));
    return result;
  }

  // Whether a medium is that of a body with prescribed displacement.
  bool moves(std::size_t medium) const {
    const std::size_t source = origins_.at(medium).source;
    return source < bodies_ && !expressions_[source].empty();
  }

 private:
  Point displacement(std::size_t body, double time) const;

  template <int D>
  PrescribedMotion<D> of_body(std::size_t body, double start, double now, double end) const {
    PrescribedMotion<D> motion{};
    const Point from = displacement(body, start), to = displacement(body, now);
    const Point at_end = end > now ? displacement(body, end) : to;
    for (int a = 0; a < D; ++a) {
      motion.displacement[a] = to[a] - from[a];
      if (end > start) motion.velocity[a] = (at_end[a] - from[a]) / (end - start);
    }
    return motion;
  }

  template <int D>
  PrescribedMotion<D> of_jet(std::size_t jet, const std::vector<Nozzle>& nozzles, double start,
                             double now) const {
    PrescribedMotion<D> motion{};
    const Nozzle& nozzle = nozzles[jet];
    const double dt = now - start;
    motion.direction = Vector<D, double>::from(nozzle.direction());
    motion.exit = Vector<D, double>::from(nozzle.exit(now));
    motion.displacement = motion.exit - Vector<D, double>::from(nozzle.exit(start));
    if (dt > 0.0) motion.velocity = (1.0 / dt) * motion.displacement;
    motion.removes_back_flow = removes_back_flow_;
    motion.back_flow_removal_speed = removal_speed_[jet];
    return motion;
  }

  std::size_t bodies_ = 0;
  std::vector<MediumOrigin> origins_;
  std::vector<std::vector<Expression>> expressions_;  // per body; empty = does not move
  std::vector<double> removal_speed_;                 // m/s, per jet
  bool removes_back_flow_ = false;
};

}  // namespace kerf
