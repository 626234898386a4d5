// SPDX-License-Identifier: Apache-2.0
// StepMotion is the largest displacement of a particle in a step and the largest speed at its end.
// As long as they are small, a neighbour list is valid without a visit to every particle
// (neighbours/list_validity.hpp).
#pragma once

#include <cmath>

#include "particles/fields.hpp"

namespace kerf {

struct StepMotion {
  double farthest, fastest;  // m, m/s
};

// Its squares, for a reduction over particles in any order.
struct MotionSquares {
  double farthest = 0.0, fastest = 0.0;  // m^2, m^2/s^2

  template <int D, class P>
  KERF_FUNCTION void include(const ParticleView<D, P>& particles, Index i) {
    if (particles.is_asleep(i)) return;
    const auto moved = particles.position[i] - particles.start_position[i];
    const auto velocity = Vector<D, double>::from(particles.velocity[i]);
    join({dot(moved, moved), dot(velocity, velocity)});
  }
  // A NaN is kept.
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
