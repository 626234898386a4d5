// SPDX-License-Identifier: Apache-2.0
// The broken bonds of the workpiece.
#pragma once

namespace kerf {

struct Frame;
struct Workpiece;

// Returns the sum of the shares of their bonds that its particles have lost, 1 for each that is no
// solid any more; bonds to particles that are loose from the start count too. `frame` is that of a
// run, also with symmetry planes. A field "damage" that it lacks counts as none.
double broken_bond_sum(const Workpiece& workpiece, const Frame& frame);

}  // namespace kerf
