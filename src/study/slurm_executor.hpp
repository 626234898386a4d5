// SPDX-License-Identifier: Apache-2.0
// Runs as tasks of job arrays of Slurm.
#pragma once

#include <chrono>

#include "study/executor.hpp"

namespace kerf {

struct SlurmBudget {
  int jobs = 16;               // at once, at most
  int cores = 1;               // of each
  double poll_pause = 2.0;     // s, between two questions to Slurm
  std::string device = "cpu";  // of kerf run; "gpu" asks for one GPU for each
};

class SlurmExecutor : public Executor {
 public:
  // `study_folder` must be seen by the nodes under the same path, as must the program.
  SlurmExecutor(std::filesystem::path program, std::filesystem::path study_folder,
                const SlurmBudget& budget)
      : program_(std::move(program)),
        study_folder_(std::filesystem::absolute(study_folder)),
        budget_(budget) {}

  // Tasks that an earlier study has in the queue are taken up, not submitted again. A task that was
  // cancelled, or lost its node, is submitted again. When the watcher asks to stop the tasks stay
  // where they are, for the next study to take up. Throws UserError when Slurm does not answer.
  void run(const std::vector<Job>& jobs, JobWatcher& watcher) override;
  int side_by_side() const override { return budget_.jobs; }

 private:
  std::filesystem::path program_, study_folder_;
  SlurmBudget budget_;
};

}  // namespace kerf
