// SPDX-License-Identifier: Apache-2.0
// This header declares what the limits of the process (ulimit) leave of the memory. Libraries that
// read fonts and write HDF5 end the program by a signal where an allocation of theirs fails, so the
// limits are tested before they are reached.
#pragma once

namespace kerf {

// Returns the bytes that the process may still allocate by its limits, less what its threads and
// the libraries take in any run; infinity where there is no limit, and less than 0 where they leave
// too little.
double memory_within_limits();

// Throws UserError (exit_run_failed) where the limits leave too little for any run.
void refuse_small_limits();

}  // namespace kerf
