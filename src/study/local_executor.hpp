// SPDX-License-Identifier: Apache-2.0
// This header declares the executor of this machine: runs are child processes, as many at the same
// time as cores and memory allow.
#pragma once

#include <string>

#include "study/executor.hpp"

namespace kerf {

struct LocalBudget {
  int cores = 1;
  int jobs = 1;                // at the same time at most
  double memory = 0.0;         // bytes, for all running runs together
  std::string device = "cpu";  // of kerf run
};

class LocalExecutor : public Executor {
 public:
  // `program` is the executable of Kerf.
  LocalExecutor(std::filesystem::path program, const LocalBudget& budget)
      : program_(std::move(program)), budget_(budget) {}

  // Waits for a run whose folder a process of a killed study still holds. A run gets its share of
  // the cores when it starts. Children end with this process; a child that gets the signal to stop
  // writes its checkpoint first.
  void run(const std::vector<Job>& jobs, JobWatcher& watcher) override;
  int side_by_side() const override { return budget_.jobs; }

 private:
  std::filesystem::path program_;
  LocalBudget budget_;
};

// Returns the available memory, bytes: free memory and the system's cache of files, within the
// limits of the process.
double available_memory();

// Returns the budget of this machine: all cores and four fifths of the free memory.
LocalBudget budget_of_machine();

}  // namespace kerf
