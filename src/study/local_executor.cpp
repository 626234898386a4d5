// SPDX-License-Identifier: Apache-2.0
#include "study/local_executor.hpp"

#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <deque>
#include <fstream>
#include <list>
#include <string>
#include <thread>

#include "core/error.hpp"
#include "output/files.hpp"
#include "study/child_process.hpp"
#include "study/process_limits.hpp"

namespace kerf {

namespace {

constexpr auto pause = std::chrono::milliseconds(20);  // between two polls of the children
constexpr double gibibyte = 1024.0 * 1024.0 * 1024.0;

bool is_in_use(const std::filesystem::path& folder) {
  if (!std::filesystem::exists(folder)) return false;
  try {
    const FolderLock lock(folder);
    return false;
  } catch (const UserError&) {
    return true;
  }
}

struct AtWork {
  Job job;
  int threads = 1;
  ChildProcess process;
};

// The queue of one call of run().
class LocalQueue {
 public:
  LocalQueue(const std::filesystem::path& program, const LocalBudget& budget, JobWatcher& watcher,
             const std::vector<Job>& jobs)
      : program_(program), budget_(budget), watcher_(watcher), waiting_(jobs.begin(), jobs.end()) {}

  void run() {
    while (!waiting_.empty() || !at_work_.empty()) {
      if (!stopping_) start_what_fits();
      reap();
      std::vector<Job> jobs;
      for (const AtWork& entry : at_work_) jobs.push_back(entry.job);
      if (watcher_.look(jobs) && !stopping_) stop();
      std::this_thread::sleep_for(pause);
    }
  }

 private:
  void start_what_fits() {
    for (auto job = waiting_.begin(); job != waiting_.end() && has_slot();) {
      if (job->memory > budget_.memory) {
        watcher_.ended(*job, {1, 0, too_large(*job)});
        job = waiting_.erase(job);
      } else if (fits(*job) && !is_in_use(job->folder)) {
        start(*job);
        job = waiting_.erase(job);
      } else {
        ++job;
      }
    }
  }

  bool has_slot() const {
    return static_cast<int>(at_work_.size()) < budget_.jobs && free_cores() > 0;
  }
  int free_cores() const {
    int free = budget_.cores;
    for (const AtWork& entry : at_work_) free -= entry.threads;
    return free;
  }
  bool fits(const Job& job) const {
    double memory = job.memory;
    for (const AtWork& entry : at_work_) memory += entry.job.memory;
    return memory <= budget_.memory;
  }
  std::string too_large(const Job& job) const {
    return fmt::format(
        "the run needs about {:.2g} GiB of memory and the study may use {:.2g} GiB. "
        "Raise --memory, or use a larger spacing",
        job.memory / gibibyte, budget_.memory / gibibyte);
  }

  void start(const Job& job) {
    const int slots = budget_.jobs - static_cast<int>(at_work_.size());
    const int takers = std::max(1, std::min(slots, static_cast<int>(waiting_.size())));
    const int threads = std::max(1, free_cores() / takers);
    watcher_.started(job);
    at_work_.push_back(
        {job, threads,
         ChildProcess(program_,
                      {"run", job.case_file.string(), "--out", job.folder.string(), "--threads",
                       std::to_string(threads), "--device", budget_.device, "--resume"},
                      job.output)});
  }

  void reap() {
    for (auto entry = at_work_.begin(); entry != at_work_.end();) {
      const auto end = entry->process.end();
      if (!end) {
        ++entry;
        continue;
      }
      const bool again = watcher_.ended(entry->job, *end);
      if (again && !stopping_) waiting_.push_back(entry->job);
      entry = at_work_.erase(entry);
    }
  }

  void stop() {
    stopping_ = true;
    waiting_.clear();
    for (AtWork& entry : at_work_) entry.process.send(SIGTERM);
  }

  const std::filesystem::path& program_;
  const LocalBudget& budget_;
  JobWatcher& watcher_;
  std::deque<Job> waiting_;
  std::list<AtWork> at_work_;
  bool stopping_ = false;
};

}  // namespace

double available_memory() {
  const double allowed = std::max(0.0, memory_within_limits());
  std::ifstream file("/proc/meminfo");
  std::string name, unit;
  for (double kibibytes = 0.0; file >> name >> kibibytes; std::getline(file, unit))
    if (name == "MemAvailable:") return std::min(allowed, 1024.0 * kibibytes);
  return std::min(allowed, static_cast<double>(sysconf(_SC_PHYS_PAGES)) *
                               static_cast<double>(sysconf(_SC_PAGESIZE)));
}

void LocalExecutor::run(const std::vector<Job>& jobs, JobWatcher& watcher) {
  LocalQueue(program_, budget_, watcher, jobs).run();
}

LocalBudget budget_of_machine() {
  constexpr double share = 0.8;
  const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  return {cores, cores, share * available_memory()};
}

}  // namespace kerf
