// SPDX-License-Identifier: Apache-2.0
// The broken bonds of the workpiece.
#pragma once

#include <cstdint>
#include <vector>

namespace kerf {

struct Frame;
struct Workpiece;

// Returns the sum of the shares of their bonds that its particles have lost, 1 for each that is no
// solid any more; bonds to particles that are loose from the start count too. `frame` is that of a
// run, also with symmetry planes. A field "damage" that it lacks counts as none. `traces`: the
// slot_trace of each slot; what stood until it left the domain has broken no bond, and neither has
// what it left behind.
double broken_bond_sum(const Workpiece& workpiece, const Frame& frame,
                       const std::vector<std::uint8_t>& traces = {});

}  // namespace kerf
