// SPDX-License-Identifier: Apache-2.0
// This header declares the executor of a cluster: runs are tasks of job arrays of Slurm.
#pragma once

#include <chrono>

#include "study/executor.hpp"

namespace kerf {

struct SlurmBudget {
  int jobs = 16;               // at the same time at most
  int cores = 1;               // of each rank
  int ranks = 1;               // of each run
  double poll_pause = 2.0;     // s, between two polls of Slurm
  std::string device = "cpu";  // of kerf run; "gpu" requests one GPU for each
};

class SlurmExecutor : public Executor {
 public:
  // The nodes must have `study_folder` and the program under the same paths.
  SlurmExecutor(std::filesystem::path program, std::filesystem::path study_folder,
                const SlurmBudget& budget)
      : program_(std::move(program)),
        study_folder_(std::filesystem::absolute(study_folder)),
        budget_(budget) {}

  // Adopts tasks that an earlier call left in the queue. A task that was cancelled or lost its node
  // is submitted again. After a stop by the watcher the tasks stay in the queue, to be adopted
  // by the next study. Throws UserError when Slurm does not answer.
  void run(const std::vector<Job>& jobs, JobWatcher& watcher) override;
  int side_by_side() const override { return budget_.jobs; }

 private:
  std::filesystem::path program_, study_folder_;
  SlurmBudget budget_;
};

}  // namespace kerf
