// SPDX-License-Identifier: Apache-2.0
// This header declares one command that is run as a job of Slurm.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "study/slurm_request.hpp"

namespace kerf {

struct JobRequest {
  std::string name;
  std::vector<std::string> command;  // the program and its arguments
  // Receives what the command prints; beside it, with .exit at its end, a file has the exit code.
  std::filesystem::path output;
  SlurmResources resources;
};

class SlurmJob {
 public:
  // Submits the command, to be run in the current folder, which the nodes must have under the same
  // path. Throws UserError with the message of sbatch.
  explicit SlurmJob(const JobRequest& request);

  const std::string& id() const { return id_; }
  // Returns whether Slurm still has the job, waiting or running; nothing when it does not answer.
  std::optional<bool> is_queued() const;
  const std::string& last_complaint() const { return complaint_; }
  // Returns the exit code of the command; nothing while it runs, and where Slurm ended it.
  std::optional<int> exit_code() const;
  // Removes the file of the exit code.
  void forget_exit_code() const;

 private:
  std::filesystem::path exit_file_;
  std::string id_;
  mutable std::string complaint_;
};

}  // namespace kerf
