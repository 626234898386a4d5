// SPDX-License-Identifier: Apache-2.0
// This header declares what makes the runs of a study: child processes of this machine, or a
// cluster.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace kerf {

// One run of the program.
struct Job {
  std::string id;
  std::filesystem::path case_file;
  std::filesystem::path folder;  // for its results
  std::filesystem::path output;  // receives the output of the run
  double memory = 0.0;           // bytes, estimated
};

struct JobEnd {
  int exit_code = 0;    // 0 = the run was completed
  int signal = 0;       // the signal that ended it; 0 = none
  std::string problem;  // why it was not run or why it ended; may be empty
};

// A watcher is notified when jobs start and end.
class JobWatcher {
 public:
  virtual ~JobWatcher() = default;
  virtual void started(const Job& job) = 0;
  // Returns true when the job is to be run again.
  virtual bool ended(const Job& job, const JobEnd& end) = 0;
  // Is called at intervals with the running jobs; returns true to stop everything.
  virtual bool look(const std::vector<Job>& at_work) = 0;
};

class Executor {
 public:
  virtual ~Executor() = default;
  // Returns when all jobs have ended, or when none runs after a stop by the watcher.
  virtual void run(const std::vector<Job>& jobs, JobWatcher& watcher) = 0;
  // Returns how many jobs run at the same time.
  virtual int side_by_side() const = 0;
};

}  // namespace kerf
