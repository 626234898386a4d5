// SPDX-License-Identifier: Apache-2.0
// This file implements kerf study: many runs of a case, their map and the search for a setting.
#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <memory>

#include "app/command_line.hpp"
#include "app/commands.hpp"
#include "app/embedded.hpp"
#include "app/progress.hpp"
#include "app/signals.hpp"
#include "core/error.hpp"
#include "output/files.hpp"
#include "study/local_executor.hpp"
#include "study/run_table.hpp"
#include "study/slurm_executor.hpp"
#include "study/study_answers.hpp"
#include "study/study_page.hpp"
#include "study/study_runs.hpp"

namespace kerf {

namespace {

namespace fs = std::filesystem;

struct StudyOptions {
  std::string file;
  std::string folder;
  int jobs = 0;
  int cores = 0;
  double memory = 0.0;  // GiB
  std::string where = "local";
  Device device = Device::cpu;
  bool retry = false;
  bool quiet = false;
};

// Returns the path of the program for the runs. A child process gets the running program, even if
// its file was replaced.
constexpr const char* this_program = "/proc/self/exe";

LocalBudget budget_of(const StudyOptions& options) {
  constexpr double gibibyte = 1024.0 * 1024.0 * 1024.0;
  LocalBudget budget = budget_of_machine();
  if (options.cores > 0) budget.cores = options.cores;
  budget.device = word_of(options.device);
  const int at_once = options.device == Device::gpu ? 1 : budget.cores;
  budget.jobs = options.jobs > 0 ? options.jobs : at_once;
  if (options.memory > 0.0) budget.memory = options.memory * gibibyte;
  return budget;
}

std::unique_ptr<Executor> executor_of(const StudyOptions& options, const fs::path& folder) {
  if (options.where == "local") {
    set_device(options.device);  // throws when it is not available
    return std::make_unique<LocalExecutor>(this_program, budget_of(options));
  }
  SlurmBudget budget;
  budget.device = word_of(options.device);
  if (options.jobs > 0) budget.jobs = options.jobs;
  if (options.cores > 0) budget.cores = options.cores;
  return std::make_unique<SlurmExecutor>(fs::read_symlink(this_program), folder, budget);
}

// Shows the progress of the runs.
class StudyDisplay {
 public:
  explicit StudyDisplay(ProgressStyle style) : style_(style) {}

  void show(const StudyProgress& now) {
    const auto time = Clock::now();
    const bool is_new_batch = now.total != last_.total || now.ended < last_.ended;
    if (is_new_batch) {
      start_ = time;
      start_share_ = now.share;
    }
    const bool has_changed = is_new_batch || now.ended != last_.ended;
    last_ = now;
    if (style_ == ProgressStyle::none) return;
    const std::string words = line(now, std::chrono::duration<double>(time - start_).count());
    if (style_ == ProgressStyle::bar) {
      bar_.show(now.share, words);
    } else if (has_changed) {
      fmt::print("{}\n", words);
      std::fflush(stdout);
    }
  }
  void clear() { bar_.clear(); }

 private:
  using Clock = std::chrono::steady_clock;

  std::string line(const StudyProgress& now, double seconds) const {
    const double done = now.share - start_share_;
    const double left = done > 0.0 ? (1.0 - now.share) * seconds / done : INFINITY;
    return fmt::format("{} of {} runs | at work {} | failed {} | left {}", now.ended, now.total,
                       now.at_work, now.failed, duration_text(left));
  }

