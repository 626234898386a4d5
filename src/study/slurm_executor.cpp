// SPDX-License-Identifier: Apache-2.0
#include "study/slurm_executor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <thread>

#include "core/error.hpp"
#include "study/slurm_array.hpp"

namespace kerf {

namespace {

constexpr int most_submissions = 5;  // of one run

struct Watched {
  const Job* job = nullptr;
  int submissions = 0;
  int missing = 0;  // polls in a row that found it neither queued nor ended
  bool is_started = false;
};

// The queue of one call of run().
class SlurmQueue {
 public:
  SlurmQueue(SlurmArrays& arrays, ArrayRequest request, JobWatcher& watcher,
             const std::vector<Job>& jobs)
      : arrays_(arrays), request_(std::move(request)), watcher_(watcher) {
    for (const Job& job : jobs) open_[job.id].job = &job;
  }

  void run(std::chrono::duration<double> pause) {
    begin();
    while (!open_.empty()) {
      if (const auto queue = asked()) update(*queue);
      std::vector<Job> at_work;
      for (const auto& [id, watched] : open_)
        if (watched.is_started) at_work.push_back(*watched.job);
      if (watcher_.look(at_work)) return;
      if (!open_.empty()) std::this_thread::sleep_for(pause);
    }
  }

 private:
  // An old mark of failure is removed when a run is repeated; a mark of success is used.
  void begin() {
    const auto queue = asked();
    std::vector<std::string> fresh;
    for (auto& [id, watched] : open_) {
      const bool is_queued = queue && queue->count(id) > 0;
      const bool is_done = arrays_.exit_code(id) == 0;
      if (!is_queued && !is_done) fresh.push_back(id);
    }
    submit(fresh);
  }

  std::optional<std::map<std::string, bool>> asked() {
    auto queue = arrays_.in_queue();
    silences_ = queue ? 0 : silences_ + 1;
    if (silences_ > most_silences || (silences_ > 0 && !has_answered_))
      throw UserError(
          fmt::format("--on slurm: squeue does not answer: {} Is Slurm installed and "
                      "running here? {}",
                      arrays_.last_complaint(),
                      has_answered_ ? "Queued runs continue; start the study again to adopt them."
                                    : "This start has queued no run."),
          exit_files);
    has_answered_ = has_answered_ || queue.has_value();
    return queue;
  }

  void update(const std::map<std::string, bool>& queue) {
    std::vector<std::string> lost, ended;
    for (auto& [id, watched] : open_) {
      const auto queued = queue.find(id);
      if (queued != queue.end()) {
        watched.missing = 0;
        if (queued->second) note_start(watched);
      } else if (arrays_.exit_code(id)) {
        ended.push_back(id);
      } else if (++watched.missing >= most_missing_polls) {
        lost.push_back(id);
      }
    }
    for (const std::string& id : ended) end(id, {*arrays_.exit_code(id), 0, ""});
    std::vector<std::string> again;
    for (const std::string& id : lost) {
      if (open_[id].submissions < most_submissions)
        again.push_back(id);
      else
        end(id, {1, 0,
                 fmt::format("Slurm ended it {} times before it was done. Does it need more "
                             "time or memory than its partition gives",
                             most_submissions)});
    }
    submit(again);
  }

  void note_start(Watched& watched) {
    if (watched.is_started) return;
    watched.is_started = true;
    watcher_.started(*watched.job);
  }

  void end(const std::string& id, const JobEnd& how) {
    Watched& watched = open_[id];
    note_start(watched);  // it may have started and ended between two polls
    if (watcher_.ended(*watched.job, how))
      submit({id});
    else
      open_.erase(id);
  }

  void submit(const std::vector<std::string>& ids) {
    if (ids.empty()) return;
    request_.resources.memory = 0.0;
    for (const std::string& id : ids) {
      Watched& watched = open_[id];
      ++watched.submissions;
      watched.missing = 0;
      watched.is_started = false;
      request_.resources.memory = std::max(request_.resources.memory, watched.job->memory);
    }
    arrays_.submit(ids, request_);
  }

  SlurmArrays& arrays_;
  ArrayRequest request_;
  JobWatcher& watcher_;
  std::map<std::string, Watched> open_;
  int silences_ = 0;
  bool has_answered_ = false;
};

}  // namespace

void SlurmExecutor::run(const std::vector<Job>& jobs, JobWatcher& watcher) {
  SlurmArrays arrays(study_folder_);
  SlurmQueue(arrays, {program_, budget_.jobs, {budget_.cores, 0.0, budget_.device, budget_.ranks}},
             watcher, jobs)
      .run(std::chrono::duration<double>(budget_.poll_pause));
}

}  // namespace kerf
