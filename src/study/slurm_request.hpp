// SPDX-License-Identifier: Apache-2.0
// This header declares what all submissions to Slurm share.
#pragma once

#include <string>
#include <vector>

namespace kerf {

struct SlurmResources {
  int cores = 1;               // of each run
  double memory = 0.0;         // bytes, of each run, as estimated
  std::string device = "cpu";  // of kerf run; "gpu" requests one GPU
};

// Returns a text as one word of a shell, whatever it holds.
std::string quoted_for_shell(const std::string& text);

// Calls sbatch with a request for the resources and further words, and returns the number of the
// job. What the job prints is dropped, as Slurm would expand % and \ in the name of its file: the
// script must redirect it. Throws UserError with the message of sbatch.
std::string submit_to_slurm(const SlurmResources& resources, const std::vector<std::string>& words);

}  // namespace kerf
