// SPDX-License-Identifier: Apache-2.0
// Who makes the runs of a study: child processes of this machine, or a cluster.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace kerf {

// One run of the program.
struct Job {
  std::string id;
  std::filesystem::path case_file;
  std::filesystem::path folder;  // of its results
  std::filesystem::path output;  // takes what the run says
  double memory = 0.0;           // bytes, estimate
};

struct JobEnd {
  int exit_code = 0;    // 0 = the run is at its end
  int signal = 0;       // that ended it; 0 = none
  std::string problem;  // why it was not run, or what is known of its end; may be empty
};

// Told what happens.
class JobWatcher {
 public:
  virtual ~JobWatcher() = default;
  virtual void started(const Job& job) = 0;
  // True when the job is to be run again.
  virtual bool ended(const Job& job, const JobEnd& end) = 0;
  // Called now and then, with the jobs at work; true when everything is to be stopped.
  virtual bool look(const std::vector<Job>& at_work) = 0;
};

class Executor {
 public:
  virtual ~Executor() = default;
  // Returns when all jobs have ended, or none is at work any more after the watcher asked to stop.
  virtual void run(const std::vector<Job>& jobs, JobWatcher& watcher) = 0;
  virtual int side_by_side() const = 0;
};

}  // namespace kerf
