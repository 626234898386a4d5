// SPDX-License-Identifier: Apache-2.0
// Where prescribed motion stands: displacement of moved bodies and how long each nozzle was open.
#pragma once

#include <vector>

#include "case/case.hpp"
#include "case/expression.hpp"
#include "integrate/drive.hpp"
#include "particles/nozzle.hpp"
#include "simulation/levels.hpp"

namespace kerf {

class Motion {
 public:
  Motion(const Case& description, const std::vector<Nozzle>& nozzles);

  // Prescribed motion from `start` to `now`, one entry per medium; `now` >= `start`.
  template <int D>
  std::vector<Drive<D>> drives(double start, double now) const {
    std::vector<Drive<D>> result;
    for (const MediumOrigin& origin : origins_)
      result.push_back(drive<D>(origin.source, start, now));
    return result;
  }

 private:
  Point displacement(std::size_t body, double time) const;

  template <int D>
  Drive<D> drive(std::size_t source, double start, double now) const {
    Drive<D> d{};
    const double dt = now - start;
    if (source < bodies_) {
      const Point from = displacement(source, start), to = displacement(source, now);
      for (int a = 0; a < D; ++a) d.displacement[a] = to[a] - from[a];
      if (dt > 0.0) d.velocity = (1.0 / dt) * d.displacement;
      return d;
    }
    const Nozzle& nozzle = (*nozzles_)[source - bodies_];
    d.direction = Vector<D, double>::from(nozzle.direction());
    d.exit = Vector<D, double>::from(nozzle.exit(now));
    const auto before = Vector<D, double>::from(nozzle.exit(start));
    d.displacement = d.exit - before;
    if (dt > 0.0) d.velocity = (1.0 / dt) * d.displacement;
    d.open_time = nozzle.open_time(now) - nozzle.open_time(start);
    d.open_fraction = dt > 0.0 ? d.open_time / dt : 0.0;
    d.erases = erases_;
    d.erase_speed = erase_speed_[source - bodies_];
    return d;
  }

  std::size_t bodies_;
  std::vector<MediumOrigin> origins_;
  const std::vector<Nozzle>* nozzles_;
  std::vector<std::vector<Expression>> expressions_;  // per body; empty = does not move
  std::vector<double> erase_speed_;                   // m/s, per jet
  bool erases_ = false;
};

}  // namespace kerf
