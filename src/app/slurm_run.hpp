// SPDX-License-Identifier: Apache-2.0
// This header declares a run that Slurm makes on a node of its own choice.
#pragma once

#include <string>
#include <vector>

#include "study/slurm_request.hpp"

namespace kerf {

struct SlurmRun {
  std::string name;                    // of the job
  std::string folder;                  // for the results; the output of the run is beside it
  std::vector<std::string> arguments;  // of the program
  SlurmResources resources;
  std::string resume_command;
};

// Submits a run, prints what it prints while it runs, and returns its exit code. After a signal the
// job goes on, and the code is 128 plus the number of the signal. Throws UserError when Slurm
// refuses the job, does not answer, or ends the job before the run has ended.
int run_on_slurm(const SlurmRun& run);

}  // namespace kerf
