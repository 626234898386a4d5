// SPDX-License-Identifier: Apache-2.0
// Runs as child processes of this one, as many at once as cores and memory allow.
#pragma once

#include <string>

#include "study/executor.hpp"

namespace kerf {

struct LocalBudget {
  int cores = 1;
  int jobs = 1;                // at once, at most
  double memory = 0.0;         // bytes for all runs at once
  std::string device = "cpu";  // of kerf run
};

class LocalExecutor : public Executor {
 public:
  // `program` is the executable of Kerf.
  LocalExecutor(std::filesystem::path program, const LocalBudget& budget)
      : program_(std::move(program)), budget_(budget) {}

  // A run whose folder another process still holds, left over from a study that was killed, is
  // waited for. The threads of a run are its share of the cores when it starts. Children die with
  // this process; one whose stop is asked for writes its checkpoint first.
  void run(const std::vector<Job>& jobs, JobWatcher& watcher) override;
  int side_by_side() const override { return budget_.jobs; }

 private:
  std::filesystem::path program_;
  LocalBudget budget_;
};

// The budget of this machine: all cores, and four fifths of the memory that is free.
LocalBudget budget_of_machine();

}  // namespace kerf
