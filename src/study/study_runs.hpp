// SPDX-License-Identifier: Apache-2.0
// The laboratory of real runs: every run is in study.db, and in a folder of its own.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "study/case_maker.hpp"
#include "study/executor.hpp"
#include "study/laboratory.hpp"
#include "study/study_database.hpp"

namespace kerf {

// Of the runs that were asked for last.
struct StudyProgress {
  std::size_t total = 0, ended = 0, failed = 0, at_work = 0;
  double share = 0.0;  // of them all, parts of runs included
};

// Thrown when a study was asked to stop; it goes on when it is started again.
struct StudyStopped {
  int signal = 0;
};

class StudyRuns : public Laboratory, private JobWatcher {
 public:
  struct Hooks {
    std::function<void(const StudyProgress&)> show;
    std::function<int()> stop_signal;  // 0 = go on
  };

  // Runs that an earlier study left at work are put back to the queue; those that failed too when
  // `retry` says so.
  StudyRuns(std::filesystem::path folder, const CaseMaker& maker, StudyDatabase& database,
            Executor& executor, Hooks hooks, bool retry);

  std::vector<Outcome> run(const std::vector<Trial>& trials) override;
  int side_by_side() const override { return executor_.side_by_side(); }
  // The runs that this object was asked for, in the order of study.db.
  std::vector<RunRow> asked() const;

 private:
  void started(const Job& job) override;
  bool ended(const Job& job, const JobEnd& end) override;
  bool look(const std::vector<Job>& at_work) override;

  Job prepared(const ResolvedCase& resolved) const;
  void finish(const Job& job);

  std::filesystem::path folder_;
  const CaseMaker& maker_;
  StudyDatabase& database_;
  Executor& executor_;
  Hooks hooks_;
  std::set<std::string> asked_;
  StudyProgress progress_;
  std::chrono::steady_clock::time_point shown_{};
  int signal_ = 0;
};

// The results of a run, from the folder of the study: "runs/ID".
std::filesystem::path run_folder(const std::string& id);

}  // namespace kerf
