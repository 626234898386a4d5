// SPDX-License-Identifier: Apache-2.0
// FractureResult is what a fracture step returns, and SolidState the state of a solid in a
// checkpoint.
#pragma once

#include <cstdint>
#include <vector>

#include "core/vector.hpp"
#include "fracture/grady_kipp.hpp"
#include "fracture/strength_rate.hpp"
#include "materials/plastic_state.hpp"
#include "parallel/loops.hpp"

namespace kerf {

struct FractureResult {
  std::uint64_t bonds = 0;  // broken, each counted once
  Index detached = 0;       // particles that became detached
  double released = 0.0;    // J (2D: J/m): stored energy before less after, hourglass part included
};

// The state of a solid without positions and velocities, which the caller has: its bonds, and the
// acceleration, because the kick of a step may come before accelerate().
template <int D, class P>
struct SolidState {
  std::vector<std::uint32_t> bond_intact;       // bits
  std::vector<typename P::Real> elastic_share;  // s of solid/limit_break_energy.hpp
  std::vector<Vector<D, typename P::Real>> acceleration;
  std::vector<Vector<D, typename P::Real>> mirror_acceleration;  // empty without such planes
  std::vector<PlasticState<D, typename P::Real>> flow;           // empty where nothing flows
  std::vector<typename P::Real> strain;                          // empty where nothing softens
  std::vector<FlawState<typename P::Real>> flaws;                // empty where nothing has flaws
  std::vector<Loading<typename P::Real>> loading;  // empty where no strength depends on the rate
};

}  // namespace kerf
