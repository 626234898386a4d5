// SPDX-License-Identifier: Apache-2.0
// This file implements kerf study: many runs of a case, their map and the search for a setting.
#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "app/command_line.hpp"
#include "app/commands.hpp"
#include "app/embedded.hpp"
#include "app/executor_options.hpp"
#include "app/signals.hpp"
#include "app/study_display.hpp"
#include "core/error.hpp"
#include "output/files.hpp"
#include "study/run_table.hpp"
#include "study/search_ends.hpp"
#include "study/study_answers.hpp"
#include "study/study_page.hpp"
#include "study/study_runs.hpp"

namespace kerf {

namespace {

namespace fs = std::filesystem;

struct StudyOptions {
  std::string file;
  std::string folder;
  ExecutorOptions executor;
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
  runs.refuse_invalid(search_ends(plan));
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
  const auto executor = make_executor(options.executor, folder);
  const StopSignals signals;
  StudyDisplay display(progress_style(options.executor.quiet));
  StudyPageFile page(plan, folder);
  const StudyRuns* made = nullptr;
  bool has_begun = false;
  const auto begin = [&] {
    if (!has_begun && !options.executor.quiet)
      fmt::print("{}, results in {}\n", plan.title, folder.string());
    has_begun = true;
  };
  const auto show = [&](const StudyProgress& now) {
    begin();
    display.show(now);
    page.follow(now.ended, now.total, [&] {
      StudyAnswers so_far;
      conclude(plan, *made, so_far);
      return so_far;
    });
  };
  StudyRuns runs(folder, maker, database, *executor, {show, [&] { return signals.caught(); }},
                 options.executor.retry);
  made = &runs;
  StudyAnswers answers;
  const auto finish = [&](StudyState state) {
    begin();
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
    if (!runs.asked().empty()) finish(StudyState::stopped);  // else no case of it is valid
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
  add_out_option(*command, options->folder, "folder for the results; default out/<study>");
  add_executor_options(*command, options->executor);
  command->callback([options] { study(*options); });
}

}  // namespace kerf