  ProgressStyle style_;
  Bar bar_;
  StudyProgress last_;
  Clock::time_point start_ = Clock::now();
  double start_share_ = 0.0;
};

std::vector<Trial> design_trials(const StudyPlan& plan) {
  std::vector<Trial> trials;
  for (const Setting& setting : settings_of(*plan.design, plan.axes))
    for (int repeat = 0; repeat < plan.repeats; ++repeat)
      trials.push_back({setting, repeat, plan.refinement});
  return trials;
}

void find_answers(const StudyPlan& plan, StudyRuns& runs, StudyAnswers& answers) {
  const Trial middle{{}, 0, plan.refinement};
  if (plan.design) runs.run(design_trials(plan));
  if (plan.threshold) answers.threshold = find_threshold(*plan.threshold, middle, runs);
  if (plan.optimum) answers.optimum = find_optimum(*plan.optimum, plan.refinement, runs);
  if (plan.calibration) answers.calibration = calibrate(*plan.calibration, plan.refinement, runs);
}

// Computes the model and the boundary from the completed runs, also if some are missing.
void conclude(const StudyPlan& plan, const StudyRuns& runs, StudyAnswers& answers) {
  answers.runs = runs.asked();
  if (plan.model)
    answers.model =
        ReducedModel(*plan.model, model_data(*plan.model, plan.refinement, answers.runs));
  std::vector<RunRow> fine = answers.runs;
  std::erase_if(fine, [&](const RunRow& row) { return row.trial.refinement != plan.refinement; });
  answers.boundary = cut_boundary(all_axes(plan), fine);
}

void write_results(const StudyPlan& plan, const StudyAnswers& answers, const fs::path& folder) {
  write_file(folder / "study.csv", study_csv(plan, answers.runs));
  write_file(folder / "study.json", study_json(plan, answers));
  write_file(folder / "study.h5", study_hdf5(plan, answers.runs));
  const bool has_model = answers.model && answers.model->problem().empty();
  if (has_model)
    write_file(folder / "model.csv", answers.model->table_csv([&](const std::string& name) {
      return unit_of(plan, name);
    }));
  fmt::print("{}{}", study_text(plan, answers.runs), answers_text(describe_answers(plan, answers)));
  const std::string path = folder.string();
  fmt::print("  table      {0}/study.csv, {0}/study.json, {0}/study.h5{1}\n", path,
             has_model ? fmt::format(", {}/model.csv", path) : "");
  fmt::print("  page       {}/study.html\n", path);
}

// Lists failed runs and sets the exit code, after everything else is written.
void tell_failures(const std::vector<RunRow>& runs) {
  std::size_t failed = 0;
  for (const RunRow& row : runs) {
    if (row.state != RunState::failed) continue;
    ++failed;
    fmt::print("  {} failed: {}\n", row.id, row.error);
  }
  if (failed == 0) return;
  fmt::print("{} run{} failed. Correct the cause, then start the study again with --retry.\n",
             failed, failed == 1 ? "" : "s");
  throw CLI::RuntimeError(exit_run_failed);
}

void study(const StudyOptions& options) {
  const StudyPlan plan = read_study(options.file, case_templates());
  const fs::path folder =
      options.folder.empty() ? fs::path("out") / plan.name : fs::path(options.folder);
  make_folder(folder);
  const FolderLock lock(folder);
  StudyDatabase database(folder / "study.db");
  database.remember("study", plan.text);
  const CaseMaker maker(plan);
  const auto executor = executor_of(options, folder);
  if (!options.quiet) fmt::print("{}, results in {}\n", plan.title, folder.string());
  const StopSignals signals;
  StudyDisplay display(progress_style(options.quiet));
  StudyPageFile page(plan, folder);
  const StudyRuns* made = nullptr;
  const auto show = [&](const StudyProgress& now) {
    display.show(now);
    page.follow(now.ended, now.total, [&] {
      StudyAnswers so_far;
      conclude(plan, *made, so_far);
      return so_far;
    });
  };
  StudyRuns runs(folder, maker, database, *executor, {show, [&] { return signals.caught(); }},
                 options.retry);
  made = &runs;
  StudyAnswers answers;
  const auto finish = [&](StudyState state) {
    display.clear();
    conclude(plan, runs, answers);
    write_results(plan, answers, folder);
    page.write(answers, state);
  };
  try {
    find_answers(plan, runs, answers);
  } catch (const StudyStopped& stopped) {
    finish(StudyState::stopped);
    fmt::print("Stopped. Continue with: kerf study {} --out {}\n", options.file, folder.string());
    throw CLI::RuntimeError(128 + stopped.signal);
  } catch (const UserError&) {
    finish(StudyState::stopped);
    throw;
  }
  finish(StudyState::ended);
  tell_failures(answers.runs);
}

}  // namespace

void add_study_command(CLI::App& program) {
  auto options = std::make_shared<StudyOptions>();
  CLI::App* command =
      program.add_subcommand("study", "Run a case with many settings, or search for a setting");
  command->add_option("STUDY", options->file, "the study file")->required();
  command->add_option("--out", options->folder, "folder for the results; default out/<study>");
  command
      ->add_option("--jobs", options->jobs,
                   "maximum number of concurrent runs; default: one per core, one on a GPU")
      ->check(CLI::Range(1, 4096));
  command
      ->add_option(
          "--cores", options->cores,
          "cores of all concurrent runs; default: all; with Slurm the cores of each run, default 1")
      ->check(CLI::Range(1, 4096));
  command
      ->add_option("--memory", options->memory,
                   "memory of all concurrent runs, in GiB; default: four fifths of the free memory")
      ->check(CLI::PositiveNumber);
  command->add_option("--on", options->where, "where runs are computed: this machine, or Slurm")
      ->check(CLI::IsMember({"local", "slurm"}))
      ->capture_default_str();
  add_device_option(*command, options->device);
  command->add_flag("--retry", options->retry, "repeat failed runs");
  command->add_flag("--quiet", options->quiet, "show the results only");
  command->callback([options] { study(*options); });
}

}  // namespace kerf
