// SPDX-License-Identifier: Apache-2.0
// Prescribed motion over one step, or a part of one: of clamped or moved bodies and of water in a
// nozzle.
#pragma once

#include "particles/fields.hpp"

namespace kerf {

// What the water of one column of a nozzle does inside it.
struct ColumnFlow {
  double distance;     // m, along the jet since the start of the step
  double speed;        // m/s, mean over the step
  double compression;  // 1
};

// One per medium. Displacement and velocity of a jet's medium are those of its nozzle.
template <int D>
struct PrescribedMotion {
  Vector<D, double> displacement;  // m, since the start of the step
  Vector<D, double> velocity;      // m/s, mean over the step
  // Of jets only.
  Vector<D, double> direction;     // unit vector
  Vector<D, double> exit;          // m, centre of the nozzle's exit
  const ColumnFlow* columns;       // of its nozzle
  double back_flow_removal_speed;  // m/s, slower water along the jet is removed
  bool removes_back_flow;
};

// Moves particle i, whose motion is prescribed, from its position at the start of the step.
template <int D, class P>
KERF_FUNCTION void apply_prescribed_motion(const ParticleView<D, P>& particles,
                                           const PrescribedMotion<D>* motions, Index i) {
  const PrescribedMotion<D>& motion = motions[particles.source[i]];
  Vector<D, double> displacement = motion.displacement;
  Vector<D, double> velocity = motion.velocity;
  if (particles.has(i, flag::upstream)) {
    const ColumnFlow& column = motion.columns[particles.inlet_column[i]];
    displacement += column.distance * motion.direction;
    velocity += column.speed * motion.direction;
    particles.compression[i] = static_cast<typename P::Real>(column.compression);
  }
  particles.position[i] = particles.start_position[i] + displacement;
  particles.velocity[i] = Vector<D, typename P::Real>::from(velocity);
}

}  // namespace kerf
