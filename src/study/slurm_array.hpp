// SPDX-License-Identifier: Apache-2.0
// This header declares the job arrays of one study. In the folder slurm/ of the study, N.list holds
// the runs of array N, one in a line, and ID.exit the exit code of a run that has ended.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "study/slurm_request.hpp"

namespace kerf {

struct ArrayRequest {
  std::filesystem::path program;
  int at_once = 1;
  SlurmResources resources;  // of each task
};

class SlurmArrays {
 public:
  explicit SlurmArrays(std::filesystem::path study_folder);

  // Submits the runs. Throws UserError with the message of sbatch.
  void submit(const std::vector<std::string>& ids, const ArrayRequest& request);
  // Returns the queued runs and whether each is running; nothing when Slurm does not answer.
  std::optional<std::map<std::string, bool>> in_queue() const;
  std::optional<int> exit_code(const std::string& id) const;
  void forget_exit_code(const std::string& id) const;
  const std::string& last_complaint() const { return complaint_; }

 private:
  void submit_one(const std::vector<std::string>& ids, const ArrayRequest& request);
  int next_number() const;

  std::filesystem::path study_folder_, folder_;
  std::string name_;  // the name of the jobs without the number of the array
  mutable std::string complaint_;
};

}  // namespace kerf
