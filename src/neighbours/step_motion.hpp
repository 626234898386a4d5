// SPDX-License-Identifier: Apache-2.0
// How far particles moved in a step at most, and how fast they are at its end: as long as that is
// little, a neighbour list holds without a look at every particle (list_validity.hpp).
#pragma once

#include <cmath>

#include "particles/fields.hpp"

namespace kerf {

struct StepMotion {
  double farthest, fastest;  // m, m/s
};

// What is added up for it, over particles in any order.
struct MotionSquares {
  double farthest = 0.0, fastest = 0.0;  // m^2, m^2/s^2

  template <int D, class P>
  KERF_FUNCTION void include(const ParticleView<D, P>& particles, Index i) {
    const auto moved = particles.position[i] - particles.start_position[i];
    const auto velocity = Vector<D, double>::from(particles.velocity[i]);
    join({dot(moved, moved), dot(velocity, velocity)});
  }
  // What is no number stays so.
  KERF_FUNCTION void join(const MotionSquares& other) {
    if (!(other.farthest <= farthest)) farthest = other.farthest;
    if (!(other.fastest <= fastest)) fastest = other.fastest;
  }
  StepMotion roots() const { return {std::sqrt(farthest), std::sqrt(fastest)}; }
};

// For reductions in any order.
template <int D, class P>
struct MotionOf {
  ParticleView<D, P> particles;

  KERF_FUNCTION MotionSquares operator()(Index i) const {
    MotionSquares result;
    result.include(particles, i);
    return result;
  }
};
struct FartherMotion {
  KERF_FUNCTION MotionSquares operator()(MotionSquares a, const MotionSquares& b) const {
    a.join(b);
    return a;
  }
};

}  // namespace kerf
