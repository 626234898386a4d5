// SPDX-License-Identifier: Apache-2.0
// Puts a particle whose motion is prescribed where it is to be: clamped or moved by expression, or
// water in a nozzle.
#pragma once

#include "integrate/drive.hpp"
#include "particles/fields.hpp"

namespace kerf {

template <int D, class P>
KERF_FUNCTION void follow_drive(const ParticleView<D, P>& particles, const Drive<D>* drives,
                                Index i) {
  const Drive<D>& drive = drives[particles.source[i]];
  Vector<D, double> displacement = drive.displacement;
  Vector<D, double> velocity = drive.velocity;
  if (particles.has(i, flag::upstream)) {
    const double speed = particles.inlet_speed[i];
    displacement += (speed * drive.open_time) * drive.direction;
    velocity += (speed * drive.open_fraction) * drive.direction;
  }
  particles.position[i] = particles.start_position[i] + displacement;
  particles.velocity[i] = Vector<D, typename P::Real>::from(velocity);
}

}  // namespace kerf
