// SPDX-License-Identifier: Apache-2.0
// A run goes on beyond its end where the case has a later one. The last step of a run is shortened
// to its end, so the run continues from the state before that step, with the same bits as a run
// that had the later end from the start and the same times of output.
#pragma once

namespace kerf {

struct RunLoopSettings;

// Where the checkpoint in the folder is of the same case with an earlier end, lets the run continue
// from it: its series keeps its interval, and frames that are due at equal intervals keep theirs. A
// case with the same end and other times of output continues with those of the checkpoint.
// Otherwise, and where no run is continued, it changes nothing. Throws UserError for a checkpoint
// that cannot be read.
void continue_to_later_end(RunLoopSettings& settings);

}  // namespace kerf
