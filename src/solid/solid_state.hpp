// SPDX-License-Identifier: Apache-2.0
// What goes in and out of a total Lagrangian solid besides places and forces: the book of a break
// and the state that a checkpoint holds.
#pragma once

#include <cstdint>
#include <vector>

#include "core/vector.hpp"
#include "exec/exec.hpp"
#include "fracture/grady_kipp.hpp"
#include "materials/plastic_state.hpp"

namespace kerf {

struct FractureBook {
  std::uint64_t bonds = 0;  // broken, each counted once
  Index loosened = 0;       // particles that came loose
  double released = 0.0;    // J (2D: J/m): stored energy before less after, hourglass part included
  double power_gain = 0.0;  // W (2D: W/m): power of the bonds on the moving particles, after less
                            // before
};

// What a solid remembers beside positions and velocities, which are the caller's: its bonds, and
// the acceleration, because the kick of a step may come before accelerate().
template <int D, class P>
struct SolidState {
  std::vector<std::uint32_t> whole;  // bits
  std::vector<Vector<D, typename P::Real>> acceleration;
  std::vector<Vector<D, typename P::Real>> mirror_acceleration;  // empty without such planes
  std::vector<PlasticState<D, typename P::Real>> flow;           // empty where nothing flows
  std::vector<typename P::Real> strain;                          // empty where nothing softens
  std::vector<FlawState<typename P::Real>> flaws;                // empty where nothing has flaws
};

}  // namespace kerf
