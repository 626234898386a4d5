// SPDX-License-Identifier: Apache-2.0
// FractureResult is what a fracture step returns, and SolidState the state of a solid in a
// checkpoint, with the functions that take it from the fields and back.
#pragma once

#include <cstdint>
#include <vector>

#include "core/error.hpp"
#include "core/vector.hpp"
#include "fracture/grady_kipp.hpp"
#include "fracture/strength_rate.hpp"
#include "materials/plastic_state.hpp"
#include "parallel/loops.hpp"
#include "solid/solid_fields.hpp"

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

template <int D, class P>
SolidState<D, P> state_of(const SolidFields<D, P>& fields) {
  return {to_host(fields.bond_intact),  to_host(fields.elastic_share),
          to_host(fields.acceleration), to_host(fields.mirror_acceleration),
          to_host(fields.flow_start),   to_host(fields.strain_start),
          to_host(fields.flaws),        to_host(fields.loading_start)};
}

// Takes a state into the fields of a solid of the same layout; what follows from it is outdated.
template <int D, class P>
void restore_state(const SolidState<D, P>& state, SolidFields<D, P>& fields) {
  require(state.bond_intact.size() == fields.bond_intact.size() &&
              state.elastic_share.size() == fields.size() &&
              state.acceleration.size() == fields.size() &&
              state.mirror_acceleration.size() == fields.mirror_acceleration.size(),
          "the saved solid has the particles, bonds and symmetry planes of this case");
  require(state.flow.size() == fields.flow_start.size() &&
              state.strain.size() == fields.strain_start.size() &&
              state.flaws.size() == fields.flaws.size() &&
              state.loading.size() == fields.loading_start.size(),
          "the saved solid has the plastic flow, softening, flaws and strength of this case");
  to_device(state.bond_intact, fields.bond_intact);
  to_device(state.elastic_share, fields.elastic_share);
  to_device(state.acceleration, fields.acceleration);
  to_device(state.mirror_acceleration, fields.mirror_acceleration);
  to_device(state.flow, fields.flow_start);
  fields.current_flow = fields.flow_start;
  to_device(state.strain, fields.strain_start);
  fields.current_strain = fields.strain_start;
  to_device(state.flaws, fields.flaws);
  to_device(state.loading, fields.loading_start);
  fields.loading_now = fields.loading_start;
}

}  // namespace kerf
