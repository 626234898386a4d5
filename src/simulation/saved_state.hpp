// SPDX-License-Identifier: Apache-2.0
// This header declares a test of the state of a run before it is restored. The engines take numbers
// of media, columns and particles from it without tests of their own.
#pragma once

#include "simulation/archive.hpp"

namespace kerf {

struct Case;

// Throws UserError (exit_files) unless every array of `saved` has the type and the length that it
// has in `fresh`, the state of the same case at its start, and its numbers are possible.
// Particles may be more or fewer.
void check_saved_state(const Archive& saved, const Archive& fresh, const Case& description);

}  // namespace kerf
