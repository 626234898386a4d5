// SPDX-License-Identifier: Apache-2.0
#include "app/slurm_run.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <fstream>
#include <thread>

#include "app/executor_options.hpp"
#include "app/signals.hpp"
#include "core/error.hpp"
#include "output/files.hpp"
#include "study/slurm_job.hpp"

namespace kerf {

namespace fs = std::filesystem;

namespace {

constexpr auto pause_of_looks = std::chrono::milliseconds(500);
constexpr int looks_for_each_poll = 4;  // at the output, for each question to Slurm

// The growing file of what a run prints.
class PrintedOutput {
 public:
  explicit PrintedOutput(fs::path file) : file_(std::move(file)) {}

  // Prints what was added since the last call.
  void print_new() {
    std::ifstream stream(file_, std::ios::binary);
    stream.seekg(printed_);
    for (char block[4096]; stream.read(block, sizeof block) || stream.gcount() > 0;) {
      const auto count = stream.gcount();
      printed_ += count;
      std::fwrite(block, 1, static_cast<std::size_t>(count), stdout);
    }
    std::fflush(stdout);
  }

 private:
  fs::path file_;
  std::streamoff printed_ = 0;
};

class FollowedRun {
 public:
  FollowedRun(const SlurmRun& run, const fs::path& output, const JobRequest& request)
      : run_(run), output_(output), job_(request) {
    fmt::print(stderr, "kerf run: job {} of Slurm; what it prints goes to {} too\n", job_.id(),
               output.string());
  }

  int follow() {
    for (int look = 0;; ++look) {
      const auto code = job_.exit_code();
      output_.print_new();
      if (code) {
        job_.forget_exit_code();
        return *code;
      }
      if (signals_.caught() != 0) return leave(signals_.caught());
      if (look % looks_for_each_poll == 0) ask();
      std::this_thread::sleep_for(pause_of_looks);
    }
  }

 private:
  int leave(int signal) const {
    fmt::print(stderr,
               "kerf run: job {0} goes on. `kerf view {1}` shows its run, `scancel {0}` ends it.\n",
               job_.id(), run_.folder);
    return 128 + signal;
  }

  void ask() {
    const auto is_queued = job_.is_queued();
    silences_ = is_queued ? 0 : silences_ + 1;
    if (silences_ > most_silences)
      throw UserError(fmt::format("--on slurm: squeue does not answer: {} Job {} goes on.",
                                  job_.last_complaint(), job_.id()),
                      exit_files);
    missing_ = is_queued.value_or(true) ? 0 : missing_ + 1;
    if (missing_ >= most_missing_polls && !job_.exit_code())
      throw UserError(fmt::format("Slurm ended job {} before its run had ended: by scancel, or for "
                                  "want of time or memory. Go on with: {}",
                                  job_.id(), run_.resume_command),
                      exit_run_failed);
  }

  const StopSignals signals_;  // from before there is a job
  const SlurmRun& run_;
  PrintedOutput output_;
  SlurmJob job_;
  int silences_ = 0, missing_ = 0;
};

}  // namespace

int run_on_slurm(const SlurmRun& run) {
  const fs::path output = run.folder + ".txt";
  if (output.has_parent_path()) make_folder(output.parent_path());
  JobRequest request{run.name, start_words(run.resources, fs::read_symlink(this_program)), output,
                     run.resources};
  request.command.insert(request.command.end(), run.arguments.begin(), run.arguments.end());
  return FollowedRun(run, output, request).follow();
}

}  // namespace kerf
