// SPDX-License-Identifier: Apache-2.0
// This header declares the laboratory of real runs: every run is in study.db and has a folder.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "study/case_maker.hpp"
#include "study/executor.hpp"
#include "study/laboratory.hpp"
#include "study/study_database.hpp"

namespace kerf {

// The progress of the last call of run().
struct StudyProgress {
  std::size_t total = 0, ended = 0, failed = 0, at_work = 0;
  double share = 0.0;     // completed share, from 0 to 1, parts of runs included
  int round = 0;          // number of the call
  std::size_t timed = 0;  // runs that have ended and say how long they took, also before the call
  double run_time = 0.0;  // s, of these runs together
};

// Returns the time that is left, s, after `seconds` of this call, which began at `first_share`:
// that of the runs still to make at the mean time of those that have ended. A run that was found
// finished has its own time, not the moment in which it was found. Until one has ended it follows
// from the share; infinite = unknown.
double seconds_left(const StudyProgress& now, double first_share, double seconds);

// This is thrown when a study must stop. A new start of the study continues it.
struct StudyStopped {
  int signal = 0;
};

class StudyRuns : public Laboratory, private JobWatcher {
 public:
  struct Hooks {
    std::function<void(const StudyProgress&)> show;
    std::function<int()> stop_signal;  // 0 = continue
  };

  // Puts runs that an earlier process left running back into the queue, with `retry` failed ones
  // too.
  StudyRuns(std::filesystem::path folder, const CaseMaker& maker, StudyDatabase& database,
            Executor& executor, Hooks hooks, bool retry);

  // Throws UserError, which names all of the trials whose case is not valid; no run is made.
  void refuse_invalid(const std::vector<Trial>& trials) const;
  std::vector<Outcome> run(const std::vector<Trial>& trials) override;
  int side_by_side() const override { return executor_.side_by_side(); }
  // Returns the runs that were requested of this object, in the order of study.db.
  std::vector<RunRow> asked() const;

 private:
  void started(const Job& job) override;
  bool ended(const Job& job, const JobEnd& end) override;
  bool look(const std::vector<Job>& at_work) override;

  Job prepared(const ResolvedCase& resolved) const;
  void finish(const Job& job);
  void count_time(const Metrics& metrics);

  std::filesystem::path folder_;
  const CaseMaker& maker_;
  StudyDatabase& database_;
  Executor& executor_;
  Hooks hooks_;
  std::set<std::string> asked_;
  std::map<std::string, int> crashes_;  // of a run, since this object began
  StudyProgress progress_;
  std::chrono::steady_clock::time_point shown_{};
  int signal_ = 0;
};

// Returns the folder of a run's results, relative to that of the study: "runs/ID".
std::filesystem::path run_folder(const std::string& id);

}  // namespace kerf
