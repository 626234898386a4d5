// SPDX-License-Identifier: Apache-2.0
// Bodies of one material that are joined and lie side by side, as where the drawing of a body is
// divided along the axis of the jet, are one body to the jet.
#pragma once

namespace kerf {

struct Case;
struct Workpiece;

// Gives the slots of such bodies one number in Workpiece::body, the least of theirs, and marks it
// in Workpiece::is_united. Two bodies lie side by side if few lines along the jet pass both, and so
// neither two layers nor a body and an inclusion in it do.
void unite_bodies(const Case& description, Workpiece& workpiece);

}  // namespace kerf
