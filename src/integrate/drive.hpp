// SPDX-License-Identifier: Apache-2.0
// Prescribed motion over one (part of a) step: of clamped or moved bodies and of water in a nozzle.
#pragma once

#include "core/vector.hpp"

namespace kerf {

// One per source (body or jet; of a jet, displacement and velocity are those of its nozzle).
template <int D>
struct Drive {
  Vector<D, double> displacement;  // m, since the start of the step
  Vector<D, double> velocity;      // m/s, over the step
  // Jets only.
  Vector<D, double> direction;  // unit
  Vector<D, double> exit;       // m, centre of the nozzle's exit
  double open_time;             // s, how long the nozzle was open since the start of the step
  double open_fraction;         // of the step
  double erase_speed;           // m/s, water slower than this along the jet is erased
  bool erases;
};

}  // namespace kerf
